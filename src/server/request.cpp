#include "server/request.hpp"

#include "output/diagnostic_text.hpp"

namespace kerf::server {

void Reply::yes(Json keys) const {
  const auto client = client_.lock();
  if (!client) return;
  Json answer = {{"id", id_}, {"ok", true}};
  answer.update(keys);
  client->send(answer);
}

void Reply::no(const std::string& sentence) const {
  if (const auto client = client_.lock())
    client->send({{"id", id_}, {"ok", false}, {"error", output::printable(sentence)}});
}

void Reply::no(const base::Failure& failure) const {
  if (failure.code.empty()) return no(failure.message);
  const auto client = client_.lock();
  if (!client) return;
  Json values = Json::object();
  for (const auto& [name, text] : failure.values) values[name] = output::printable(text);
  client->send({{"id", id_},
                {"ok", false},
                {"error", output::printable(failure.message)},
                {"code", failure.code},
                {"values", std::move(values)}});
}

void Reply::with(const base::Outcome<Json>& outcome) const {
  outcome ? yes(*outcome) : no(outcome.error());
}

}  // namespace kerf::server
