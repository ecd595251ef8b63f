#include "machine/run/skip_contacts.hpp"

namespace kerf::machine {

std::optional<double> SkipContacts::comes_on(const motion::SkipMove& move) {
  if (waiting_.empty()) return std::nullopt;
  const base::MachinePoint from = base::machine_of(move.from, move.length);
  const base::MachinePoint to = base::machine_of(move.to, move.length);
  const SkipContact& next = waiting_.front();
  const double begin = from[next.axis];
  const double end = to[next.axis];
  const bool passed = (begin <= next.machine && next.machine <= end) ||
                      (end <= next.machine && next.machine <= begin);
  if (!passed) return std::nullopt;
  const double fraction = begin == end ? 0 : (next.machine - begin) / (end - begin);
  waiting_.pop_front();
  return fraction;
}

}  // namespace kerf::machine
