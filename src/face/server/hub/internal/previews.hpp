#pragma once

#include <memory>
#include <string>

#include "face/server/hub/internal/answers.hpp"
#include "face/server/hub/internal/machine_table.hpp"
#include "face/server/hub/internal/parts.hpp"
#include "face/server/hub/preview.hpp"
#include "face/server/hub/server_clock.hpp"
#include "face/server/store/chunk_store.hpp"
#include "face/server/store/library.hpp"
#include "face/server/store/thread_check.hpp"
#include "face/server/store/worker.hpp"

namespace kerf::server {

/// A machine at one moment, as a preview begins with it.
struct PreviewBasis {
  machine::MachineDefinition definition;  ///< its axes stand where they do then
  control::Memory memory;
  std::shared_ptr<const machine::Snapshot> snapshot;

  /// On the thread of the machine.
  [[nodiscard]] static PreviewBasis of(Runner& runner);
};

/// The previews of what machines have loaded: one of each machine at a time, and who watches it
/// gets the path. Belongs to the thread of the sockets.
class Previews {
 public:
  /// What previews need of their server.
  struct Surroundings {
    std::string folder;  ///< where chunks are kept
    Library& library;
    MachineTable& machines;
    const Answers& answers;
    const ServerClock& clock;
    Parts& parts;    ///< cut from what they run
    Worker& worker;  ///< runs them
  };
  /// They must outlive this, but for the worker, whose jobs use it.
  explicit Previews(Surroundings around) : around_(std::move(around)) {}

  /// In place of the one before; nothing where no program is loaded.
  void start(MachineRecord& machine, const machine::MachineDefinition& definition,
             const control::Memory& memory);
  void start(MachineRecord& machine, const PreviewBasis& basis);
  /// Once more, because what it runs with has changed. Nothing where there is no such machine.
  void renew(const std::string& name);
  /// Those whose inputs have changed a while ago.
  void tick();
  void cancel() const;

 private:
  [[nodiscard]] job::Job job_of(const MachineRecord& machine,
                                const machine::MachineDefinition& definition,
                                const control::Memory& memory) const;
  void tell_begin(MachineRecord& machine, const std::shared_ptr<Preview>& preview);
  void run(const std::string& name, const std::shared_ptr<Preview>& preview);
  void heard(const std::string& name, const std::shared_ptr<Preview>& preview,
             const PreviewState& state);

  Surroundings around_;
  ThreadCheck thread_{"that of the sockets"};
  std::shared_ptr<ChunkBudget> chunk_budget_ = std::make_shared<ChunkBudget>();
};

}  // namespace kerf::server
