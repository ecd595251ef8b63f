#include "job/facts_of_stock.hpp"

#include <algorithm>
#include <array>

#include "base/block_id.hpp"
#include "base/program_name.hpp"
#include "job/facts_of_run.hpp"

namespace kerf::job {
namespace {

bool is_warning(base::Code code) {
  using enum base::Code;
  constexpr std::array kWarnings{tap_without_hole, thread_pitch,     feed_per_tooth, cut_depth,
                                 cut_width,        cutting_speed,    cutting_power,  tool_length,
                                 stock_loose,      stock_zero_moved, stock_missed,   cell_enlarged,
                                 tool_import,      excess,           differs};
  return std::find(kWarnings.begin(), kWarnings.end(), code) != kWarnings.end();
}

/// The calls that led to a block, the innermost first, as alarms have them.
std::string callers_of(const base::BlockId& block, const control::Control& control) {
  std::string text;
  auto calls = control.calls(block.calls);
  for (auto call = calls.rbegin(); call != calls.rend(); ++call) {
    text += (text.empty() ? "called from line " : ", line ") + std::to_string(call->line) + " of " +
            base::program_name(static_cast<std::uint32_t>(call->program));
  }
  return text;
}

/// Where a block begins behind its blanks.
base::Place first_character(const base::BlockId& block, const base::SourceSet& sources) {
  base::Place place = base::place_of(block);
  if (!sources.contains(block.file)) return place;
  constexpr std::size_t kMostBlanks = 256;
  const std::size_t blanks =
      sources[block.file].line_at(block.from, kMostBlanks).find_first_not_of(" \t");
  if (blanks != std::string::npos) place.column += static_cast<std::uint32_t>(blanks);
  return place;
}

void take_sheet(const output::StockFacts::Sheet& sheet, output::StockFacts& facts) {
  facts.sheet = sheet;
  facts.removed_mm3 = sheet.cut_mm2 * sheet.thickness_mm;
  facts.left_mm3 = facts.stock_mm3 - facts.removed_mm3;
  stock::Bounds& all = facts.extents = {{0, 0, 0}, {-1, -1, -1}};
  for (const output::StockFacts::Sheet::Piece& piece : sheet.pieces) {
    const stock::Bounds& one = piece.extents;
    const bool is_first = facts.pieces.empty();
    facts.pieces.push_back({piece.area_mm2 * sheet.thickness_mm, one, piece.is_held});
    if (is_first) all = one;
    all.low = {std::min(all.low.x, one.low.x), std::min(all.low.y, one.low.y), one.low.z};
    all.high = {std::max(all.high.x, one.high.x), std::max(all.high.y, one.high.y), one.high.z};
  }
}

// stock.md §1.5: what cannot be checked for want of data is listed.
void list_limits(const StockResult& result, const stock::CuttingTool& tool,
                 std::vector<std::string>& not_checked) {
  const std::string name = "T" + std::to_string(tool.number());
  const stock::ToolLimits& limits = tool.tool.limits;
  const auto lacks = [&](bool is_known, const char* code, const char* what) {
    if (!is_known) not_checked.push_back(std::string(code) + ": " + name + " has no " + what);
  };
  const bool is_mill = !tool.tool.is_insert();
  const bool has_teeth = !is_mill || tool.tool.said(stock::Measure::flutes).has_value();
  if (limits == stock::ToolLimits{}) {
    not_checked.push_back("FEED_PER_TOOTH, CUT_DEPTH, CUT_WIDTH, CUTTING_SPEED: " + name +
                          " has no limits");
  } else {
    lacks(limits.fz.has_value(), "FEED_PER_TOOTH", "limits.fz");
    lacks(!limits.fz || has_teeth, "FEED_PER_TOOTH", "flutes");
    lacks(limits.ap.has_value(), "CUT_DEPTH", "limits.ap");
    lacks(!is_mill || limits.ae.has_value(), "CUT_WIDTH", "limits.ae");
    lacks(limits.vc.has_value(), "CUTTING_SPEED", "limits.vc");
  }
  if (result.knows_material && result.most_kw > 0) lacks(has_teeth, "CUTTING_POWER", "flutes");
  const bool turns = result.run->machine().definition().turns();
  if (is_mill && !turns)
    lacks(tool.tool.said(stock::Measure::length).has_value(), "TOOL_LENGTH", "length");
  const bool makes_threads =
      tool.tool.kind == stock::ToolKind::tap || tool.tool.kind == stock::ToolKind::threading;
  if (makes_threads)
    lacks(tool.tool.said(stock::Measure::pitch).has_value(), "THREAD_PITCH", "pitch");
}

// What the whole run lacks.
void list_unchecked(const StockResult& result, std::vector<std::string>& not_checked) {
  if (!result.model) return;
  if (!result.knows_stock) not_checked.emplace_back("RAPID_IN_STOCK: the stock is assumed");
  if (!result.knows_travel) {
    not_checked.emplace_back(
        "OT0500, OT0501: no work offset is set, so the program runs in machine coordinates");
  }
  if (!result.knows_material) {
    not_checked.emplace_back("CUTTING_POWER: the material is not known (--material)");
  } else if (!(result.most_kw > 0)) {
    not_checked.emplace_back("CUTTING_POWER: the machine file has no spindle.power_kw");
  }
}

void list_unchecked(const stock::CuttingTool& tool, std::vector<std::string>& not_checked) {
  const std::string name = "T" + std::to_string(tool.number());
  if (!tool.knows_shape()) {
    not_checked.push_back("RAPID_IN_STOCK: the shape of " + name + " is assumed");
    if (tool.tool.is_insert())
      not_checked.push_back("INSERT_COLLISION: the shape of " + name + " is assumed");
  }
  if (tool.tool.is_insert()) return;
  if (!tool.tool.said(stock::Measure::flute_length))
    not_checked.push_back("FLUTE_LENGTH: " + name + " has no flute_length");
  if (tool.tool.holder.empty() || !tool.tool.said(stock::Measure::stickout))
    not_checked.push_back("HOLDER_COLLISION: " + name + " has no holder");
}

}  // namespace

output::StockFacts::Told told(const stock::Finding& finding, const machine::BatchRun& run) {
  base::Diagnostic diagnostic =
      base::make_error(finding.code, first_character(finding.block, run.sources()), finding.detail);
  if (is_warning(finding.code)) diagnostic.severity = base::Severity::warning;
  if (finding.block.line > 0) {
    diagnostic.program = base::program_name(static_cast<std::uint32_t>(finding.block.program));
    diagnostic.block = finding.block;
    diagnostic.hint = callers_of(finding.block, run.control());
  } else {
    diagnostic.place = {.file = base::FileId{0}};
  }
  return {std::move(diagnostic), finding};
}

std::string title_of(const StockResult& result) {
  const machine::BatchRun& machine = result.run->machine();
  return title_of(machine) + " on " + machine.definition().name;
}

output::StockFacts facts_of(StockResult& result) {
  output::StockFacts facts;
  facts.run = facts_of(result.run->machine());
  if (result.is_stopped) facts.run.status = output::RunFacts::Status::stopped;
  facts.zero = name_of(result.zero);
  facts.origin = result.origin;
  facts.stock_extents = stock::bounds(result.shape);
  facts.stock_mm3 = stock::volume(result.shape);
  if (result.model) {
    // Of a stock that columns sample what is exact, so that removed and left make the whole.
    facts.removed_mm3 = result.model->stock_mm3() - result.model->left_mm3();
    facts.left_mm3 = std::max(0.0, facts.stock_mm3 - facts.removed_mm3);
    facts.extents = result.model->extents();
    facts.pieces = result.pieces;
  } else {
    take_sheet(*result.sheet_facts, facts);
  }
  facts.threads = result.threads;
  facts.turns = result.run->machine().definition().turns();
  facts.model = result.model_facts;
  facts.compare = result.compare;
  facts.against = result.against;
  facts.assumed = result.assumed;
  list_unchecked(result, facts.not_checked);
  if (!result.knows_stock && result.has_probed)
    facts.not_checked.push_back("G31: the stock is assumed, and no probe meets it");
  for (const stock::ToolRecord& did : result.tools) {
    const stock::CuttingTool& tool = result.rack->tool(did.tool);
    const double diameter_mm =
        tool.tool.said(stock::Measure::diameter).value_or(tool.diameter_mm());
    facts.tools.push_back({did, std::string(tool.tool.type_name()), diameter_mm,
                           std::string(word_of(tool.tool.source))});
    list_unchecked(tool, facts.not_checked);
    list_limits(result, tool, facts.not_checked);
  }
  for (const stock::Finding& finding : result.findings)
    facts.findings.push_back(told(finding, result.run->machine()));
  return facts;
}

}  // namespace kerf::job
