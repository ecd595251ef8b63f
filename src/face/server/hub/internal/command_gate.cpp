#include "face/server/hub/internal/command_gate.hpp"

#include <cmath>

#include "face/server/hub/machine_record.hpp"
#include "face/server/protocol/json_shape.hpp"

namespace kerf::server {
namespace {

using base::Outcome;

tl::unexpected<base::Failure> wrong(const std::string& sentence) {
  return tl::unexpected(base::Failure{base::Failure::Kind::usage, sentence});
}

// To read so much costs nothing, so that even what is refused unread is answered by its id.
Json id_of(const Json& body) {
  const bool has_id = body.is_object() && body.contains("id") && body["id"].is_primitive();
  return has_id ? body["id"] : Json(nullptr);
}

// The command that a text asks for, its arguments held against the table. Failure (usage).
Outcome<const Command*> command_of(const Json& body) {
  if (!body.is_object()) return wrong("a command is an object of JSON, and this is none");
  if (!body.contains("do") || !body["do"].is_string())
    return wrong("the command names nothing to do: the key `do` is missing");
  const std::string name = body["do"].get<std::string>();
  const Command* const command = find_command(name);
  if (command == nullptr) return wrong("there is no command " + name.substr(0, 40));
  if (auto checked = check_arguments(body, command->arguments, {"id", "do", "at_ms"}); !checked) {
    base::Failure failure = checked.error();
    failure.message = name + ": " + failure.message;
    return tl::unexpected(std::move(failure));
  }
  return command;
}

// The time at which a command was given; nothing else of a frame may be a number besides its id.
Outcome<std::optional<double>> given_ms(const Json& body, const std::string& command) {
  if (!body.contains("at_ms")) return std::nullopt;
  const Json& at = body["at_ms"];
  if (at.is_number() && std::isfinite(at.get<double>())) return at.get<double>();
  return wrong(command + ": at_ms must be a number: ms of the server's clock");
}

// Whether a command is for this client. Failure (usage): why not.
Outcome<void> check_who(const Command& command, const Client& client) {
  const std::string name(command.name);
  const MachineRecord* const machine = client.watched();
  if (command.who == Command::Who::anyone) return {};
  if (machine == nullptr) return wrong(name + ": no machine is watched on this connection");
  if (command.who != Command::Who::op || machine->op == &client) return {};
  if (machine->op == nullptr)
    return tl::unexpected(base::refuse(base::Refusal::operated_by_nobody, {name, machine->name}));
  return tl::unexpected(base::refuse(base::Refusal::operated_by_another,
                                     {name, machine->name, machine->op->shown_name()}));
}

void refuse_haste(Client& client, const Reply& reply) {
  constexpr int kMostRefused = 1000;
  if (++client.refused_in_a_row > kMostRefused)
    return client.close(Link::Why::policy, "Commands came faster than the server takes them.");
  reply.no(base::Refusal::too_fast);
}

}  // namespace

std::optional<CommandGate::Admitted> CommandGate::admit(const std::shared_ptr<Client>& client,
                                                        std::string_view text) {
  const bool in_time = client->admit_command();
  const bool is_read = in_time || text.size() <= limits::kSmallBytes;
  const auto objection = is_read ? objection_to_shape(text) : std::nullopt;
  const auto body = std::make_shared<const Json>(
      is_read && !objection ? Json::parse(text, nullptr, false) : Json(Json::value_t::discarded));
  const Reply refusal(client, id_of(*body));
  if (!in_time) {
    refuse_haste(*client, refusal);
    return std::nullopt;
  }
  client->refused_in_a_row = 0;
  client->hear(clock_.now_ms());
  auto admitted = objection ? wrong(*objection) : checked(client, body, text.size());
  if (admitted) return std::move(*admitted);
  refusal.no(admitted.error());
  return std::nullopt;
}

Outcome<CommandGate::Admitted> CommandGate::checked(const std::shared_ptr<Client>& client,
                                                    const std::shared_ptr<const Json>& body,
                                                    std::size_t bytes) {
  const auto command = command_of(*body);
  if (!command) return tl::unexpected(command.error());
  const std::string name((*command)->name);
  const auto given = given_ms(*body, name);
  if (!given) return tl::unexpected(given.error());
  if (auto late = too_late(name, *given, clock_)) return tl::unexpected(std::move(*late));
  if (auto suits = check_who(**command, *client); !suits) return tl::unexpected(suits.error());
  Quota::Ticket mine = client->begin_command();
  if (!mine)
    return tl::unexpected(
        base::refuse(base::Refusal::under_way, {std::to_string(limits::kUnderWay)}));
  Quota::Ticket ours = large_under_way_.take(bytes > limits::kSmallBytes ? bytes : 0);
  if (!ours) return tl::unexpected(base::refuse(base::Refusal::server_busy));
  return Admitted{
      {client, client->watched(), body, Reply(client, id_of(*body), {mine, ours}), *given},
      *command};
}

}  // namespace kerf::server
