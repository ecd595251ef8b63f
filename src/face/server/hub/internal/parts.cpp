#include "face/server/hub/internal/parts.hpp"

#include <algorithm>

#include "face/server/hub/guarded.hpp"
#include "face/server/hub/internal/console.hpp"
#include "face/server/hub/internal/part_job.hpp"
#include "face/server/protocol/part_json.hpp"

namespace kerf::server {
namespace {

using base::Outcome;

Json set_up_json(const std::string& toml) { return {{"toml", toml}, {"is_default", toml.empty()}}; }

bool is_wanted(const MachineRecord& machine) {
  return std::any_of(machine.watchers.begin(), machine.watchers.end(),
                     [](const Client* client) { return client->wants_part; });
}

}  // namespace

// What machines have loaded

void Parts::begin(MachineRecord& machine, PartSource source) {
  thread_.here();
  hide(machine);
  machine.part_source = std::move(source);
  around_.features.renew(machine);
  if (is_wanted(machine)) cut_again(machine);
}

void Parts::end(MachineRecord& machine) {
  hide(machine);
  machine.part_source.reset();
  around_.features.renew(machine);
}

void Parts::hide(MachineRecord& machine) {
  machine.cancel_part();
  machine.part.reset();
  for (Client* const watcher : machine.watchers) watcher->part().show(nullptr);
}

// A part that nobody wants to see any more is not kept.
void Parts::tick() {
  for (const auto& [name, machine] : around_.machines.records()) {
    if (machine->part && !is_wanted(*machine)) hide(*machine);
  }
}

void Parts::cancel() const {
  for (const auto& [name, machine] : around_.machines.records()) machine->cancel_part();
}

void Parts::cut_again(MachineRecord& machine) {
  around_.disk.post([this, name = machine.name, program = machine.part_source->program,
                     number = ++machine.part_number] {
    auto toml = guarded([&] { return around_.library.set_up(program); });
    around_.answers.to_sockets([this, name, number, toml] {
      MachineRecord* const found = around_.machines.find(name);
      if (found != nullptr && found->part_source && found->part_number == number) cut(*found, toml);
    });
  });
}

void Parts::cut(MachineRecord& machine, const Outcome<std::string>& set_up) {
  machine.cancel_part();
  machine.part = std::make_shared<Part>(job::LivePart::Order{
      .job = [this, source = *machine.part_source, set_up]() -> Outcome<job::StockJob> {
        if (!set_up) return tl::unexpected(set_up.error());
        return part_job(source, *set_up, around_.library.folder(), Sight::against_design);
      },
      .first_run = machine.part_number * job::LivePart::kMostRuns});
  for (Client* const watcher : machine.watchers) {
    if (watcher->wants_part) show(*watcher, machine);
  }
  around_.cuts.post([this, name = machine.name, part = machine.part] { run(name, part); });
}

void Parts::show(Client& client, MachineRecord& machine) {
  client.part().show(machine.part);
  client.wake();
}

// On a thread that cuts.
void Parts::run(const std::string& name, const std::shared_ptr<Part>& part) {
  const auto tell = [&](const job::PartProgress& progress) {
    around_.answers.to_sockets(
        [this, name, part, facts = part_json(progress)] { heard(name, part, facts); });
  };
  try {
    part->live.cut(tell);
  } catch (const std::exception& fault) {
    tell_console(name + ": the part: fault of Kerf itself: " + fault.what());
    tell({.is_done = true, .error = std::string("fault of Kerf itself: ") + fault.what()});
  }
}

void Parts::heard(const std::string& name, const std::shared_ptr<Part>& part, const Json& facts) {
  thread_.here();
  MachineRecord* const machine = around_.machines.find(name);
  if (machine == nullptr || machine->part != part) return;  // of a program before this one
  Json told = facts;
  if (Json& error = told["error"]; error.is_object())
    error["message"] = around_.answers.without_folder(error["message"].get<std::string>());
  part->document.update(told);
  for (Client* const watcher : machine->watchers) {
    watcher->part().stir();
    watcher->wake();
  }
}

// What is seen

PartView::Look Parts::look_for(std::weak_ptr<Client> client) {
  return [this, client = std::move(client)](const PartLooking& looking) {
    around_.looks.post(
        {.work = [this, client, looking] { make(client, looking); }, .owner = looking.part.get()});
  };
}

// On a thread that looks: one at a part at a time.
void Parts::make(const std::weak_ptr<Client>& client, const PartLooking& looking) {
  std::optional<job::PartLook> look;
  try {
    look = looking.cutting ? looking.sight->look(looking.cutting, looking.wish, looking.unwanted)
                           : job::PartLook{.is_behind = looking.wish.time_s > 0.0};
  } catch (const std::exception& fault) {
    tell_console(std::string("a look at the part: fault of Kerf itself: ") + fault.what());
    look = job::PartLook{};
  }
  around_.answers.to_sockets([client, looking, look = std::move(look)] {
    const auto looker = client.lock();
    if (!looker || looker->watched() == nullptr) return;
    looker->part().take(looking, look, looker->watched()->name);
    looker->wake();
  });
}

// Commands

void Parts::stock(const Request& request) {
  const Arguments arguments = request.arguments();
  MachineRecord& machine = *request.machine;
  if (arguments.has("toml")) {
    if (!machine.part_source) return request.reply.no(base::Refusal::no_program);
    return keep_set_up(request, arguments.text("toml"));
  }
  if (!arguments.has("shows")) return answer_set_up(request);
  Client& client = *request.client;
  client.wants_part = arguments.flag("shows");
  client.part().forget();
  if (!client.wants_part) {
    client.part().show(nullptr);
  } else if (machine.part) {
    show(client, machine);
  } else if (machine.part_source) {
    cut_again(machine);
  }
  request.reply.yes();
}

void Parts::answer_set_up(const Request& request) {
  if (!request.machine->part_source) return request.reply.no(base::Refusal::no_program);
  around_.disk.post(
      {.work =
           [this, reply = request.reply, program = request.machine->part_source->program] {
             around_.answers.answer(reply, guarded([&]() -> Outcome<Json> {
                                      auto toml = around_.library.set_up(program);
                                      if (!toml) return tl::unexpected(toml.error());
                                      return set_up_json(*toml);
                                    }));
           },
       .unwanted = request.unwanted()});
}

void Parts::keep_set_up(const Request& request, const std::string& toml) {
  around_.disk.post([this, reply = request.reply, name = request.machine->name, toml,
                     program = request.machine->part_source->program] {
    const auto kept = guarded([&]() -> Outcome<void> {
      if (auto checked = check_set_up(toml); !checked) return checked;
      return around_.library.keep_set_up(program, toml);
    });
    if (!kept) return around_.answers.answer(reply, tl::unexpected(kept.error()));
    around_.answers.to_sockets([this, reply, name, toml] {
      if (MachineRecord* const machine = around_.machines.find(name)) set_up_changed(*machine);
      reply.yes(set_up_json(toml));
    });
  });
}

// Before the answer: who has it asks for the part and the features of the new one.
void Parts::set_up_changed(MachineRecord& machine) {
  around_.features.renew(machine);
  if (machine.part) cut_again(machine);
}

void Parts::stock_at(const Request& request) {
  Client& client = *request.client;
  if (!client.wants_part) return request.reply.no("stock_at: nothing is shown; `stock` shows it");
  const Arguments arguments = request.arguments();
  job::PartWish wish;
  if (arguments.has("time_s")) wish.time_s = arguments.number("time_s");
  if (arguments.has("level")) wish.level = static_cast<std::uint32_t>(arguments.integer("level"));
  wish.deviation = arguments.has("deviation") && arguments.flag("deviation");
  client.part().want(wish, request.reply);
  client.wake();
}

void Parts::stock_probe(const Request& request) {
  const PartView& view = request.client->part();
  const auto cutting = view.part() ? view.part()->live.cutting() : nullptr;
  if (!cutting) return request.reply.no("stock_probe: nothing is shown; `stock` shows it");
  const Arguments arguments = request.arguments();
  const stock::Vec3 at{arguments.number("x"), arguments.number("y"), arguments.number("z")};
  around_.looks.post({.work =
                          [this, reply = request.reply, cutting, wish = view.wish(), at] {
                            around_.answers.answer(
                                reply, guarded([&]() -> Outcome<Json> {
                                  return place_json(job::answer_at(*cutting, wish, at));
                                }));
                          },
                      .unwanted = request.unwanted(),
                      .owner = view.part().get()});
}

// What is kept: begun on the disk, cut where parts are cut, finished on the disk.

void Parts::stock_export(const Request& request) {
  if (!request.machine->part_source) return request.reply.no(base::Refusal::no_program);
  const PartExport part{*request.machine->part_source,
                        {},
                        around_.library.folder(),
                        request.arguments().text("format"),
                        request.unwanted()};
  around_.disk.post({.work = [this, reply = request.reply, part] { begin_export(reply, part); },
                     .unwanted = part.unwanted});
}

void Parts::begin_export(const Reply& reply, PartExport part) {
  auto file = guarded([&]() -> Outcome<ExportFile> {
    auto toml = around_.library.set_up(part.source.program);
    if (!toml) return tl::unexpected(toml.error());
    part.set_up = std::move(*toml);
    auto begun = around_.library.begin_upload(part_name(part.source.program, part.format));
    if (!begun) return tl::unexpected(begun.error());
    return ExportFile(std::move(*begun));
  });
  if (!file) return around_.answers.answer(reply, tl::unexpected(file.error()));
  around_.answers.to_sockets([this, reply, part = std::move(part), file = std::move(*file)] {
    cut_export(reply, part, file);
  });
}

void Parts::cut_export(const Reply& reply, const PartExport& part, const ExportFile& file) {
  const auto work = [this, reply, part, file] {
    const auto cut = guarded([&] { return export_part(part, *file); });
    if (!cut) return around_.answers.answer(reply, tl::unexpected(cut.error()));
    around_.answers.to_sockets([this, reply, part, file] { keep_export(reply, part, file); });
  };
  around_.cuts.post({.work = work, .unwanted = part.unwanted});
}

void Parts::keep_export(const Reply& reply, const PartExport& part, const ExportFile& file) {
  around_.disk.post([this, reply, name = part_name(part.source.program, part.format), file] {
    around_.answers.answer(
        reply, guarded([&]() -> Outcome<Json> {
          const auto kept = around_.library.finish_upload(name, *file);
          if (!kept) return tl::unexpected(kept.error());
          return Json{{"name", name}, {"bytes", kept->bytes}, {"revision", kept->number}};
        }));
  });
}

}  // namespace kerf::server
