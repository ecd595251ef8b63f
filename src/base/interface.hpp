#pragma once

namespace kerf::base {

/// What others stand behind: destroyed through it, never copied.
class Interface {
 public:
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;
  virtual ~Interface() = default;

 protected:
  Interface() = default;
};

}  // namespace kerf::base
