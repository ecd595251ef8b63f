#include "face/server/hub/handlers.hpp"

namespace kerf::server {

Handler find_handler(std::string_view command) {
  for (const Handlers* const table :
       {&hub_handlers(), &panel_handlers(), &memory_handlers(), &view_handlers(),
        &library_handlers(), &training_handlers()}) {
    if (const auto found = table->find(command); found != table->end()) return found->second;
  }
  return nullptr;
}

const Handlers& hub_handlers() {
  static const Handlers handlers = {
      {"machines",
       [](Hub& hub, const Request& r) {
         Json definitions = Json::array();
         for (const machine::BuiltinMachine& builtin : machine::builtin_machines())
           definitions.push_back(builtin.name);
         r.reply.yes({{"machines", hub.machine_rows()}, {"definitions", std::move(definitions)}});
       }},
      {"create", [](Hub& hub, const Request& r) { hub.create(r); }},
      {"remove", [](Hub& hub, const Request& r) { hub.remove(r); }},
      {"watch", [](Hub& hub, const Request& r) { hub.watch(r); }},
      {"operate", [](Hub& hub, const Request& r) { hub.operate(r); }},
      {"request-operation", [](Hub& hub, const Request& r) { hub.request_operation(r); }},
      {"answer-request", [](Hub& hub, const Request& r) { hub.answer_request(r); }},
      {"introduce", [](Hub& hub, const Request& r) { hub.introduce(r); }},
      {"ping", [](Hub& hub, const Request& r) { hub.ping(r); }},
      {"load", [](Hub& hub, const Request& r) { hub.load(r); }},
      {"set-settings", [](Hub& hub, const Request& r) { hub.replace_definition(r); }},
  };
  return handlers;
}

}  // namespace kerf::server
