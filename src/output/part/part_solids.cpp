#include "output/part/part_solids.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "output/part/internal/paints.hpp"
#include "stock/surface/pieces.hpp"

namespace kerf::output {
namespace {

SolidFile::Material material(std::string name, plot::Color color) {
  return {std::move(name), {color.red, color.green, color.blue}};
}

}  // namespace

SolidFile solid_file(const std::string& name, const StockFacts& facts,
                     const std::vector<stock::ToolSpan>& tools,
                     const stock::surface::Surface& part) {
  PartScene scene;
  scene.facts = &facts;
  scene.tools = tools;
  const plot::Paints paints(scene);
  SolidFile file;
  file.name = name;
  file.materials.push_back(material("uncut stock", plot::kUncut));
  for (std::size_t i = 0; i < facts.tools.size(); ++i) {
    const StockFacts::Tool& tool = facts.tools[i];
    file.materials.push_back(
        material(fmt::format("T{} {}", tool.did.tool, tool.type), paints.of_tool(i)));
  }
  for (stock::surface::Surface& surface : stock::surface::pieces_of(part)) {
    SolidPiece piece{std::move(surface), {}};
    for (const std::uint32_t owner : piece.surface.owners) {
      // Paints of fixtures and sections stand between the stock's and those of tools.
      const std::uint16_t paint = paints.of_motion(owner);
      piece.materials.push_back(paint > plot::Paints::kSection
                                    ? static_cast<std::uint16_t>(paint - plot::Paints::kSection)
                                    : std::uint16_t{0});
    }
    file.pieces.push_back(std::move(piece));
  }
  return file;
}

}  // namespace kerf::output
