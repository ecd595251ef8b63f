#include "face/server/protocol/part_json.hpp"

#include "face/server/protocol/diagnostic_json.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::server {
namespace {

using Told = output::StockFacts::Told;
using Thread = output::StockFacts::Thread;

Json vector_json(stock::Vec3 place) { return {place.x, place.y, place.z}; }

Json level_json(const job::PartLevel& level) {
  if (!level.grid) return nullptr;
  return {
      {"first", level.grid->first}, {"cell_mm", level.grid->cell_mm}, {"cells", level.grid->cells}};
}

Json finding_json(const Told& told, const base::SourceSet& sources) {
  Json json = diagnostic_json(told.diagnostic, sources);
  json["time_s"] = told.finding.time_s;
  json["tool"] = told.finding.tool;
  json["motion"] = told.finding.motion;
  json["at"] = vector_json(told.finding.at);
  json["depth_mm"] = told.finding.depth_mm;
  json["volume_mm3"] = told.finding.volume_mm3;
  json["count"] = told.finding.count;
  return json;
}

Json thread_json(const Thread& thread) {
  return {{"line", thread.line},    {"from", thread.from},   {"to", thread.to},
          {"major", thread.major},  {"minor", thread.minor}, {"pitch", thread.pitch},
          {"starts", thread.starts}};
}

Json design_json(const job::DesignInSight* design) {
  if (design == nullptr) return nullptr;
  return {{"file", file_label(design->file)}, {"tolerance_mm", design->tolerance_mm}};
}

Json owner_json(const job::OwnerRow& row) {
  const Json engagement = row.engagement_deg > 0 ? Json(row.engagement_deg) : Json(nullptr);
  return {row.owner.file, row.owner.line, row.owner.tool, engagement};
}

void take_cutting(const job::Cutting& cutting, Json& json) {
  json["run"] = cutting.run();
  json["model"] = cutting.model();
  json["reason"] = output::printable(cutting.reason());
  json["stock"] = {{"origin", vector_json(cutting.origin())},
                   {"low", vector_json(cutting.box().low)},
                   {"high", vector_json(cutting.box().high)}};
  json["cell_mm"] = cutting.levels().front().cell_mm;
  json["levels"] = Json::array();
  for (const job::PartLevel& level : cutting.levels()) json["levels"].push_back(level_json(level));
  json["done_s"] = cutting.reached_s();
  json["design"] = design_json(cutting.design());
}

void take_sources(const job::PartProgress& progress, Json& json) {
  const base::SourceSet& sources = *progress.sources;
  json["files"] = Json::array();
  for (std::uint32_t i = 0; sources.contains(base::FileId{i}); ++i)
    json["files"].push_back(file_label(sources[base::FileId{i}].name()));
  json["findings"] = Json::array();
  for (const Told& told : progress.findings)
    json["findings"].push_back(finding_json(told, sources));
  json["more_findings"] = progress.more_findings;
}

void take_doubts(const job::PartProgress& progress, Json& json) {
  json["assumed"] = Json::array();
  for (const control::Assumption& each : progress.assumed)
    json["assumed"].push_back({{"line", each.line}, {"what", output::printable(each.what)}});
  json["not_checked"] = Json::array();
  for (const std::string& each : progress.not_checked)
    json["not_checked"].push_back(output::printable(each));
}

}  // namespace

Json part_json(const job::PartProgress& progress) {
  Json json = {{"done", progress.is_done}, {"error", nullptr}};
  if (progress.cutting) take_cutting(*progress.cutting, json);
  if (progress.sources != nullptr) take_sources(progress, json);
  if (progress.is_done) {
    json["threads"] = Json::array();
    for (const Thread& thread : progress.threads) json["threads"].push_back(thread_json(thread));
    take_doubts(progress, json);
  }
  if (!progress.error.empty()) json["error"] = {{"message", output::printable(progress.error)}};
  return json;
}

Json sight_json(const job::PartLook& look) {
  Json json = {{"removed_mm3", look.removed_mm3}, {"behind", look.is_behind}};
  if (look.owners.empty()) return json;
  Json rows = Json::array();
  for (const job::OwnerRow& row : look.owners) rows.push_back(owner_json(row));
  json["owners"] = {{"from", look.first_owner}, {"rows", std::move(rows)}};
  return json;
}

Json place_json(const std::optional<job::PartAnswer>& answer) {
  if (!answer) return {{"at", nullptr}, {"owner", nullptr}};
  const auto& deviation = answer->deviation_mm;
  Json json = {{"at", vector_json(answer->place.at)},
               {"owner", nullptr},
               {"deviation_mm", deviation ? Json(*deviation) : Json(nullptr)},
               {"energy_j_mm2", answer->place.energy_j_mm2}};
  if (answer->owner.line > 0) {
    json["owner"] = {{"file", answer->owner.file},
                     {"line", answer->owner.line},
                     {"tool", answer->owner.tool},
                     {"motion", answer->place.motion}};
  }
  return json;
}

}  // namespace kerf::server
