#include "output/reports/stock_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/angle.hpp"
#include "output/reports/compared_report.hpp"
#include "output/reports/internal/places.hpp"
#include "output/reports/summary.hpp"
#include "output/writing/diagnostic_text.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using base::number_text;
using base::tidy;

std::string stock_json(const StockFacts& facts) {
  return JsonObject()
      .text("shape", facts.shape)
      .text("zero", facts.zero)
      .raw("origin", point_json(facts.origin, facts.turns))
      .raw("extents", bounds_json(facts.stock_extents, facts.turns))
      .number("volume_mm3", tidy(facts.stock_mm3))
      .done();
}

std::string model_json(const StockFacts::Model& model) {
  std::vector<double> cells(model.cells.begin(), model.cells.end());
  JsonObject object;
  object.text("kind", model.kind).raw("cell_mm", numbers_json(model.cell_mm));
  object.raw("cells", numbers_json(cells)).number("bytes", static_cast<double>(model.bytes));
  object.number("error_mm3", tidy(model.error_mm3)).number("visited", tidy(model.visited));
  if (!model.grids_mm3.empty()) object.raw("grids_mm3", numbers_json(model.grids_mm3));
  return object.text("reason", model.reason).done();
}

// What is not known is left out.
std::string most_json(const stock::ToolMost& most) {
  JsonObject object;
  const auto add = [&](const char* key, double value) {
    if (value > 0) object.number(key, tidy(value));
  };
  add("ae_mm", most.ae_mm);
  add("ap_mm", most.ap_mm);
  add("phi_deg", geometry::degrees(most.phi_rad));
  add("fz_mm", most.fz_mm);
  add("hm_mm", most.hm_mm);
  add("vc_m_min", most.vc_m_min);
  add("mrr_mm3_s", most.mrr_mm3_s);
  add("power_kw", most.power_kw);
  add("torque_nm", most.torque_nm);
  return object.done();
}

std::string tool_json(const StockFacts::Tool& tool) {
  JsonObject object;
  object.number("tool", tool.did.tool).text("type", tool.type).number("diameter", tool.diameter);
  object.text("source", tool.source).number("cut_mm", tidy(tool.did.cut_mm));
  object.number("cut_s", tidy(tool.did.cut_s)).number("air_mm", tidy(tool.did.air_mm));
  object.number("removed_mm3", tidy(tool.did.removed_mm3));
  if (std::isfinite(tool.did.lowest)) object.number("lowest", tidy(tool.did.lowest));
  return object.raw("max", most_json(tool.did.most)).done();
}

std::string finding_json(const StockFacts::Told& told, bool turns, const base::SourceSet& sources) {
  const stock::Finding& finding = told.finding;
  JsonObject object;
  object.text("severity", severity_name(told.diagnostic.severity))
      .text("code", told.diagnostic.number)
      .text("message", told.diagnostic.message)
      .text("file", file_name(told.diagnostic, sources))
      .number("line", told.diagnostic.place.line)
      .number("column", told.diagnostic.place.column)
      .text("program", told.diagnostic.program);
  object.number("tool", finding.tool).number("motion", static_cast<double>(finding.motion));
  object.number("time_s", tidy(told.finding.time_s)).raw("at", point_json(finding.at, turns));
  object.number("depth_mm", tidy(finding.depth_mm)).number("volume_mm3", tidy(finding.volume_mm3));
  return object.number("count", static_cast<double>(finding.count)).done();
}

std::string counts_json(const StockFacts& facts) {
  std::map<std::string, std::uint64_t> counts;
  for (const StockFacts::Told& told : facts.findings) ++counts[told.diagnostic.number];
  JsonObject object;
  for (const auto& [code, count] : counts) object.number(code, static_cast<double>(count));
  return object.done();
}

std::string assumed_json(const StockFacts& facts) {
  std::vector<std::string> items;
  for (const auto* const list : {&facts.assumed, &facts.run.assumed}) {
    for (const control::Assumption& assumption : *list) {
      items.push_back(
          JsonObject().number("line", assumption.line).text("what", assumption.what).done());
    }
  }
  return json_array(items);
}

std::string pieces_json(const StockFacts& facts) {
  std::vector<std::string> items;
  for (const stock::Piece& piece : facts.pieces) {
    items.push_back(JsonObject()
                        .number("volume_mm3", tidy(piece.volume_mm3))
                        .raw("extents", bounds_json(piece.extents, facts.turns))
                        .raw("held", piece.held ? "true" : "false")
                        .done());
  }
  return json_array(items);
}

std::string threads_json(const StockFacts& facts) {
  std::vector<std::string> items;
  for (const StockFacts::Thread& thread : facts.threads) {
    JsonObject object;
    object.number("line", thread.line).text("axis", std::string(1, thread.axis));
    object.number("from", tidy(thread.from)).number("to", tidy(thread.to));
    object.number("major", tidy(thread.major)).number("minor", tidy(thread.minor));
    object.number("pitch", tidy(thread.pitch)).number("starts", thread.starts);
    object.text("hand", thread.hand == stock::Hand::right ? "right" : "left");
    items.push_back(object.number("volume_mm3", tidy(thread.volume_mm3)).done());
  }
  return json_array(items);
}

std::string sheet_json(const StockFacts::Sheet& sheet) {
  std::vector<std::string> pieces;
  for (const StockFacts::Sheet::Piece& piece : sheet.pieces) {
    pieces.push_back(JsonObject()
                         .number("area_mm2", tidy(piece.area_mm2))
                         .raw("held", piece.is_held ? "true" : "false")
                         .done());
  }
  return JsonObject()
      .number("kerf_mm", tidy(sheet.kerf_mm))
      .number("cut_mm2", tidy(sheet.cut_mm2))
      .number("cut_mm", tidy(sheet.cut_mm))
      .number("piece_count", static_cast<double>(sheet.piece_count))
      .raw("pieces", json_array(pieces))
      .number("energy_j", tidy(sheet.energy_j))
      .number("peak_j_mm2", tidy(sheet.peak_j_mm2))
      .done();
}

}  // namespace

CheckedStock checked_stock(const StockFacts& facts, const base::SourceSet& sources) {
  std::vector<std::string> findings;
  for (const StockFacts::Told& told : facts.findings)
    findings.push_back(finding_json(told, facts.turns, sources));
  std::vector<std::string> not_checked;
  for (const std::string& what : facts.not_checked) not_checked.push_back(quoted(what));
  return {json_array(findings), counts_json(facts), json_array(not_checked)};
}

std::string stock_report_json(const StockFacts& facts, const base::SourceSet& sources) {
  std::vector<std::string> tools;
  for (const StockFacts::Tool& tool : facts.tools) tools.push_back(tool_json(tool));
  const CheckedStock checked = checked_stock(facts, sources);
  JsonObject object = head_of_report(facts.run);
  object.number("time_s", tidy(facts.run.time_s));
  object.raw("stock", stock_json(facts)).raw("model", model_json(facts.model));
  object.number("removed_mm3", tidy(facts.removed_mm3)).number("left_mm3", tidy(facts.left_mm3));
  object.raw("extents", bounds_json(facts.extents, facts.turns)).raw("pieces", pieces_json(facts));
  if (!facts.threads.empty()) object.raw("threads", threads_json(facts));
  object.raw("tools", json_array(tools)).raw("findings", checked.findings);
  object.raw("counts", checked.counts);
  if (facts.sheet) object.raw("sheet", sheet_json(*facts.sheet));
  if (facts.compare) object.raw("compare", compared_json(*facts.compare, facts.turns));
  if (facts.against) object.raw("against", against_json(*facts.against, facts.turns));
  object.raw("not_checked", checked.not_checked);
  object.raw("assumed", assumed_json(facts));
  return object.done() + "\n";
}

namespace {

constexpr std::size_t kToldPerCode = 5;
constexpr std::size_t kToldPieces = 5;

std::string tool_line(const StockFacts::Tool& tool) {
  const bool assumed = tool.source == "assumed" || tool.source == "offset";
  const std::string size = tool.diameter > 0 ? fmt::format(" D{:.4g}", tool.diameter) : "";
  return fmt::format(
      "  T{} {}{}{}: cuts {:.1f} mm in {:.1f} s, in air {:.1f} mm, removes {:.1f} mm³\n",
      tool.did.tool, tool.type, size, assumed ? " (" + tool.source + ")" : "", tool.did.cut_mm,
      tool.did.cut_s, tool.did.air_mm, tool.did.removed_mm3);
}

std::string sheet_lines(const StockFacts::Sheet& sheet) {
  std::string text = fmt::format(
      "  beam cuts {:.1f} mm, {:.2f} mm² with a kerf of {} mm; {:.1f} J, {:.2f} J/mm² at most\n",
      sheet.cut_mm, sheet.cut_mm2, number_text(tidy(sheet.kerf_mm)), sheet.energy_j,
      sheet.peak_j_mm2);
  text += fmt::format("  {} {}", sheet.piece_count, sheet.piece_count == 1 ? "piece" : "pieces");
  for (std::size_t i = 0; i < std::min(kToldPieces, sheet.pieces.size()); ++i) {
    const StockFacts::Sheet::Piece& piece = sheet.pieces[i];
    text += fmt::format("{} {:.2f} mm²{}", i == 0 ? ":" : ",", piece.area_mm2,
                        piece.is_held ? " held" : "");
  }
  return text + (sheet.pieces.size() > kToldPieces ? " …\n" : "\n");
}

std::string finding_lines(const StockFacts& facts, const base::SourceSet& sources) {
  std::map<std::string, std::vector<const StockFacts::Told*>> by_code;
  for (const StockFacts::Told& told : facts.findings)
    by_code[told.diagnostic.number].push_back(&told);
  std::string text;
  for (const auto& [code, all] : by_code) {
    text += fmt::format("  {}: {} {}\n", code, all.size(), all.size() == 1 ? "block" : "blocks");
    for (std::size_t i = 0; i < std::min(kToldPerCode, all.size()); ++i) {
      const base::Diagnostic& one = all[i]->diagnostic;
      const double time_s = all[i]->finding.time_s;
      text += fmt::format("    {}:{}{}: {}\n", printable(file_name(one, sources)), one.place.line,
                          time_s > 0 ? fmt::format(" at {:.3f} s", time_s) : "",
                          printable(one.message));
    }
  }
  return text;
}

}  // namespace

std::string stock_report_text(const StockFacts& facts, const base::SourceSet& sources) {
  const std::string cell =
      facts.model.cell_mm.empty() ? "" : fmt::format(" of {:.4g} mm", facts.model.cell_mm.front());
  std::string text =
      fmt::format("  stock {} at {}, {:.1f} mm³; {}{} ({})\n", printable(facts.shape), facts.zero,
                  facts.stock_mm3, facts.model.kind, cell, facts.model.reason);
  text += fmt::format("  removed {:.1f} mm³, left {:.1f} mm³\n", facts.removed_mm3, facts.left_mm3);
  for (const StockFacts::Tool& tool : facts.tools) text += tool_line(tool);
  if (facts.sheet) text += sheet_lines(*facts.sheet);
  if (facts.compare) text += compared_text(*facts.compare);
  if (facts.against) text += against_text(*facts.against);
  text += finding_lines(facts, sources);
  for (const std::string& what : facts.not_checked) text += "  not checked: " + what + "\n";
  for (const control::Assumption& assumption : facts.assumed)
    text += "  assumed: " + assumption.what + "\n";
  if (facts.findings.empty()) text += "  no findings\n";
  return text;
}

}  // namespace kerf::output
