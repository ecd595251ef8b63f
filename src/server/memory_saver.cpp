#include "server/memory_saver.hpp"

namespace kerf::server {

void MemorySaver::save(const std::string& machine, std::shared_ptr<const control::Memory> memory) {
  {
    const std::lock_guard lock(guard_);
    if (!waiting_.insert_or_assign(machine, std::move(memory)).second) return;
  }
  disk_.post([this, machine] {
    std::unique_lock lock(guard_);
    const auto newest = waiting_.extract(machine).mapped();
    lock.unlock();
    if (auto written = store_.write_memory(machine, *newest); !written)
      tell_(written.error().message);
  });
}

}  // namespace kerf::server
