#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf::planner {

/// A queue of bounded capacity whose items keep their number: the first item ever pushed is 0.
/// Allocates once, with its first item: what never runs costs nothing.
template <typename T>
class Ring {
 public:
  /// `capacity` is a power of two.
  explicit Ring(std::size_t capacity) : mask_(capacity - 1) {
    assert(capacity != 0 && (capacity & mask_) == 0);
  }

  [[nodiscard]] std::uint64_t begin() const { return begin_; }
  [[nodiscard]] std::uint64_t end() const { return end_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  [[nodiscard]] bool empty() const { return begin_ == end_; }
  [[nodiscard]] std::size_t room() const { return mask_ + 1 - size(); }

  [[nodiscard]] T& operator[](std::uint64_t number) {
    assert(number >= begin_ && number < end_);
    return items_[static_cast<std::size_t>(number) & mask_];
  }
  [[nodiscard]] const T& operator[](std::uint64_t number) const {
    assert(number >= begin_ && number < end_);
    return items_[static_cast<std::size_t>(number) & mask_];
  }
  [[nodiscard]] T& front() { return (*this)[begin_]; }
  [[nodiscard]] T& back() { return (*this)[end_ - 1]; }

  /// Makes room at the end for one more item, whose old contents stay. Precondition: room() > 0.
  T& push() {
    assert(room() > 0);
    if (items_.empty()) items_.resize(mask_ + 1);
    return items_[static_cast<std::size_t>(end_++) & mask_];
  }
  void push(const T& item) { push() = item; }
  void pop() {
    assert(!empty());
    ++begin_;
  }
  /// Takes the last item back.
  void unpush() {
    assert(!empty());
    --end_;
  }
  void clear() { begin_ = end_; }

 private:
  std::vector<T> items_;
  std::size_t mask_;
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace kerf::planner
