#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "face/server/hub/feature_scene.hpp"
#include "face/server/hub/machine_threads.hpp"
#include "face/server/hub/part.hpp"
#include "face/server/hub/preview.hpp"
#include "face/server/protocol/state_document.hpp"
#include "face/server/store/machine_store.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/panel/snapshot.hpp"

namespace kerf::server {

class Client;

/// A machine as the thread of the sockets knows it: its newest snapshot, who watches and operates
/// it, and the preview of its program. The machine itself is the runner's.
class MachineRecord {
 public:
  MachineRecord(const StoredMachine& stored, std::shared_ptr<Runner> runner, MachineThread& thread);
  ~MachineRecord() {
    cancel_preview();
    cancel_part();
    cancel_scene();
  }

  std::string name;
  std::string kind;
  std::string toml;
  machine::MachineDefinition definition;
  std::shared_ptr<Runner> runner;
  MachineThread* thread;

  std::shared_ptr<const machine::Snapshot> snapshot;  ///< null: none has come yet
  std::string fault;                                  ///< the machine runs no more
  std::string unsaved;                                ///< why its memory is not on the disk
  Client* op = nullptr;                               ///< who operates it
  struct OperationRequest {
    Client* client;   ///< who wants to operate it
    double until_ms;  ///< of the server's clock; then it is his
  };
  std::optional<OperationRequest> request;  ///< only while somebody else operates it
  std::vector<Client*> watchers;
  std::optional<LoadedProgram> program;
  std::shared_ptr<Preview> preview;
  std::optional<PreviewState> path;
  std::uint32_t preview_run = 0;
  double preview_began_ms = 0;            ///< of the server's clock
  bool is_preview_out_of_date = false;    ///< inputs were given since
  std::optional<PartSource> part_source;  ///< none: nothing is loaded
  std::shared_ptr<Part> part;             ///< null: nobody has asked to see it
  std::uint32_t part_number = 0;          ///< of the last one
  std::shared_ptr<FeatureScene> scene;    ///< null: nobody has asked for its features
  std::uint32_t feature_revision = 0;     ///< of what a scene is made of
  std::vector<machine::Breakpoint> breakpoint_list;
  Json breakpoints = Json::array();

  /// The state brought up to date; a client asks for it when he can be sent something.
  [[nodiscard]] const StateDocument& state();
  /// Something of the state may be other than it was: its watchers get it.
  void touch();
  [[nodiscard]] std::uint64_t touched() const { return touched_; }

  /// The preview is to be made once more, at this time of the server's clock: soon after the first
  /// signal, and not for each of many.
  [[nodiscard]] bool wants_preview(double now_ms) const;

  /// Of its program; where that shows none, or there is no program, its own.
  [[nodiscard]] const std::string& dialect() const;
  [[nodiscard]] Json path_event() const;
  /// A row of `machines`.
  [[nodiscard]] Json row() const;
  void cancel_preview() {
    if (preview) preview->cancel();
  }
  void cancel_part() {
    if (part) part->live.cancel();
  }
  void cancel_scene() {
    if (scene) scene->unwanted.request_stop();
  }

 private:
  StateDocument document_;
  std::uint64_t touched_ = 1;
  std::uint64_t documented_ = 0;
};

}  // namespace kerf::server
