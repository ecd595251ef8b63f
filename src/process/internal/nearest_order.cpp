#include "process/internal/nearest_order.hpp"

#include "process/internal/near_tree.hpp"

namespace kerf::process::ordering {
namespace {

std::vector<Vec2> beginnings(const FlatItems& items) {
  std::vector<Vec2> all;
  all.reserve(items.entries().size());
  for (const Entry& entry : items.entries()) all.push_back(entry.begin);
  return all;
}

class NearestOrder {
 public:
  NearestOrder(const FlatItems& items, const Ends& ends)
      : items_(items),
        at_(ends.from),
        beginnings_(beginnings(items)),
        tree_(beginnings_),
        awaited_(items.size()),
        is_made_(items.size()) {
    for (std::uint32_t item = 0; item < items.size(); ++item) {
      awaited_[item] = static_cast<std::uint32_t>(items.before(item).size());
      if (awaited_[item] > 0) offer(item, false);
    }
  }

  std::vector<Turn> find() {
    while (turns_.size() < items_.size()) {
      const std::uint32_t entry = tree_.nearest(at_);
      if (entry != kNone) {
        make(entry);
      } else {
        free_first();
      }
    }
    return std::move(turns_);
  }

 private:
  void offer(std::uint32_t item, bool is_offered) {
    for (std::uint32_t e = items_.first_entry(item); e < items_.end_entry(item); ++e)
      is_offered ? tree_.switch_on(e) : tree_.switch_off(e);
  }

  void make(std::uint32_t entry) {
    const std::uint32_t item = items_.owner(entry);
    turns_.push_back({item, entry - items_.first_entry(item)});
    at_ = items_.entries()[entry].end;
    is_made_[item] = true;
    offer(item, false);
    for (const std::uint32_t later : items_.after(item)) {
      if (--awaited_[later] == 0 && !is_made_[later]) offer(later, true);
    }
  }

  void free_first() {
    while (is_made_[first_]) ++first_;
    offer(first_, true);
  }

  const FlatItems& items_;
  Vec2 at_;
  std::vector<Vec2> beginnings_;
  NearTree tree_;
  std::vector<std::uint32_t> awaited_;  // how many of before() are still to be made
  std::vector<bool> is_made_;
  std::vector<Turn> turns_;
  std::uint32_t first_ = 0;  // all in front of it are made
};

}  // namespace

std::vector<Turn> nearest_order(const FlatItems& items, const Ends& ends) {
  return NearestOrder(items, ends).find();
}

}  // namespace kerf::process::ordering
