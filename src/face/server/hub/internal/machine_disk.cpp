#include "face/server/hub/internal/machine_disk.hpp"

#include <chrono>
#include <thread>

#include "face/server/hub/guarded.hpp"
#include "face/server/hub/internal/console.hpp"

namespace kerf::server {

using base::Outcome;

MachineDisk::MachineDisk(MachineStore store, Worker& worker, const Answers& answers,
                         MachineTable& machines)
    : store_(std::move(store)),
      worker_(worker),
      answers_(answers),
      machines_(machines),
      memories_(
          worker,
          [this](const std::string& machine, const control::Memory& memory) {
            return store_.write_memory(machine, memory);
          },
          [this](const std::string& machine, const std::string& trouble) {
            answers_.to_sockets([this, machine, trouble] { machines_.unsaved(machine, trouble); });
          }) {}

void MachineDisk::write(const Reply& reply, Writing action,
                        std::function<void(Outcome<void>)> done) {
  worker_.post([this, reply, action = std::move(action), done = std::move(done)] {
    const auto written = guarded([&] { return action(store_); });
    answers_.to_sockets([this, reply, written, done] {
      done(written);
      if (!written) reply.no(answers_.without_folder(written.error().message));
    });
  });
}

// A disk that is full for a moment has some time.
void MachineDisk::save_at_the_end() {
  constexpr int kTries = 5;
  constexpr auto kPause = std::chrono::milliseconds(200);
  for (int tries = 1; tries <= kTries; ++tries) {
    if (save_all(tries == kTries)) return;
    std::this_thread::sleep_for(kPause);
  }
}

bool MachineDisk::save_all(bool tells_losses) {
  bool all = true;
  for (const auto& [name, machine] : machines_.records()) {
    const auto written = memories_.write(name, machine->runner->last_memory());
    all &= written.has_value();
    if (!written && tells_losses)
      tell_console("the memory of " + name +
                   " has changes that are lost: " + written.error().message);
  }
  return all;
}

}  // namespace kerf::server
