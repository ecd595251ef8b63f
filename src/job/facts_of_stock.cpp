#include "job/facts_of_stock.hpp"

#include <algorithm>

#include "base/block_id.hpp"
#include "base/program_name.hpp"
#include "job/facts_of_run.hpp"

namespace kerf::job {
namespace {

bool is_warning(base::Code code) {
  using base::Code;
  return code == Code::stock_missed || code == Code::stock_zero_moved ||
         code == Code::cell_enlarged;
}

output::StockFacts::Told told(const stock::Finding& finding, double time_s) {
  base::Diagnostic diagnostic =
      base::make_error(finding.code, base::place_of(finding.block), finding.detail);
  if (is_warning(finding.code)) diagnostic.severity = base::Severity::warning;
  if (finding.block.line > 0) {
    diagnostic.program = base::program_name(static_cast<std::uint32_t>(finding.block.program));
    diagnostic.block = finding.block;
  } else {
    diagnostic.place = {.file = base::FileId{0}};
  }
  return {std::move(diagnostic), finding, time_s};
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

output::StockFacts facts_of(StockResult& result) {
  output::StockFacts facts;
  facts.run = facts_of(result.run->machine());
  facts.zero = name_of(result.zero);
  facts.origin = result.origin;
  facts.stock_extents = stock::bounds(result.shape);
  facts.stock_mm3 = stock::volume(result.shape);
  if (result.model) {
    // Of a stock that columns sample what is exact, so that removed and left make the whole.
    facts.removed_mm3 = result.model->stock_mm3() - result.model->left_mm3();
    facts.left_mm3 = std::max(0.0, facts.stock_mm3 - facts.removed_mm3);
    facts.extents = result.model->extents();
    facts.pieces = result.model->pieces();
  } else {
    take_sheet(*result.sheet_facts, facts);
  }
  facts.threads = result.threads;
  facts.turns = result.run->machine().definition().turns();
  facts.model = result.model_facts;
  facts.assumed = result.assumed;
  if (!result.knows_stock && result.model)
    facts.not_checked.push_back("RAPID_IN_STOCK: the stock is assumed");
  for (const stock::ToolRecord& did : result.tools) {
    const stock::CuttingTool& tool = result.rack->tool(did.tool);
    facts.tools.push_back({did, std::string(tool.tool.type_name()), tool.diameter_mm(),
                           std::string(word_of(tool.tool.source))});
    list_unchecked(tool, facts.not_checked);
  }
  for (std::size_t i = 0; i < result.findings.size(); ++i)
    facts.findings.push_back(told(result.findings[i], result.times_s[i]));
  return facts;
}

}  // namespace kerf::job
