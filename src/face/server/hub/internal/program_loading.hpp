#pragma once

#include <functional>
#include <memory>
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
    Library& library;
    MachineTable& machines;
    MachineDisk& disk;
    Previews& previews;
    const Answers& answers;
    Worker& library_disk;  ///< where the library is written
  };
  /// They must outlive this.
  explicit ProgramLoading(Surroundings around) : around_(around) {}

  /// A command. What cannot be loaded leaves the machine with the program that it has.
  void load(const Request& request);
  /// A program that the server itself has made and that the machine is to load.
  struct Made {
    std::string name;
    std::string text;
    std::string dialect;
    /// Writes it to the library; what it makes is told with the answer.
    std::function<base::Outcome<Json>(Library&)> write;
    /// What there is to tell besides, when it is loaded.
    std::function<Json(const MachineRecord&)> more;
  };
  /// Writes and loads it while nothing can begin in between: where it cannot be loaded, nothing is
  /// written, and where it cannot be written, nothing is loaded.
  void load_made(MachineRecord& machine, const Reply& reply, const Made& made);
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
    Json answer = Json::object();                      // what there is of it
    std::function<Json(const MachineRecord&)> more{};  // likewise, when it is loaded
  };

  [[nodiscard]] base::Outcome<Found> found(const LoadedProgram& program, Runner& runner) const;
  void find(const Loading& loading, const LoadedProgram& program, Runner& runner);
  void write(const Loading& loading, const Made& made);
  void keep(const Loading& loading, const Found& found);
  void give(const Loading& loading, const Found& found, Runner& runner);
  void loaded(const Loading& loading, const LoadedProgram& program, const PreviewBasis& basis);

  Surroundings around_;
};

}  // namespace kerf::server
