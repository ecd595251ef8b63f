#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "stock/sweep/body.hpp"

namespace kerf::stock {

/// A tool as a run cuts with it: its body, and what checks want to know of it.
struct CuttingTool {
  enum class Use : std::uint8_t {
    any_way,     ///< cuts along its axis and across
    axial_only,  ///< drill, tap, reamer
    probe        ///< cuts nothing
  };
  enum class Hand : std::uint8_t { right, left };

  std::uint32_t number = 0;
  std::string type;    ///< as tool files name it
  std::string source;  ///< file, machine, comment, offset, assumed
  Body body;
  double diameter_mm = 0;
  Use use = Use::any_way;
  std::optional<Hand> hand{};         ///< none: not known
  std::optional<double> length_mm{};  ///< gauge length
  bool knows_flutes = false;          ///< the end of its edges is not assumed
  bool knows_holder = false;
};

/// The tools of a run.
class ToolRack {
 public:
  virtual ~ToolRack() = default;
  /// Every number has a tool; the reference stays good.
  [[nodiscard]] virtual const CuttingTool& tool(std::uint32_t number) = 0;
};

}  // namespace kerf::stock
