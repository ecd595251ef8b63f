#include "job/internal/threads.hpp"

#include "stock/turned/turned_part.hpp"

namespace kerf::job {

std::vector<output::StockFacts::Thread> threads_of(const stock::Model& model,
                                                   const stock::Cutter& cutter) {
  std::vector<output::StockFacts::Thread> out;
  const auto* const part = dynamic_cast<const stock::turned::TurnedPart*>(&model);
  if (part == nullptr) return out;
  for (const stock::turned::TurnedThread& thread : part->threads()) {
    const auto block = cutter.threads().find(thread.motion);
    out.push_back({.line = block == cutter.threads().end() ? 0 : block->second.line,
                   .axis = thread.axis,
                   .from = thread.from,
                   .to = thread.to,
                   .major = thread.major,
                   .minor = thread.minor,
                   .pitch = thread.pitch,
                   .starts = thread.starts,
                   .volume_mm3 = thread.volume_mm3});
  }
  return out;
}

}  // namespace kerf::job
