#include "stock/tool/tool.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/decimal.hpp"
#include "stock/tool/insert_code.hpp"
#include "stock/tool/internal/tool_body.hpp"

namespace kerf::stock {
namespace {

using M = Measure;

bool belongs(const Tool& tool, M measure) {
  return is_common(measure) || measure == M::diameter || row_of(tool.kind).key(measure) != nullptr;
}

std::string article(std::string_view type) { return "a tool of type " + std::string(type); }

// A corner radius of 0 is none, which every tool has.
std::string objection_to_keys(const Tool& tool) {
  for (const MeasureRow& row : measure_rows()) {
    const auto value = tool.measures.get(row.measure);
    if (!value) continue;
    const std::string name(row.name);
    if (!row.takes(*value)) return name + " is " + row.in_words();
    const bool is_none = row.measure == M::corner_radius && *value == 0;
    if (!belongs(tool, row.measure) && !is_none)
      return article(tool.type_name()) + " has no " + name;
  }
  for (const KindKey& key : row_of(tool.kind).keys) {
    const auto value = tool.value(key.measure);
    const bool is_missing = key.is_needed && (!value || *value == 0);
    if (is_missing)
      return article(tool.type_name()) + " needs its " + std::string(row_of(key.measure).name);
  }
  return {};
}

/// ISO 261, coarse series: from this nominal diameter on.
struct CoarsePitch {
  double diameter;
  double pitch;
};
constexpr std::array<CoarsePitch, 21> kCoarse = {
    {{64, 6},   {56, 5.5}, {48, 5},     {42, 4.5}, {36, 4},     {30, 3.5},   {24, 3},
     {18, 2.5}, {14, 2},   {12, 1.75},  {10, 1.5}, {8, 1.25},   {6, 1},      {5, 0.8},
     {4, 0.7},  {3, 0.5},  {2.5, 0.45}, {2, 0.4},  {1.6, 0.35}, {1.2, 0.25}, {0, 0.2}}};

// Rounding and units leave a nominal diameter a little smaller than it is.
double coarse_pitch(double diameter) {
  const auto* const row =
      std::find_if(kCoarse.begin(), kCoarse.end(),
                   [&](const CoarsePitch& each) { return diameter >= each.diameter - 0.01; });
  return row == kCoarse.end() ? kCoarse.back().pitch : row->pitch;
}

std::optional<double> ring_core_mm(const Tool& tool) {
  const auto d = tool.value(M::diameter);
  switch (tool.kind) {
    case ToolKind::face: return 0.3 * *d;
    case ToolKind::boring: return *d / 2 - tool[M::width];
    default: break;
  }
  const auto neck = tool.said(M::neck_diameter);
  return neck ? std::optional(*neck / 2) : std::nullopt;
}

}  // namespace

std::string_view word_of(ToolSource source) {
  switch (source) {
    case ToolSource::file: return "file";
    case ToolSource::machine: return "machine";
    case ToolSource::comment: return "comment";
    case ToolSource::offset: return "offset";
    case ToolSource::assumed: return "assumed";
  }
  return {};
}

std::optional<double> Tool::said(Measure measure) const {
  if (const auto value = measures.get(measure)) return value;
  if (insert.empty()) return {};
  const auto code = read_insert_code(insert);
  return code ? code->measures.get(measure) : std::nullopt;
}

std::optional<double> Tool::value(Measure measure) const {
  if (const auto value = said(measure)) return value;
  if (measure == M::pitch && kind == ToolKind::tap)
    return coarse_pitch(said(M::diameter).value_or(0));
  const KindKey* const key = row_of(kind).key(measure);
  return key != nullptr && key->has_default() ? std::optional(key->otherwise) : std::nullopt;
}

double Tool::operator[](Measure measure) const {
  const auto known = value(measure);
  assert(known);
  return known.value_or(0);
}

std::string_view Tool::type_name() const {
  return type.empty() ? row_of(kind).names.front() : type;
}

std::optional<double> Tool::core_mm() const {
  if (centre_cutting.value_or(false)) return 0;
  if (const auto core = said(M::core_diameter)) return *core / 2;
  const CentreCutting usual = row_of(kind).centre;
  if (!centre_cutting && usual == CentreCutting::yes) return 0;
  return usual == CentreCutting::no ? ring_core_mm(*this) : std::nullopt;
}

std::string objection(const Tool& tool) {
  if (!tool.insert.empty()) {
    if (!tool.is_insert()) return article(tool.type_name()) + " has no insert";
    if (const auto code = read_insert_code(tool.insert); !code) return code.error();
  }
  if (std::string wrong = objection_to_keys(tool); !wrong.empty()) return wrong;
  return tool.is_insert() ? objection_to_insert(tool) : objection_to_body(tool);
}

}  // namespace kerf::stock
