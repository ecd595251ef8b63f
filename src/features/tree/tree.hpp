#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "features/path/block_facts.hpp"
#include "features/path/operation.hpp"
#include "features/tree/feature.hpp"
#include "features/tree/hole.hpp"

namespace kerf::features {

/// What the literal method found, in the order of the rows.
struct LiteralLayer {
  Span rows{};  ///< first and last that moves across
  double z = 0;
  std::uint32_t tool = 0;
  std::vector<Loop> loops{};
};
struct LiteralFeature {
  std::vector<std::size_t> layers{};  ///< places among the layers
  LiteralWord word{};
  Order order = Order::undefined;
};
struct LiteralHole {
  Vec2 at{};
  double z = 0;
  std::uint32_t tool = 0;
  std::uint32_t row = 0;  ///< the one that goes deepest
};
struct LiteralTree {
  std::vector<LiteralLayer> layers{};
  std::vector<LiteralFeature> features{};
  std::vector<LiteralHole> holes{};
};

/// A call that led to what was cut.
struct Call {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  base::BlockId block{};  ///< that calls
  CallWords words{};
  std::vector<std::size_t> features{};
  std::vector<std::size_t> holes{};
};

/// Rows at feed that are part of nothing.
struct Unrecognised {
  enum class Why : std::uint8_t {
    free_motion,
    rotary,
    probing,
    air,                  ///< where there is nothing to cut
    above_assumed_stock,  ///< above a blank that nobody has described
    budget                ///< time or memory were over
  };
  Why why = Why::free_motion;
  Span rows{};
  std::uint32_t moves = 0;
  double cut_mm = 0;
};

struct Disagreement {
  std::size_t feature = 0;
  std::string why{};
};

/// One operation as reports tell it.
struct OperationFacts {
  Operation operation{};
  double cut_mm = 0;
  double air_mm = 0;
  double spindle_rpm = 0;
  std::vector<double> cut_feeds{};  ///< in the order of their first use
  std::vector<double> entry_feeds{};
  std::optional<Span> visits{};  ///< from the first visit to the last, rows
};

/// All that was recognised in a recording; places are those in these lists.
struct Tree {
  std::vector<OperationFacts> operations{};
  std::vector<Feature> features{};
  std::vector<Hole> holes{};
  std::vector<Pattern> patterns{};
  std::vector<Call> calls{};
  LiteralTree literal{};
  std::vector<Disagreement> disagreements{};
  std::vector<Unrecognised> unrecognised{};
  std::string cut_short{};  ///< why it ends before all was recognised; empty: it does not
};

}  // namespace kerf::features
