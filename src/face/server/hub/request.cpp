#include "face/server/hub/request.hpp"

#include <fmt/format.h>

#include "output/writing/diagnostic_text.hpp"

namespace kerf::server {
namespace {

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void Reply::no(const std::string& sentence) const {
  no(base::Failure{base::Failure::Kind::usage, sentence});
}

void Reply::no(const base::Failure& failure) const { send(refusal(failure)); }

// With its code and values, where it has them.
std::string Reply::refusal(const base::Failure& failure) const {
  Json answer = {{"id", id_}, {"ok", false}, {"error", output::printable(failure.message)}};
  if (!failure.code.empty()) {
    Json values = Json::object();
    for (const auto& [name, text] : failure.values) values[name] = output::printable(text);
    answer["code"] = failure.code;
    answer["values"] = std::move(values);
  }
  return dumped(answer);
}

std::string Reply::text_of(const base::Outcome<Json>& outcome) const {
  if (!outcome) return refusal(outcome.error());
  Json answer = {{"id", id_}, {"ok", true}};
  answer.update(*outcome);
  std::string text = dumped(answer);
  if (text.size() <= limits::kAnswerBytes) return text;
  return refusal(base::refuse(base::Refusal::answer_too_long, {std::to_string(text.size())}));
}

std::string Reply::text_with(std::string_view members) const {
  std::string text = dumped({{"id", id_}, {"ok", true}});
  text.back() = ',';
  text.append(members).push_back('}');
  if (text.size() <= limits::kAnswerBytes) return text;
  return refusal(base::refuse(base::Refusal::answer_too_long, {std::to_string(text.size())}));
}

void Reply::send(std::string text) const {
  tickets_->clear();
  if (const auto client = client_.lock()) client->send_text(std::move(text));
}

std::optional<base::Failure> too_late(const std::string& command,
                                      const std::optional<double>& given_ms,
                                      const ServerClock& clock) {
  const double age_ms = given_ms ? clock.now_ms() - *given_ms : 0;
  if (age_ms <= limits::kLateMs) return std::nullopt;
  return base::refuse(base::Refusal::late, {command, fmt::format("{:.1f}", age_ms / 1000),
                                            std::to_string(limits::kLateMs / 1000)});
}

}  // namespace kerf::server
