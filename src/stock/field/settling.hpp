#pragma once

#include <array>

#include "stock/field/contact_rule.hpp"
#include "stock/field/ready_sweep.hpp"

namespace kerf::stock::field {

/// All that a sweep does over a block: where its edges and its parts go, whatever their order.
class Settling {
 public:
  /// Heights are over `base`.
  Settling(const ReadySweep& sweep, const BlockPoints& points, double base);

  /// What a part meets of a column.
  [[nodiscard]] Meeting meets(ToolPart part, std::size_t i, Span material) const;
  /// Lowest surface of the edges if they cut, else kNowhere.
  [[nodiscard]] double edges_low(std::size_t i) const { return edges_[i].low; }
  [[nodiscard]] double part_low(ToolPart part, std::size_t i) const {
    return parts_[index(part)].whole[i].low;
  }
  /// Signed distances of columns from the leg that cuts deepest there; 0 where there is none.
  [[nodiscard]] const BlockValues& offsets() const { return offsets_; }

 private:
  using Spans = std::array<Span, kBlockCells>;
  struct Part {
    Spans whole;
    BlockValues shrunk;
  };
  [[nodiscard]] bool reaches(const auto& leg, double reach) const;
  void add(const auto& leg, const LowerEnvelope& body, double top, Spans& spans) const;
  void add_edges(const auto& leg, const FieldTool::Part& edges);

  const ReadySweep& sweep_;
  BlockPoints points_;
  double base_;
  Spans edges_;
  std::array<Part, kToolParts> parts_;
  BlockValues offsets_{};
};

}  // namespace kerf::stock::field
