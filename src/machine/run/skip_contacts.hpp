#pragma once

#include <deque>
#include <optional>

#include "base/point.hpp"

namespace kerf::machine {

/// Where the skip signal of a probing move comes on: the machine position of an axis.
struct SkipContact {
  base::Axis axis{};
  double machine = 0;
};

/// Skip signals that are to come. They are used up in order: the next one waits until a probing
/// move passes it.
class SkipContacts {
 public:
  void add(const SkipContact& contact) { waiting_.push_back(contact); }
  /// Along a move of machine coordinates: the fraction of its length where the next one comes on.
  [[nodiscard]] std::optional<double> meet(const base::MachinePoint& from,
                                           const base::MachinePoint& to);

 private:
  std::deque<SkipContact> waiting_;
};

}  // namespace kerf::machine
