#include "face/server/transport/asset_table.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "base/decimal.hpp"

extern "C" {
extern const char kerf_page_begin[];
extern const char kerf_page_end[];
}

namespace kerf::server {
namespace {

struct Line {
  std::array<std::string_view, 4> fields;
  std::uint64_t bytes = 0;
};

std::optional<Line> parse_line(std::string_view text) {
  Line line;
  for (std::size_t i = 0; i < line.fields.size(); ++i) {
    const auto* const tab = std::find(text.begin(), text.end(), '\t');
    line.fields[i] = std::string_view(text.begin(), tab);
    text = std::string_view(tab == text.end() ? tab : tab + 1, text.end());
  }
  const auto bytes = base::read_whole_number(line.fields[3]);
  if (!bytes) return std::nullopt;
  line.bytes = *bytes;
  return line;
}

}  // namespace

AssetTable::AssetTable(std::string_view pack) {
  const std::size_t head = pack.find("\n\n");
  if (head == std::string_view::npos) return;
  std::string_view lines = pack.substr(0, head + 1);
  std::string_view blobs = pack.substr(head + 2);
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    if (end == std::string_view::npos) return;
    const auto line = parse_line(lines.substr(0, end));
    lines.remove_prefix(end + 1);
    if (!line || line->bytes > blobs.size()) return;
    const auto bytes = static_cast<std::size_t>(line->bytes);
    assets_.push_back({std::string(line->fields[0]), std::string(line->fields[1]),
                       std::string(line->fields[2]), blobs.substr(0, bytes)});
    blobs.remove_prefix(bytes);
  }
}

const Asset* AssetTable::find(std::string_view path) const {
  const auto found = std::find_if(assets_.begin(), assets_.end(),
                                  [&](const Asset& asset) { return asset.path == path; });
  return found == assets_.end() ? nullptr : &*found;
}

std::string_view embedded_page() {
  return {kerf_page_begin, static_cast<std::size_t>(kerf_page_end - kerf_page_begin)};
}

}  // namespace kerf::server
