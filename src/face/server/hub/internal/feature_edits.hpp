#pragma once

#include <string>

#include "face/server/hub/internal/answers.hpp"
#include "face/server/hub/internal/features.hpp"
#include "face/server/hub/internal/machine_table.hpp"
#include "face/server/hub/internal/program_loading.hpp"
#include "face/server/store/library.hpp"
#include "face/server/store/thread_check.hpp"
#include "face/server/store/worker.hpp"
#include "job/edit_preview.hpp"

namespace kerf::server {

/// What a program was before an edit.
struct UneditedProgram {
  std::string text;
  Library::KeptEdit edit;
};

/// Edits of the features of loaded programs, made and taken back: each is a revision of the program
/// in the library, which the machine then loads. Belongs to the thread of the sockets.
class FeatureEdits {
 public:
  /// What it needs of its server.
  struct Surroundings {
    Library& library;
    MachineTable& machines;
    const Answers& answers;
    Features& features;
    ProgramLoading& programs;
    Worker& disk;    ///< reads the library
    Worker& worker;  ///< verifies
  };
  /// They must outlive this, but for the workers, whose jobs use it.
  explicit FeatureEdits(Surroundings around) : around_(around) {}

  // Commands

  void apply(const Request& request);
  void undo(const Request& request);

 private:
  void verify(const Request& request, const Features::Scene& scene);
  void verified(const Request& request, const Features::Scene& scene,
                const job::EditResult& result);
  void take_back(const Request& request, const LoadedProgram& program,
                 const UneditedProgram& before);

  Surroundings around_;
  ThreadCheck thread_{"that of the sockets"};
};

}  // namespace kerf::server
