#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "face/server/hub/feature_scene.hpp"
#include "face/server/hub/internal/answers.hpp"
#include "face/server/hub/internal/machine_table.hpp"
#include "face/server/store/library.hpp"
#include "face/server/store/thread_check.hpp"
#include "face/server/store/worker.hpp"

namespace kerf::server {

/// What the programs that machines have loaded machine, and what edits would make of it: recognised
/// when somebody asks, one scene of each machine, kept while it holds and somebody watches. Belongs
/// to the thread of the sockets.
class Features {
 public:
  static constexpr std::size_t kMostScenes = 8;  ///< kept of all machines

  /// What it needs of its server.
  struct Surroundings {
    Library& library;
    MachineTable& machines;
    const Answers& answers;
    Worker& disk;    ///< reads set-ups
    Worker& worker;  ///< runs, recognises and tries edits
  };
  /// They must outlive this, but for the workers, whose jobs use it.
  explicit Features(Surroundings around) : around_(around) {}

  /// What scenes are made of has changed: all watchers are told, and who waits for the one before
  /// waits for the next one.
  void renew(MachineRecord& machine);
  void cancel() const;
  /// What time brings: scenes of machines that nobody watches.
  void tick();

  using Scene = std::shared_ptr<FeatureScene>;
  /// Goes on with the scene of the machine when it is made, or with why there is none.
  void with_scene(MachineRecord& machine, FeatureScene::Waiting go_on);

  // Commands

  void features(const Request& request);
  void preview(const Request& request);
  void insight(const Request& request);

 private:
  /// A preview that is not answered yet.
  struct Trial {
    Reply reply;
    std::stop_source stop{};
  };

  void make(MachineRecord& machine, std::vector<FeatureScene::Waiting> waiting);
  void ran(const std::string& name, const Scene& scene, std::string insight);
  void made(const std::string& name, const Scene& scene, FeatureScene::Made made);
  void drop(MachineRecord& machine);
  void make_room();
  void tell(const Request& request, const Scene& scene);
  void send(const Reply& reply, const std::string& members) const;
  void tell_insights();
  [[nodiscard]] bool tell_insight(const Request& request);
  void try_edits(const Request& request, const std::shared_ptr<Trial>& trial, const Scene& scene);
  void tried(const Client* client, const std::shared_ptr<Trial>& trial, std::string answer);

  Surroundings around_;
  ThreadCheck thread_{"that of the sockets"};
  std::map<const Client*, std::shared_ptr<Trial>> trials_;
  std::vector<Request> insights_;  // that wait for a run or a preview run
  std::uint64_t uses_ = 0;
};

}  // namespace kerf::server
