#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "base/result.hpp"
#include "machine/definition/mesh_file.hpp"
#include "stock/cutting/workpiece.hpp"

namespace kerf::machine {

/// A shape around what the program cuts, by a margin, mm.
struct StockAround {
  double margin_mm = 5;
};

/// A shape in a file, STL or KSTOCK.
struct StockFile {
  std::string path;
  MeshUnit unit = MeshUnit::mm;  ///< of an STL
};

/// A bar on a lathe: about the axis of its spindle, X as a diameter.
struct StockBar {
  double diameter = 0;
  double z0 = 0;
  double z1 = 0;  ///< > z0
  double inner_diameter = 0;
};

/// A sheet under a laser; its top lies at the Z of its zero.
struct StockSheet {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;
  double thickness = 1;
};

using StockWord = std::variant<StockAround, stock::Workpiece, StockBar, StockSheet, StockFile>;

/// What `--stock` and `--fixture` take (docs/stock.md): box:X0,Y0,Z0,X1,Y1,Z1,
/// cylinder:AXIS,U,V,W0,W1,D, tube:…,DI, bar:D,Z0,Z1[,DI], sheet:X0,Y0,X1,Y1,T, extents[:M], or a
/// path. Failure (usage): `option` and what is wrong.
[[nodiscard]] base::Outcome<StockWord> stock_word(std::string_view text, const std::string& option);

/// Where the stock stands (`--stock-zero`).
struct StockZero {
  enum class Kind : std::uint8_t {
    automatic,  ///< the work system in force at the first move that cuts
    machine,    ///< the machine's zero
    system      ///< one of the work coordinate systems
  };
  Kind kind = Kind::automatic;
  std::uint32_t index = 0;     ///< 0 to 5: G54 to G59
  std::uint32_t extended = 0;  ///< 1 to 300: G54.1 P; 0: one of the six
  friend bool operator==(const StockZero&, const StockZero&) = default;
};

/// G54 to G59, G54.1P1 to G54.1P300, machine, auto. Failure (usage): `option` and what is wrong.
[[nodiscard]] base::Outcome<StockZero> stock_zero(std::string_view text, const std::string& option);
/// The other way round.
[[nodiscard]] std::string name_of(const StockZero& zero);

}  // namespace kerf::machine
