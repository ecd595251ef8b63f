#include "output/features/internal/turned_json.hpp"

#include "features/tree/words.hpp"
#include "output/features/internal/feature_members.hpp"
#include "output/features/internal/json_values.hpp"

namespace kerf::output {
namespace {

using features::FeatureType;
using features::TurnedElement;
using features::TurnedPart;
using features::TurnedPass;

std::string element_json(const FeatureFacts& facts, const TurnedElement& element) {
  return JsonObject()
      .raw("kind", word_json(word_of(element.kind)))
      .raw("z", rounded(element.z))
      .raw("x", rounded(element.x))
      .raw("radius", rounded_or_null(element.radius))
      .raw("angle_deg", rounded_or_null(element.angle_deg))
      .raw("lines", lines_json(facts, {element.rows}))
      .done();
}

std::string pass_json(const FeatureFacts& facts, const TurnedPass& pass) {
  return JsonObject()
      .raw(pass.along_z ? "x" : "z", rounded(pass.at))
      .raw("lines", lines_json(facts, {pass.rows}))
      .done();
}

template <typename List, typename Told>
std::string array_of(const List& list, Told&& told) {
  std::vector<std::string> items;
  for (const auto& one : list) items.push_back(told(one));
  return json_array(items);
}

void add_thread(const TurnedPart::Thread& thread, JsonObject& object) {
  object.raw("pitch", rounded(thread.pitch)).raw("major", rounded(thread.major));
  object.raw("minor", rounded(thread.minor)).raw("taper", rounded(thread.taper));
  object.raw("hand", thread.is_left_hand ? "\"left\"" : "\"right\"");
  object.raw("starts", rounded(thread.starts));
}

}  // namespace

std::string diameters_json(const contour::Contour& contour) {
  contour::Contour doubled = contour;
  for (contour::Vertex& vertex : doubled.vertices) vertex.point.v *= 2;
  return contour_json(doubled);
}

void add_turned(const FeatureFacts& facts, const features::Feature& feature, JsonObject& object) {
  const TurnedPart& part = *feature.turned;
  object.raw("contour", diameters_json(part.contour)).raw("outer", part.outer ? "true" : "false");
  object.raw("elements",
             array_of(part.elements, [&](const auto& one) { return element_json(facts, one); }));
  object.raw("passes",
             array_of(part.passes, [&](const auto& one) { return pass_json(facts, one); }));
  if (part.x) object.raw("x", rounded(*part.x));
  if (part.width) object.raw("width", rounded(*part.width));
  const bool is_face = feature.type == FeatureType::face_groove;
  if (part.bottom) object.raw(is_face ? "bottom_z" : "bottom_x", rounded(*part.bottom));
  if (part.diameter) object.raw("diameter", rounded(*part.diameter));
  if (!part.steps.empty())
    object.raw("steps",
               array_of(part.steps, [&](const auto& one) { return step_json(facts, one); }));
  if (part.thread) add_thread(*part.thread, object);
}

}  // namespace kerf::output
