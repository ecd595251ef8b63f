#include "job/internal/threads_of.hpp"

#include "stock/turnmill/turn_mill_part.hpp"

namespace kerf::job {
namespace {

const stock::turned::TurnedPart* profile_of(const stock::Model& model) {
  if (const auto* const part = dynamic_cast<const stock::turnmill::TurnMillPart*>(&model))
    return &part->profile();
  return dynamic_cast<const stock::turned::TurnedPart*>(&model);
}

}  // namespace

std::vector<output::StockFacts::Thread> threads_of(const stock::Model& model,
                                                   const stock::Cutter& cutter) {
  std::vector<output::StockFacts::Thread> out;
  const stock::turned::TurnedPart* const part = profile_of(model);
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
