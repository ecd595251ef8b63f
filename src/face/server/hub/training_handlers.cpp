#include "face/server/hub/handlers.hpp"
#include "output/writing/diagnostic_text.hpp"
#include "training/assessment.hpp"

namespace kerf::server {
namespace {

using base::Outcome;
using training::Criterion;
using training::Exercise;

Json words_json(const training::Words& words) {
  return {{"en", words.en}, {"zh-Hant", words.zh_hant}};
}

// Without the solution: that is what is to be found.
Json exercise_json(const Exercise& exercise) {
  return {{"name", exercise.name},
          {"title", words_json(exercise.title)},
          {"task", words_json(exercise.task)},
          {"machine", exercise.machine},
          {"file", exercise.file},
          {"start", exercise.start},
          {"set_up", exercise.part ? Json(exercise.part->set_up()) : Json()},
          {"zero_mm", exercise.zero_mm}};
}

Json criterion_json(const Criterion& criterion) {
  Json values = Json::object();
  for (const auto& [name, value] : criterion.values) values[std::string(name)] = value;
  return {{"kind", training::name_of(criterion.kind)},
          {"points", criterion.points},
          {"most", criterion.most},
          {"met", criterion.met()},
          {"finding", training::name_of(criterion.finding)},
          {"sentence", output::printable(training::sentence_of(criterion))},
          {"values", std::move(values)},
          {"code", criterion.code},
          {"message", output::printable(criterion.message)},
          {"file", criterion.file},
          {"line", criterion.line}};
}

Outcome<Json> assessment_json(const Exercise& exercise, const std::string& text,
                              const base::WorkLimit& limit) {
  const auto assessment = training::assess(exercise, text, limit.token());
  if (!assessment) return tl::unexpected(assessment.error());
  Json criteria = Json::array();
  for (const Criterion& criterion : assessment->criteria)
    criteria.push_back(criterion_json(criterion));
  return Json{{"score", assessment->score()}, {"criteria", std::move(criteria)}};
}

void exercises(Hub& /*hub*/, const Request& request) {
  Json list = Json::array();
  for (const Exercise& exercise : training::exercises()) list.push_back(exercise_json(exercise));
  request.reply.yes({{"exercises", std::move(list)}});
}

void assess(Hub& hub, const Request& request) {
  const std::string name = request.arguments().text("exercise");
  const Exercise* const exercise = training::find_exercise(name);
  if (exercise == nullptr) return request.reply.no("there is no exercise " + name);
  hub.background().compute(request, [exercise, body = request.body](const base::WorkLimit& limit) {
    return assessment_json(*exercise, Arguments(*body).text("text"), limit);
  });
}

}  // namespace

const Handlers& training_handlers() {
  static const Handlers handlers = {{"exercises", exercises}, {"assess", assess}};
  return handlers;
}

}  // namespace kerf::server
