#include "face/server/store/memory_keeper.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace kerf::server {
namespace {

// Bit by bit: a vacant variable is NaN, which is unlike itself.
bool same_permanent_variables(const control::Memory& a, const control::Memory& b) {
  return std::equal(a.commons.begin() + control::kVolatileCommons, a.commons.end(),
                    b.commons.begin() + control::kVolatileCommons, [](double x, double y) {
                      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
                    });
}

}  // namespace

bool keeps_the_same(const control::Memory& a, const control::Memory& b) {
  constexpr double kMinute_h = 1.0 / 60;
  return same_permanent_variables(a, b) && a.external == b.external && a.work == b.work &&
         a.extended == b.extended && a.tools == b.tools && a.turning == b.turning &&
         a.parts == b.parts && a.parts_required == b.parts_required && a.names == b.names &&
         std::abs(a.running_hours - b.running_hours) < kMinute_h;
}

void MemoryKeeper::know(const std::string& machine, const control::Memory& on_disk) {
  const std::lock_guard lock(guard_);
  entries_[machine].on_disk = std::make_shared<control::Memory>(on_disk);
}

void MemoryKeeper::forget(const std::string& machine) {
  const std::lock_guard lock(guard_);
  entries_.erase(machine);
}

bool MemoryKeeper::is_on_disk(const std::string& machine, const control::Memory& memory) const {
  const std::lock_guard lock(guard_);
  const auto found = entries_.find(machine);
  return found != entries_.end() && found->second.on_disk &&
         keeps_the_same(*found->second.on_disk, memory);
}

// What is the same object need not be compared: a machine at rest offers it again and again.
void MemoryKeeper::offer(const std::string& machine, Memory memory) {
  {
    const std::lock_guard lock(guard_);
    const auto found = entries_.find(machine);
    if (found == entries_.end()) return;
    Entry& entry = found->second;
    if (entry.on_disk == memory || Clock::now() < entry.not_before) return;
    entry.offered = std::move(memory);
    if (entry.posted) return;
    entry.posted = true;
  }
  disk_.post([this, machine] { write_offered(machine); });
}

void MemoryKeeper::write_offered(const std::string& machine) {
  Memory memory;
  {
    const std::lock_guard lock(guard_);
    const auto found = entries_.find(machine);
    if (found == entries_.end()) return;
    found->second.posted = false;
    memory = std::move(found->second.offered);
  }
  static_cast<void>(write(machine, *memory));
}

base::Outcome<void> MemoryKeeper::write(const std::string& machine, const control::Memory& memory) {
  if (is_on_disk(machine, memory)) return {};
  auto written = write_(machine, memory);
  note(machine, written ? std::make_shared<control::Memory>(memory) : nullptr,
       written ? std::string() : written.error().message);
  return written;
}

void MemoryKeeper::note(const std::string& machine, const Memory& memory,
                        const std::string& trouble) {
  {
    const std::lock_guard lock(guard_);
    const auto found = entries_.find(machine);
    if (found == entries_.end()) return;
    Entry& entry = found->second;
    entry.on_disk = memory;
    entry.pause = trouble.empty() ? std::chrono::seconds{0}
                                  : std::clamp(2 * entry.pause, kFirstPause, kLongestPause);
    entry.not_before = Clock::now() + entry.pause;
    if (entry.trouble == trouble) return;
    entry.trouble = trouble;
  }
  tell_(machine, trouble);
}

}  // namespace kerf::server
