#include "face/server/hub/handlers.hpp"

namespace kerf::server {

Handler find_handler(std::string_view command) {
  for (const Handlers* const table :
       {&hub_handlers(), &panel_handlers(), &memory_handlers(), &view_handlers(),
        &library_handlers(), &training_handlers()}) {
    if (const auto found = table->find(command); found != table->end()) return found->second;
  }
  return machine::find_operation(command) != nullptr ? press : nullptr;
}

const Handlers& hub_handlers() {
  static const Handlers handlers = {
      {"machines",
       [](Hub& hub, const Request& r) {
         Json definitions = Json::array();
         for (const machine::BuiltinMachine& builtin : machine::builtin_machines())
           definitions.push_back(builtin.name);
         r.reply.yes(
             {{"machines", hub.machines().rows()}, {"definitions", std::move(definitions)}});
       }},
      {"create", [](Hub& hub, const Request& r) { hub.maker().create(r); }},
      {"remove", [](Hub& hub, const Request& r) { hub.maker().remove(r); }},
      {"watch", [](Hub& hub, const Request& r) { hub.attendance().watch(r); }},
      {"operate", [](Hub& hub, const Request& r) { hub.attendance().operate(r); }},
      {"request-operation",
       [](Hub& hub, const Request& r) { hub.attendance().request_operation(r); }},
      {"answer-request", [](Hub& hub, const Request& r) { hub.attendance().answer_request(r); }},
      {"introduce", [](Hub& hub, const Request& r) { hub.attendance().introduce(r); }},
      {"ping", [](Hub& hub, const Request& r) { hub.attendance().ping(r); }},
      {"load", [](Hub& hub, const Request& r) { hub.programs().load(r); }},
      {"stock", [](Hub& hub, const Request& r) { hub.parts().stock(r); }},
      {"stock_at", [](Hub& hub, const Request& r) { hub.parts().stock_at(r); }},
      {"stock_probe", [](Hub& hub, const Request& r) { hub.parts().stock_probe(r); }},
      {"stock_export", [](Hub& hub, const Request& r) { hub.parts().stock_export(r); }},
      {"features", [](Hub& hub, const Request& r) { hub.features().features(r); }},
      {"insight", [](Hub& hub, const Request& r) { hub.features().insight(r); }},
      {"feature_preview", [](Hub& hub, const Request& r) { hub.features().preview(r); }},
      {"feature_apply", [](Hub& hub, const Request& r) { hub.feature_edits().apply(r); }},
      {"feature_undo", [](Hub& hub, const Request& r) { hub.feature_edits().undo(r); }},
      {"set-settings", [](Hub& hub, const Request& r) { hub.machine_files().replace(r); }},
  };
  return handlers;
}

}  // namespace kerf::server
