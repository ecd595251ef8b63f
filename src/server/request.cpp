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

void Reply::with(const base::Outcome<Json>& outcome) const {
  outcome ? yes(*outcome) : no(outcome.error().message);
}

}  // namespace kerf::server
