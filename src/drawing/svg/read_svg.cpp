#include "drawing/svg/read_svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drawing/svg/internal/drawer.hpp"
#include "drawing/svg/internal/expansion.hpp"
#include "drawing/svg/internal/xml_reader.hpp"

namespace kerf::drawing {
namespace {

/// Clones of long paths need memory, however few they are.
constexpr std::uint64_t kBytesAnEntity = 64;
constexpr std::uint64_t kLeastClonedBytes = 64U << 20U;

/// Told before anything is drawn: it would take minutes until the budget ends it.
bool is_too_much(const svg::Tree& tree, Canvas& canvas) {
  const std::uint64_t most = canvas.reading().max_entities;
  const svg::Expansion expansion = svg::expansion_of(tree);
  const bool has_bytes =
      expansion.cloned_bytes > std::max(kLeastClonedBytes, kBytesAnEntity * most);
  if (expansion.elements <= most && !has_bytes) return false;
  canvas.find(base::Severity::error, base::Code::draw_limit, {},
              expansion.elements > most ? fmt::format("more than {}", most)
                                        : "its clones repeat too much path data");
  return true;
}

}  // namespace

void read_svg(const base::SourceFile& file, base::FileId id, Canvas& canvas,
              const std::string& folder) {
  canvas.begin_file(id, "svg");
  const svg::Tree tree = svg::read_tree(file, canvas);
  if (tree.size() == 0 || is_too_much(tree, canvas)) return;
  svg::Drawer(tree, canvas, folder).draw();
}

}  // namespace kerf::drawing
