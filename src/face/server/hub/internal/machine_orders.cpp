#include "face/server/hub/internal/machine_orders.hpp"

#include "face/server/hub/guarded.hpp"
#include "face/server/hub/machine_record.hpp"

namespace kerf::server {

using base::Outcome;

void MachineOrders::give(const Request& request, Pace pace, MachineAction action) {
  MachineRecord& machine = *request.machine;
  machine.thread->post(machine.runner, pace,
                       [this, request, action = std::move(action)](Runner& runner) {
                         answers_.answer(request.reply, done_in_time(request, runner, action));
                       });
}

// Asked again where it is done: a command may have waited behind another one.
Outcome<Json> MachineOrders::done_in_time(const Request& request, Runner& runner,
                                          const MachineAction& action) const {
  const auto late = too_late((*request.body)["do"].get<std::string>(), request.given_ms, clock_);
  if (late) return tl::unexpected(*late);
  runner.machine().set_limit(base::WorkLimit(limits::kSlowSeconds, request.unwanted()));
  const auto outcome = guarded([&] { return action(runner); });
  runner.machine().set_limit({});
  return outcome;
}

/// An entry on its way from the machine to the disk.
struct MachineOrders::Entered {
  Request request;
  Entry entry;
  std::string machine;
  MachineThread* thread;
  std::shared_ptr<Runner> held;
  control::Memory before{0};
  control::Memory after{0};
  Outcome<Json> outcome{};
};

void MachineOrders::give_durably(const Request& request, Entry entry, Pace pace) {
  MachineRecord& machine = *request.machine;
  const auto entered = std::make_shared<Entered>(
      Entered{request, std::move(entry), machine.name, machine.thread, machine.runner});
  machine.thread->post(machine.runner, pace,
                       [this, entered](Runner& runner) { enter(entered, runner); });
}

void MachineOrders::enter(const std::shared_ptr<Entered>& entered, Runner& runner) {
  entered->before = runner.machine().memory();
  entered->outcome = done_in_time(entered->request, runner, entered->entry.act);
  entered->after = runner.machine().memory();
  if (!entered->outcome) {
    if (!keeps_the_same(entered->before, entered->after))
      runner.machine().perform(machine::SetMemory{entered->before});
    return answers_.answer(entered->request.reply, entered->outcome);
  }
  if (disk_.memories().is_on_disk(entered->machine, entered->after)) return keep(*entered, runner);
  entered->thread->lend(entered->held, disk_.worker(),
                        [this, entered](Runner& at_disk) { keep(*entered, at_disk); });
}

void MachineOrders::keep(const Entered& entered, Runner& runner) {
  const Reply& reply = entered.request.reply;
  const auto written = disk_.memories().write(entered.machine, entered.after);
  if (!written) {
    runner.machine().perform(machine::SetMemory{entered.before});
    if (entered.entry.undo) entered.entry.undo(runner.machine());
    return answers_.answer(reply, tl::unexpected(written.error()));
  }
  answers_.to_sockets([reply, outcome = entered.outcome, done = entered.entry.done] {
    if (done) done();
    reply.with(outcome);
  });
}

}  // namespace kerf::server
