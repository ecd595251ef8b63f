#include "face/server/hub/internal/machine_table.hpp"

#include "face/server/hub/internal/console.hpp"

namespace kerf::server {

MachineRecord* MachineTable::find(const std::string& name) const {
  const auto found = records_.find(name);
  return found == records_.end() ? nullptr : found->second.get();
}

MachineRecord& MachineTable::add(std::unique_ptr<MachineRecord> record) {
  auto& place = records_[record->name];
  place = std::move(record);
  return *place;
}

Json MachineTable::rows() const {
  Json rows = Json::array();
  for (const auto& [name, machine] : records_) rows.push_back(machine->row());
  return rows;
}

void MachineTable::tell() const { everybody_.tell({{"event", "machines"}, {"machines", rows()}}); }

void MachineTable::published(const std::vector<Publication>& publications) {
  thread_.here();
  for (const Publication& publication : publications) {
    MachineRecord* const machine = find(publication.machine);
    if (machine == nullptr) continue;
    if (publication.snapshot) machine->snapshot = publication.snapshot;
    if (!publication.fault.empty()) {
      machine->fault = "fault of Kerf itself: " + publication.fault;
      tell_console(machine->name + ": " + machine->fault);
    }
    if (publication.snapshot || !publication.fault.empty()) machine->touch();
  }
}

// Everybody who watches it sees it while it lasts.
void MachineTable::unsaved(const std::string& name, const std::string& trouble) {
  thread_.here();
  MachineRecord* const machine = find(name);
  if (machine == nullptr) return;
  tell_console("the memory of " + name +
               (trouble.empty() ? " is on the disk again" : " cannot be written: " + trouble));
  machine->unsaved = trouble;
  machine->touch();
}

}  // namespace kerf::server
