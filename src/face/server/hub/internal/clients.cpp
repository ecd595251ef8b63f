#include "face/server/hub/internal/clients.hpp"

#include <fmt/format.h>

#include <chrono>
#include <random>

#include "face/server/protocol/language_json.hpp"

namespace kerf::server {
namespace {

std::string random_name() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

std::int64_t now_ms_since_epoch() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace

Clients::Clients(Worker& disk, const Answers& answers)
    : disk_(disk), answers_(answers), instance_(random_name()), began_ms_(now_ms_since_epoch()) {}

std::shared_ptr<Client> Clients::add(Link& link) {
  auto client = std::make_shared<Client>("client-" + std::to_string(next_++), link);
  clients_[client.get()] = client;
  client->set_fetch(fetch_for(client));
  client->send(hello_for(*client));
  return client;
}

Client::FetchChunk Clients::fetch_for(std::weak_ptr<Client> client) const {
  return [this, client = std::move(client)](const std::shared_ptr<ChunkStore>& store,
                                            std::size_t number) {
    disk_.post([this, client, store, number] {
      answers_.to_sockets([client, store, number, chunk = store->read(number)] {
        if (const auto reader = client.lock()) reader->take_chunk(store, number, chunk);
      });
    });
  };
}

Json Clients::hello_for(const Client& client) const {
  return {{"event", "hello"},
          {"protocol", kProtocol},
          {"server", instance_},
          {"began_ms", began_ms_},
          {"client", client.name()},
          {"dialects", dialects_json()},
          {"token_kinds", token_kinds_json()}};
}

void Clients::tell(const Json& event) const {
  const std::string text = event.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (const auto& [key, client] : clients_) client->send_text(text);
}

// One who is closed may leave at once.
void Clients::close(const std::string& sentence) const {
  const auto clients = clients_;
  for (const auto& [key, client] : clients) client->close(Link::Why::going_away, sentence);
}

void Clients::cut() const {
  for (const auto& [key, client] : clients_) client->cut();
}

}  // namespace kerf::server
