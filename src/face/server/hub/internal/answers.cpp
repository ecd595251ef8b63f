#include "face/server/hub/internal/answers.hpp"

namespace kerf::server {

std::string Answers::without_folder(std::string sentence) const {
  for (std::size_t at = 0; (at = sentence.find(folder_, at)) != std::string::npos;)
    sentence.erase(at, folder_.size());
  return sentence;
}

void Answers::answer(const Reply& reply, const base::Outcome<Json>& made) const {
  base::Outcome<Json> outcome = made;
  if (!outcome) outcome.error().message = without_folder(std::move(outcome.error().message));
  to_sockets_([reply, text = reply.text_of(outcome)] { reply.send(text); });
}

}  // namespace kerf::server
