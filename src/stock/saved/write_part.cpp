#include <algorithm>
#include <nlohmann/json.hpp>

#include "stock/dexel/tri_dexel.hpp"
#include "stock/field/height_field.hpp"
#include "stock/saved/internal/packing.hpp"
#include "stock/saved/internal/part_format.hpp"
#include "stock/saved/part_file.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::stock::saved {
namespace {

using field::Columns;
using Json = nlohmann::ordered_json;

Json box_json(const Bounds& box) {
  return {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z};
}

Json thread_json(const turned::TurnedThread& thread) {
  return {{"axis", std::string(1, thread.axis)},
          {"from", thread.from},
          {"to", thread.to},
          {"major", thread.major},
          {"minor", thread.minor},
          {"pitch", thread.pitch},
          {"starts", thread.starts},
          {"inside", thread.is_inside},
          {"volume_mm3", thread.volume_mm3}};
}

/// The head of a file; `model` has what only this kind of model needs.
std::string head_of(const PartLabel& label, const Json& model) {
  Json head = model;
  head["zero"] = label.zero;
  head["volume_mm3"] = label.volume_mm3;
  const std::size_t dropped = label.made_by.size() - std::min(label.made_by.size(), kMostPrograms);
  head["made_by"] = Json::array();
  for (std::size_t i = dropped; i < label.made_by.size(); ++i)
    head["made_by"].push_back(label.made_by[i]);
  if (!label.threads.empty()) head["threads"] = Json::array();
  for (const turned::TurnedThread& thread : label.threads)
    head["threads"].push_back(thread_json(thread));
  return head.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Heights, or bottoms, of the columns of a tile by rows along X.
template <typename Value>
void put_tile(const field::Grid& grid, std::size_t tile, Value&& value, std::string& out) {
  const int across = grid.tiles_x();
  const int i0 = static_cast<int>(tile) % across * field::kTileSide;
  const int j0 = static_cast<int>(tile) / across * field::kTileSide;
  for (int j = j0; j < std::min(grid.ny, j0 + field::kTileSide); ++j) {
    for (int i = i0; i < std::min(grid.nx, i0 + field::kTileSide); ++i) put(out, value(i, j));
  }
}

void write_field(const PartLabel& label, const Columns& columns, PartPacker& packer) {
  const field::Grid& grid = columns.grid();
  packer.head(head_of(label, {{"model", "zmap"},
                              {"box", box_json(grid.box)},
                              {"cells", {grid.nx, grid.ny}},
                              {"bottoms", columns.has_bottoms()}}));
  std::string bytes;
  for (std::size_t tile = 0; tile < grid.tiles(); ++tile) {
    bytes.clear();
    put_tile(
        grid, tile, [&](int i, int j) { return columns.height(i, j); }, bytes);
    if (columns.has_bottoms())
      put_tile(
          grid, tile, [&](int i, int j) { return columns.bottom(i, j); }, bytes);
    packer.record(bytes);
  }
}

void put_dexels(const dexel::Tile& tile, std::string& bytes) {
  for (std::size_t i = 0; i < tile.count(); ++i)
    put_word(bytes, static_cast<std::uint16_t>(tile.ends(i).size()));
  for (std::size_t i = 0; i < tile.count(); ++i) {
    for (const dexel::DexelEnd& end : tile.ends(i)) put(bytes, end.at);
  }
  for (std::size_t i = 0; i < tile.count(); ++i) {
    for (const dexel::DexelEnd& end : tile.ends(i)) {
      for (const std::int8_t part : end.normal) put_word(bytes, static_cast<std::uint8_t>(part));
    }
  }
}

void write_dexels(const PartLabel& label, const dexel::TriDexel& model, PartPacker& packer) {
  packer.head(head_of(
      label, {{"model", "tridexel"}, {"box", box_json(model.box())}, {"cells", model.cells()}}));
  std::string bytes;
  for (int grid = 0; grid < 3; ++grid) {
    for (std::size_t tile = 0; tile < model.tiles(grid); ++tile) {
      bytes.clear();
      put_dexels(model.tile(grid, tile), bytes);
      packer.record(bytes);
    }
  }
}

void write_turned(const PartLabel& label, const contour::Region& region, PartPacker& packer) {
  packer.head(head_of(label, {{"model", "profile"}}));
  std::string bytes;
  put_word(bytes, static_cast<std::uint32_t>(region.loops.size()));
  for (const contour::Contour& loop : region.loops) {
    put_word(bytes, static_cast<std::uint32_t>(loop.vertices.size()));
    for (const contour::Vertex& vertex : loop.vertices) {
      for (const double value : {vertex.point.u, vertex.point.v, vertex.bulge}) put(bytes, value);
    }
  }
  packer.record(bytes);
}

void put_cut(const SheetCut& cut, std::string& bytes) {
  const sheet::Trace& way = cut.way;
  for (const double value :
       {way.from.u, way.from.v, way.to.u, way.to.v, way.radius, way.centre.u, way.centre.v,
        way.middle.u, way.middle.v, way.cos_half, way.turn_rad, cut.kerf_mm})
    put(bytes, value);
}

}  // namespace

void write_part(const PartLabel& label, const Model& model, const TakeBytes& take) {
  PartPacker packer(take);
  if (const auto* const field = dynamic_cast<const field::HeightField*>(&model)) {
    write_field(label, field->columns(), packer);
  } else if (const auto* const dexels = dynamic_cast<const dexel::TriDexel*>(&model)) {
    write_dexels(label, *dexels, packer);
  } else if (const auto* const part = dynamic_cast<const turned::TurnedPart*>(&model)) {
    write_turned(label, part->region(), packer);
  }
  packer.finish();
}

void write_part(const PartLabel& label, const SheetPart& part, const TakeBytes& take) {
  const sheet::Grid& grid = part.sheet.grid();
  const bool has_energy = part.sheet.settings().spot_mm > 0;
  PartPacker packer(take);
  packer.head(
      head_of(label, {{"model", "sheet"},
                      {"box", {grid.box.low.u, grid.box.low.v, grid.box.high.u, grid.box.high.v}},
                      {"thickness_mm", part.thickness_mm},
                      {"cells", {grid.nx, grid.ny}},
                      {"energy", has_energy},
                      {"ways", part.cuts.size()}}));
  std::string bytes;
  for (std::size_t tile = 0; tile < grid.tiles(); ++tile) {
    const sheet::Sheet::Coverage* const coverage = part.sheet.coverage(tile);
    if (coverage == nullptr) continue;
    bytes.assign(coverage->begin(), coverage->end());
    if (has_energy) {
      for (const float cell : *part.sheet.energy(tile)) put(bytes, cell);
    }
    packer.number(static_cast<std::uint32_t>(tile));
    packer.record(bytes);
  }
  packer.number(kNoTile);
  bytes.clear();
  for (const SheetCut& cut : part.cuts) put_cut(cut, bytes);
  packer.record(bytes);
  packer.finish();
}

}  // namespace kerf::stock::saved
