#pragma once

#include <span>

#include "base/interface.hpp"
#include "stock/sweep/body.hpp"
#include "stock/sweep/sweep.hpp"

namespace kerf::stock {

/// Sees what a model gets, in the order in which it gets it.
class CutWatch : public base::Interface {
 public:
  /// Model::add_body(); they count from 0.
  virtual void added(const Body& body) = 0;
  /// These have been cut.
  virtual void cut(std::span<const Sweep> sweeps) = 0;
};

}  // namespace kerf::stock
