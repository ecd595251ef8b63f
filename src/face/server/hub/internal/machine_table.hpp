#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "face/server/hub/internal/clients.hpp"
#include "face/server/hub/machine_record.hpp"
#include "face/server/store/thread_check.hpp"

namespace kerf::server {

/// The machines that a server has, by their names, with what their threads tell of them. Belongs to
/// the thread of the sockets.
class MachineTable {
 public:
  using Records = std::map<std::string, std::unique_ptr<MachineRecord>>;

  /// `everybody` is told which machines there are, and must outlive this.
  explicit MachineTable(const Clients& everybody) : everybody_(everybody) {}

  /// Null: there is none of this name.
  [[nodiscard]] MachineRecord* find(const std::string& name) const;
  [[nodiscard]] const Records& records() const { return records_; }
  MachineRecord& add(std::unique_ptr<MachineRecord> record);
  void erase(const std::string& name) { records_.erase(name); }

  /// The machine of this name is being made or removed from now on. False: it is already.
  [[nodiscard]] bool begin_change(const std::string& name) {
    return under_way_.insert(name).second;
  }
  void end_change(const std::string& name) { under_way_.erase(name); }
  [[nodiscard]] bool is_changing(const std::string& name) const {
    return under_way_.contains(name);
  }
  /// There is no room for another one.
  [[nodiscard]] bool is_full() const {
    return records_.size() + under_way_.size() >= limits::kMachines;
  }

  /// As the event `machines` has them.
  [[nodiscard]] Json rows() const;
  /// To everybody who is connected.
  void tell() const;

  void published(const std::vector<Publication>& publications);
  /// Why the memory of a machine cannot be written; empty: it is on the disk again.
  void unsaved(const std::string& name, const std::string& trouble);

 private:
  const Clients& everybody_;
  ThreadCheck thread_{"that of the sockets"};
  Records records_;
  std::set<std::string> under_way_;
};

}  // namespace kerf::server
