#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "stock/sweep/stretch.hpp"
#include "stock/sweep/sweep.hpp"
#include "stock/tool/tool_part.hpp"

namespace kerf::stock {

/// An amount that is added up in whole parts, so that neither the order nor the number of threads
/// changes the sum: 2⁻³² of the unit, up to ±2³¹ of it.
class Exact {
 public:
  constexpr Exact() = default;
  explicit Exact(double value);  ///< rounded to a part; what is out of range is clamped

  [[nodiscard]] double value() const;
  Exact& operator+=(Exact other) {
    parts_ += other.parts_;
    return *this;
  }
  /// sums[i] += Exact(times * values[i]). Precondition: no value is larger than `most`, none < 0.
  static void add(std::span<const double> values, double times, double most, Exact* sums);
  friend constexpr bool operator==(Exact, Exact) = default;
  friend constexpr auto operator<=>(Exact, Exact) = default;

 private:
  std::int64_t parts_ = 0;
};

/// Material that was met and should not have been.
struct Contact {
  double depth_mm = 0;  ///< of the deepest place, along the dexel; 0: there was none
  Vec3 at;              ///< that place, frame of the stock
  Exact volume;         ///< mm³ over all places

  [[nodiscard]] bool is_one() const { return depth_mm > 0; }
  /// Adds another one of the same kind. The deeper one keeps its place; of equals the one that has
  /// the smaller coordinates (x, then y, then z). Independent of the order.
  void add(const Contact& other);
};

/// What one sweep did. Contacts are deeper than twice the touch tolerance along the dexels, or
/// wider than a cell across them (Model::add_body()).
struct Outcome {
  static constexpr std::size_t kBins = 64;

  Exact removed;  ///< mm³, with what was met wrongly
  /// By part: of a cut what lies in the sweep of this part and not in that of the edges of the same
  /// sweep; of a rapid what lies in that of any part, the edges too.
  std::array<Contact, kToolParts> contacts{};
  /// Removed inside of the tool's core at its tip face (Body::core_mm), mm³.
  Exact core;
  /// Removed by signed distance s of the column from the way of the axis, seen along the feed, left
  /// positive, s from -R to R in equal bins; R is the widest edge. Of a way along the axis s is the
  /// distance from it. Straight and arc ways only.
  std::array<Exact, kBins> across{};
  /// Of the places that were removed there: s, and how high they lie along the tool's axis, mm. On
  /// stock of a lathe a tool on the axis has the radii for s, and there are no heights.
  Stretch aside;
  Stretch heights;
  /// Of stock of a lathe: area of its half section that was removed, mm².
  Exact section;
  /// Of threads (stock.md §4.5): what the insert met for the first time where its thread is, mm³ of
  /// the ring, and left there.
  Exact threaded;
  std::uint64_t visited = 0;  ///< columns or dexels that were compared

  void add(const Outcome& other);
  /// Something was met that should not have been.
  [[nodiscard]] bool has_contact() const;
};

}  // namespace kerf::stock
