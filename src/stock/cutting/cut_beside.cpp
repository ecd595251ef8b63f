#include "stock/cutting/cut_beside.hpp"

#include <system_error>

namespace kerf::stock {
namespace {

/// A model has a helper, until what it does has ended.
class WithHelper {
 public:
  WithHelper(Model& model, base::Helper& helper) : model_(model), helper_(helper) {
    model.use(&helper);
  }
  ~WithHelper() {
    model_.use(nullptr);
    helper_.end();
  }
  WithHelper(const WithHelper&) = delete;
  WithHelper& operator=(const WithHelper&) = delete;

 private:
  Model& model_;
  base::Helper& helper_;
};

}  // namespace

void CutBeside::begin(Model& model, std::span<const Sweep> sweeps, std::span<Outcome> outcomes) {
  const auto cut = [this, &model, sweeps, outcomes] {
    const WithHelper helped(model, helper_);
    model.cut(sweeps, outcomes);
  };
  helper_.begin();
  try {
    cutting_ = std::async(std::launch::async, cut);
  } catch (const std::system_error&) {
    cut();  // the computer gives no more threads
  }
}

void CutBeside::await() {
  if (!cutting_.valid()) return;
  helper_.wait();
  cutting_.get();
}

}  // namespace kerf::stock
