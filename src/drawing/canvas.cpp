#include "drawing/canvas.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>

namespace kerf::drawing {
namespace {

enum class Reach : std::uint8_t { near, far, nowhere };

Reach reach_of(Vec2 point) {
  if (!std::isfinite(point.u) || !std::isfinite(point.v)) return Reach::nowhere;
  const bool is_far = std::abs(point.u) > kFarthest_mm || std::abs(point.v) > kFarthest_mm;
  return is_far ? Reach::far : Reach::near;
}

Reach reach_of(const std::vector<contour::Vertex>& vertices) {
  Reach reach = Reach::near;
  for (const contour::Vertex& vertex : vertices) {
    reach = std::max(reach, reach_of(vertex.point));
    if (!std::isfinite(vertex.bulge)) return Reach::nowhere;
  }
  return reach;
}

bool fits(const std::string& name, const std::string& pattern) {
  return fnmatch(pattern.c_str(), name.c_str(), FNM_NOESCAPE) == 0;
}

}  // namespace

Canvas::Canvas(const Reading& reading, Drawing& drawing) : reading_(reading), drawing_(drawing) {}

FileFacts& Canvas::begin_file(base::FileId file, std::string format) {
  ignored_.clear();
  kinds_.clear();
  drawing_.files.push_back({});
  facts().file = file;
  facts().format = std::move(format);
  return facts();
}

bool Canvas::names(std::string_view layer) const {
  const std::string name(layer);
  return std::any_of(reading_.layers.begin(), reading_.layers.end(),
                     [&](const std::string& pattern) { return fits(name, pattern); });
}

bool Canvas::wants(std::string_view layer) {
  if (reading_.layers.empty()) return true;
  const auto [entry, is_new] = wanted_.try_emplace(std::string(layer), false);
  if (is_new) entry->second = names(layer);
  return entry->second;
}

EntityId Canvas::add(Entity entity) {
  entity.file = facts().file;
  std::size_t*& count = kinds_[static_cast<std::uint32_t>(entity.kind)];
  if (count == nullptr) count = &facts().entities[std::string(text_of(entity.kind))];
  ++*count;
  drawing_.entities.push_back(entity);
  return static_cast<EntityId>(drawing_.entities.size() - 1);
}

void Canvas::ignore(std::string_view what, std::uint32_t line, std::string_view why) {
  std::vector<Ignored>& list = facts().ignored;
  const auto [entry, is_new] = ignored_.try_emplace(std::string(what), list.size());
  if (is_new) list.push_back({std::string(what), 0, line, std::string(why)});
  ++list[entry->second].count;
}

void Canvas::find(base::Severity severity, base::Code code, base::Place place,
                  const std::string& detail, Name layer, Name entity, const std::string& hint) {
  if (++told_[static_cast<std::uint32_t>(code)] > kMostOfACode) return;
  if (place.file == base::kNoFile && place.line > 0 && !drawing_.files.empty())
    place.file = facts().file;
  base::Diagnostic diagnostic = base::make_error(code, place, detail, hint);
  diagnostic.severity = severity;
  drawing_.findings.push_back({std::move(diagnostic), layer, entity});
}

bool Canvas::is_drawable(const std::vector<contour::Vertex>& vertices, EntityId entity) {
  const Reach reach = reach_of(vertices);
  if (reach == Reach::near) return true;
  const Entity& of = drawing_.entities[entity];
  const base::Place place{of.file, of.line, 1};
  if (reach == Reach::nowhere)
    find(base::Severity::error, base::Code::draw_nan, place, "", of.layer, of.kind);
  else
    find(base::Severity::error, base::Code::draw_range, place, "", of.layer, of.kind);
  return false;
}

void Canvas::add(Point point) {
  if (is_drawable({{point.at}}, point.entity)) drawing_.points.push_back(point);
}

void Canvas::add(std::vector<contour::Vertex>& vertices, bool is_closed, EntityId entity) {
  if (!is_drawable(vertices, entity)) return;
  drawing_.paths.push_back(
      {drawing_.vertices.size(), static_cast<std::uint32_t>(vertices.size()), is_closed});
  drawing_.vertices.insert(drawing_.vertices.end(), vertices.begin(), vertices.end());
}

void Canvas::tell_over(base::Code code, const std::string& detail, std::uint32_t line) {
  over_ = true;
  find(base::Severity::error, code, {base::kNoFile, line, line > 0 ? 1U : 0U}, detail);
}

bool Canvas::is_over() {
  constexpr std::uint64_t kBetweenLooks = 1024;
  if (over_) return true;
  const std::uint64_t most = reading_.max_entities;
  if (std::max<std::uint64_t>(drawing_.entities.size(), clones_) > most)
    tell_over(base::Code::draw_limit, fmt::format("more than {}", most));
  else if (drawing_.vertices.size() / kVerticesOfAnEntity > most)
    tell_over(base::Code::draw_limit,
              fmt::format("more than {} lines and arcs for each of {}", kVerticesOfAnEntity, most));
  else if (++work_ % kBetweenLooks == 0 && reading_.limit.reached())
    tell_over(base::Code::budget_spent, reading_.limit.reason());
  return over_;
}

bool Canvas::has_room_for(double entities, std::uint32_t line) {
  if (is_over()) return false;
  const auto most = static_cast<double>(reading_.max_entities);
  if (static_cast<double>(drawing_.entities.size()) + entities <= most) return true;
  tell_over(base::Code::draw_limit, fmt::format("more than {}", reading_.max_entities), line);
  return false;
}

bool Canvas::is_over_with_clone() {
  ++clones_;
  return is_over();
}

}  // namespace kerf::drawing
