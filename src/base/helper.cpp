#include "base/helper.hpp"

#include <utility>

namespace kerf::base {

void Helper::begin() {
  const std::scoped_lock lock(mutex_);
  lasts_ = true;
}

void Helper::end() {
  {
    const std::scoped_lock lock(mutex_);
    lasts_ = false;
  }
  changed_.notify_all();
}

void Helper::wait() {
  std::unique_lock lock(mutex_);
  while (lasts_) {
    changed_.wait(lock, [this] { return !lasts_ || part_ != nullptr; });
    const auto* const part = std::exchange(part_, nullptr);
    if (part == nullptr) continue;
    is_inside_ = true;
    lock.unlock();
    (*part)();
    lock.lock();
    is_inside_ = false;
    changed_.notify_all();
  }
}

void Helper::offer(const std::function<void()>& part) {
  {
    const std::scoped_lock lock(mutex_);
    part_ = &part;
  }
  changed_.notify_all();
}

void Helper::withdraw() {
  std::unique_lock lock(mutex_);
  part_ = nullptr;
  changed_.wait(lock, [this] { return !is_inside_; });
}

}  // namespace kerf::base
