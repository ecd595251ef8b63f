#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "stock/tool/measure.hpp"

namespace kerf::stock {

struct CuttingShape;
struct Tool;

enum class ToolKind : std::uint8_t {
  flat,
  ball,
  bull,
  chamfer,
  engrave,
  drill,
  centre_drill,
  reamer,
  tap,
  face,
  t_slot,
  dovetail,
  lollipop,
  thread_mill,
  boring,
  form,
  probe,
  turning,
  boring_bar,
  grooving,
  parting,
  face_grooving,
  threading,
};

/// A key that a kind of tools has besides those that all have.
struct KindKey {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  Measure measure;
  bool is_needed = false;
  double otherwise = kNone;  ///< where nothing is said; kNone: it is not known then

  [[nodiscard]] bool has_default() const { return otherwise == otherwise; }
};

/// How the face of a kind of tools cuts where it goes down.
enum class CentreCutting : std::uint8_t {
  yes,
  no,     ///< Tool::core_mm() says up to where
  said,   ///< only the tool's own words tell
  never,  ///< it cuts nothing
};

/// What there is to know about a kind (stock.md §1.2, §1.3): a row a kind.
struct KindRow {
  ToolKind kind;
  std::span<const std::string_view> names;  ///< the first is its own
  CentreCutting centre = CentreCutting::yes;
  bool is_axial = false;  ///< cuts along its axis alone: drill, reamer, tap
  /// Its cutting part, or a sentence why there cannot be such a tool. Null: it is an insert.
  tl::expected<CuttingShape, std::string> (*shape)(const Tool& tool) = nullptr;
  std::vector<KindKey> keys{};

  [[nodiscard]] bool is_insert() const { return shape == nullptr; }
  /// Null: it has no such key of its own.
  [[nodiscard]] const KindKey* key(Measure measure) const;
};

/// Whether a tool of any kind may have it.
[[nodiscard]] bool is_common(Measure measure);

[[nodiscard]] std::span<const KindRow> kind_rows();
[[nodiscard]] const KindRow& row_of(ToolKind kind);

/// A kind by one of its names, and that name; the text stays. Null row: there is none.
struct NamedKind {
  const KindRow* row = nullptr;
  std::string_view name;
};
[[nodiscard]] NamedKind kind_named(std::string_view name);

}  // namespace kerf::stock
