#pragma once

#include <stdexcept>
#include <string>
#include <thread>

namespace kerf::server {

/// Holds whoever uses something against the thread that owns it. The owner is the thread that calls
/// bind(), which comes before the first check.
class ThreadCheck {
 public:
  explicit ThreadCheck(const char* owner) : owner_(owner) {}

  void bind() { id_ = std::this_thread::get_id(); }
  /// Throws std::logic_error on any other thread: a fault of Kerf, told as such.
  void here() const {
    if (std::this_thread::get_id() != id_)
      throw std::logic_error(std::string("called on another thread than ") + owner_);
  }

 private:
  const char* owner_;
  std::thread::id id_ = std::this_thread::get_id();
};

}  // namespace kerf::server
