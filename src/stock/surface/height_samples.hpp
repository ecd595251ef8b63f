#pragma once

#include <optional>

#include "stock/field/columns.hpp"
#include "stock/surface/samples.hpp"

namespace kerf::stock::surface {

/// A height field as samples: its columns, or each `stride`-th of each axis, and as many points
/// along Z as cells of that size take. What the field does not hold is told from its neighbours:
///
/// - Tops and bottoms lean as the smoother of their two sides does, so a slope ends in an edge.
/// - Where a slope goes on from column to column, the surface between two lies on their line.
/// - A drop that no slope explains is a wall. It stands between the columns, half a cell from each;
///   where it goes on from row to row it is drawn through the mean of up to nine of these places,
///   which makes curved walls smooth, never farther than half a cell from its own.
class HeightSamples final : public Samples {
 public:
  /// The columns outlive the samples. Precondition: stride >= 1.
  explicit HeightSamples(const field::Columns& columns, int stride = 1);

  void fill(Signs& signs) const override;
  [[nodiscard]] Crossing crossing(int axis, Place from, bool from_inside) const override;

 private:
  enum class Side : bool { bottom, top };
  struct Column {
    double low = 0;
    double high = 0;
    std::uint32_t owner = 0;

    [[nodiscard]] double at(Side side) const { return side == Side::top ? high : low; }
  };
  /// Where a wall is looked at: the line between a point and the next one along an axis.
  struct Line {
    int axis;
    int across;  ///< the other horizontal axis
    Place from;
    bool from_inside;
  };

  [[nodiscard]] std::optional<Column> column(int i, int j) const;
  [[nodiscard]] std::optional<Column> column(Place at) const { return column(at[0], at[1]); }
  /// The motion that cut a column, also where it left nothing; 0: none, or there is no column.
  [[nodiscard]] std::uint32_t owner(Place at) const;
  [[nodiscard]] bool inside(Place at) const;
  [[nodiscard]] double slope(Place at, int axis, Side side) const;
  [[nodiscard]] Vec3 normal(double along_x, double along_y, Side side) const;
  [[nodiscard]] Crossing face(Place at, Side side) const;
  [[nodiscard]] std::optional<Crossing> on_slope(const Line& line, Place in, Place out,
                                                 Side side) const;
  [[nodiscard]] Crossing wall(const Line& line) const;
  [[nodiscard]] bool is_step(const Line& line) const;
  [[nodiscard]] bool is_border(const Line& line) const;
  [[nodiscard]] std::optional<int> goes_on(const Line& line, int row, int edge) const;

  const field::Columns& columns_;
  std::array<std::vector<int>, 2> numbers_;  ///< of columns, by points; -1: outside
  std::array<double, 2> cells_{};
};

}  // namespace kerf::stock::surface
