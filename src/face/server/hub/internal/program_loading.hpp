#pragma once

#include <string>

#include "base/program_text.hpp"
#include "face/server/hub/internal/answers.hpp"
#include "face/server/hub/internal/machine_disk.hpp"
#include "face/server/hub/internal/machine_table.hpp"
#include "face/server/hub/internal/previews.hpp"
#include "face/server/store/library.hpp"

namespace kerf::server {

/// How machines come to their programs. Belongs to the thread of the sockets.
class ProgramLoading {
 public:
  /// What loading needs of its server.
  struct Surroundings {
    const Library& library;
    MachineTable& machines;
    MachineDisk& disk;
    Previews& previews;
    const Answers& answers;
  };
  /// They must outlive this.
  explicit ProgramLoading(Surroundings around) : around_(around) {}

  /// A command. What cannot be loaded leaves the machine with the program that it has.
  void load(const Request& request);
  /// What a machine has loaded when the server begins, with its breakpoints. What cannot be loaded
  /// any more is told when somebody loads it again.
  void load_again(MachineRecord& machine);

 private:
  /// A program that can be opened, with its dialect.
  struct Found {
    base::ProgramText text;
    LoadedProgram program;
  };
  /// A command on its way from the disk to the machine and back.
  struct Loading {
    std::string machine;
    MachineThread& thread;
    std::shared_ptr<Runner> held;
    Reply reply;
  };

  [[nodiscard]] base::Outcome<Found> found(const LoadedProgram& program, Runner& runner) const;
  void find(const Loading& loading, const LoadedProgram& program, Runner& runner);
  void keep(const Loading& loading, const Found& found);
  void give(const Loading& loading, const Found& found, Runner& runner);
  void loaded(const Loading& loading, const LoadedProgram& program, const PreviewBasis& basis);

  Surroundings around_;
};

}  // namespace kerf::server
