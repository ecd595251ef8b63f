#include <algorithm>
#include <array>
#include <cmath>

#include "stock/saved/internal/packing.hpp"
#include "stock/saved/internal/part_format.hpp"
#include "stock/saved/internal/part_head.hpp"
#include "stock/saved/internal/unpacking.hpp"
#include "stock/saved/part_file.hpp"
#include "stock/saved/saved_dexels.hpp"
#include "stock/saved/saved_field.hpp"
#include "stock/saved/saved_turned.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::stock::saved {
namespace {

using Part = std::shared_ptr<const SavedPart>;
using TileState = dexel::TriDexel::TileState;

Bounds bounds_in(const PartHead& head) {
  const std::vector<double> box = head.box(3);
  return {{box[0], box[1], box[2]}, {box[3], box[4], box[5]}};
}

/// Columns, or cells, that a tile of a grid has along one axis.
int side_of(int tile, int count, int side) { return std::min(side, count - tile * side); }

void take_columns(const field::Grid& grid, std::size_t tile, std::string_view bytes,
                  std::vector<float>& into) {
  Unpacker numbers(bytes);
  const auto across = static_cast<std::size_t>(grid.tiles_x());
  const int i0 = static_cast<int>(tile % across) * field::kTileSide;
  const int j0 = static_cast<int>(tile / across) * field::kTileSide;
  for (int j = j0; j < std::min(grid.ny, j0 + field::kTileSide); ++j) {
    for (int i = i0; i < std::min(grid.nx, i0 + field::kTileSide); ++i)
      into[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.nx) +
           static_cast<std::size_t>(i)] = numbers.single();
  }
}

void check_columns(const field::FieldState& state) {
  const double size = state.grid.box.high.z - state.grid.box.low.z;
  for (std::size_t i = 0; i < state.heights.size(); ++i) {
    const float bottom = state.bottoms.empty() ? 0 : state.bottoms[i];
    const bool is_sound = bottom >= 0 && state.heights[i] >= bottom &&
                          static_cast<double>(state.heights[i]) <= size * (1 + 1e-6);
    if (!is_sound) throw damaged("a column that cannot be");
  }
}

Part read_field(const PartHead& head, double volume_mm3, PartUnpacker& unpacker) {
  const std::vector<int> cells = head.cells(2);
  field::FieldState state{{bounds_in(head), cells[0], cells[1]}, {}, {}};
  const bool has_bottoms = head.flag("bottoms");
  const double count = static_cast<double>(cells[0]) * cells[1];
  unpacker.hold(count * sizeof(float) * (has_bottoms ? 2 : 1));
  state.heights.resize(static_cast<std::size_t>(count));
  if (has_bottoms) state.bottoms.resize(static_cast<std::size_t>(count));
  const auto across = static_cast<std::size_t>(state.grid.tiles_x());
  for (std::size_t tile = 0; tile < state.grid.tiles(); ++tile) {
    const int wide = side_of(static_cast<int>(tile % across), cells[0], field::kTileSide);
    const int deep = side_of(static_cast<int>(tile / across), cells[1], field::kTileSide);
    const std::size_t size = static_cast<std::size_t>(wide * deep) * sizeof(float);
    Record record = unpacker.record();
    take_columns(state.grid, tile, record.take(size), state.heights);
    if (has_bottoms) take_columns(state.grid, tile, record.take(size), state.bottoms);
    record.finish();
  }
  check_columns(state);
  return std::make_shared<const SavedField>(std::move(state), volume_mm3);
}

TileState read_dexels(std::size_t dexels, PartUnpacker& unpacker) {
  Record record = unpacker.record();
  Unpacker counts(record.take(dexels * sizeof(std::uint16_t)));
  TileState tile;
  std::size_t ends = 0;
  for (std::size_t i = 0; i < dexels; ++i) {
    tile.counts.push_back(counts.word<std::uint16_t>());
    ends += tile.counts.back();
  }
  unpacker.hold(static_cast<double>(ends) * sizeof(dexel::DexelEnd));
  tile.ends.resize(ends);
  Unpacker places(record.take(ends * sizeof(float)));
  for (dexel::DexelEnd& end : tile.ends) end.at = places.single();
  Unpacker normals(record.take(2 * ends));
  for (dexel::DexelEnd& end : tile.ends) {
    for (std::int8_t& part : end.normal)
      part = static_cast<std::int8_t>(normals.word<std::uint8_t>());
  }
  record.finish();
  return tile;
}

Part read_tridexel(const PartHead& head, double volume_mm3, PartUnpacker& unpacker) {
  constexpr int kSide = dexel::Lattice::kTile;
  constexpr double kBytesOfDexel = 10;  // its number of ends, and its place in a model
  const std::vector<int> cells = head.cells(3);
  dexel::TriDexel::State state{bounds_in(head), {cells[0], cells[1], cells[2]}, {}, volume_mm3};
  for (std::size_t grid = 0; grid < 3; ++grid) {
    const int columns = cells[(grid + 1) % 3];
    const int rows = cells[(grid + 2) % 3];
    unpacker.hold(static_cast<double>(columns) * rows * kBytesOfDexel);
    for (int row = 0; row * kSide < rows; ++row) {
      for (int column = 0; column * kSide < columns; ++column) {
        const auto count = static_cast<std::size_t>(side_of(column, columns, kSide)) *
                           static_cast<std::size_t>(side_of(row, rows, kSide));
        state.tiles[grid].push_back(read_dexels(count, unpacker));
      }
    }
  }
  if (!dexel::TriDexel::of(state, 0)) throw damaged("a dexel that cannot be");
  return std::make_shared<const SavedDexels>(std::move(state));
}

contour::Contour read_loop(std::size_t vertices, Record& record) {
  Unpacker numbers(record.take(vertices * 3 * sizeof(double)));
  contour::Contour loop;
  for (std::size_t i = 0; i < vertices; ++i) {
    const double u = numbers.number();
    const double v = numbers.number();
    loop.vertices.push_back({{u, v}, numbers.number(), 0});
  }
  // One that goes below the axis would be another part as soon as it has a model.
  const bool is_sound = contour::is_sound(loop) && vertices >= 2 &&
                        contour::extents(loop).low.v >= -turned::kOnAxis_mm;
  if (!is_sound) throw damaged("a contour that cannot be");
  return loop;
}

Part read_turned(const PartHead&, double volume_mm3, PartUnpacker& unpacker) {
  Record record = unpacker.record();
  const auto loops = Unpacker(record.take(4)).word<std::uint32_t>();
  contour::Region region;
  for (std::uint32_t i = 0; i < loops; ++i) {
    const auto vertices = Unpacker(record.take(4)).word<std::uint32_t>();
    unpacker.hold(static_cast<double>(vertices) * sizeof(contour::Vertex) +
                  sizeof(contour::Contour));
    region.loops.push_back(read_loop(vertices, record));
  }
  record.finish();
  // Loops may go round nothing, or round what lies below the axis.
  if (!(turned::TurnedPart(region).left_mm3() > 0)) throw damaged("nothing is left of it");
  return std::make_shared<const SavedTurned>(std::move(region), volume_mm3);
}

SheetCut read_cut(Unpacker& numbers) {
  SheetCut cut;
  sheet::Trace& way = cut.way;
  bool is_sound = true;
  for (double* const value :
       {&way.from.u, &way.from.v, &way.to.u, &way.to.v, &way.radius, &way.centre.u, &way.centre.v,
        &way.middle.u, &way.middle.v, &way.cos_half, &way.turn_rad, &cut.kerf_mm}) {
    *value = numbers.number();
    is_sound = is_sound && std::fabs(*value) <= kFarthest_mm;
  }
  if (!is_sound || way.radius < 0 || !(cut.kerf_mm > 0)) throw damaged("a way that cannot be");
  return cut;
}

SheetState::Tile read_sheet_tile(std::uint32_t number, bool has_energy, PartUnpacker& unpacker) {
  Record record = unpacker.record();
  SheetState::Tile tile;
  tile.number = number;
  unpacker.hold(sizeof tile + (has_energy ? sizeof *tile.energy : 0));
  const std::string_view cells = record.take(sheet::kTileCells);
  std::transform(cells.begin(), cells.end(), tile.coverage.begin(),
                 [](char cell) { return static_cast<std::uint8_t>(cell); });
  if (has_energy) {
    tile.energy = std::make_unique<sheet::Sheet::Energy>();
    Unpacker numbers(record.take(sizeof *tile.energy));
    for (float& cell : *tile.energy) {
      cell = numbers.single();
      if (!(cell >= 0 && std::isfinite(cell))) throw damaged("an energy that cannot be");
    }
  }
  record.finish();
  return tile;
}

Part read_sheet(const PartHead& head, double volume_mm3, PartUnpacker& unpacker) {
  const std::vector<double> box = head.box(2);
  const std::vector<int> cells = head.cells(2);
  SheetState state;
  state.grid = {{{box[0], box[1]}, {box[2], box[3]}}, cells[0], cells[1]};
  state.thickness_mm = head.number("thickness_mm", 1e-6, kFarthest_mm);
  const bool has_energy = head.flag("energy");
  unpacker.hold(static_cast<double>(state.grid.tiles()) * sizeof(std::uint32_t));
  for (std::uint32_t number = unpacker.number(); number != kNoTile; number = unpacker.number()) {
    const bool rises = state.tiles.empty() || number > state.tiles.back().number;
    if (!rises || number >= state.grid.tiles()) throw damaged("a tile that cannot be");
    state.tiles.push_back(read_sheet_tile(number, has_energy, unpacker));
  }
  Record record = unpacker.record();
  constexpr std::size_t kBytesOfCut = 12 * sizeof(double);
  const int ways = head.count("ways", 1e9);
  for (int i = 0; i < ways; ++i) {
    unpacker.hold(sizeof(SheetCut));
    Unpacker numbers(record.take(kBytesOfCut));
    state.cuts.push_back(read_cut(numbers));
  }
  record.finish();
  return std::make_shared<const SavedSheet>(std::move(state), volume_mm3);
}

struct PartKind {
  std::string_view model;
  Part (*read)(const PartHead& head, double volume_mm3, PartUnpacker& unpacker);
};
constexpr std::array<PartKind, 4> kKinds = {{{"zmap", read_field},
                                             {"tridexel", read_tridexel},
                                             {"profile", read_turned},
                                             {"sheet", read_sheet}}};

ReadPart read_all(const GiveBytes& give, std::size_t most_bytes) {
  PartUnpacker unpacker(give, most_bytes);
  const PartHead head(unpacker.head());
  ReadPart read{.label = head.label(), .part = nullptr};
  const std::string model = head.text("model");
  const auto* const kind = std::find_if(kKinds.begin(), kKinds.end(),
                                        [&](const auto& each) { return each.model == model; });
  if (kind == kKinds.end()) throw damaged("it has no model that this Kerf knows");
  read.part = kind->read(head, read.label.volume_mm3, unpacker);
  unpacker.finish();
  return read;
}

}  // namespace

base::Outcome<ReadPart> read_part(const GiveBytes& give, std::size_t most_bytes) {
  try {
    return read_all(give, most_bytes);
  } catch (const WrongPart& wrong) {
    return tl::unexpected(base::Failure{base::Failure::Kind::input, wrong.what});
  }
}

bool is_saved_part(std::string_view head) { return head.starts_with(kFamily); }

}  // namespace kerf::stock::saved
