#include "drawing/dxf/internal/block_table.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/dxf/internal/layer_table.hpp"

namespace kerf::drawing::dxf {
namespace {

constexpr int kExternal = 4;  // flags of a BLOCK
constexpr int kOverlaid = 8;
enum State : int { unseen, in_work, weighed };

/// Long ones count for more: what a budget is for are memory and time.
double weight_of(const Record& record) {
  constexpr double kGroupsOfOne = 32;
  return 1 + std::floor(static_cast<double>(record.groups().size()) / kGroupsOfOne);
}

double count_of(double number) { return number >= 1 ? std::floor(number) : 1; }

}  // namespace

/// A block that is being weighed, and which of its entries is next.
struct BlockTable::Visit {
  Block* block;
  std::size_t next = 0;
  double sum = 0;
};

Grid grid_of(const Record& insert) {
  return {count_of(insert.number(70, 1)), count_of(insert.number(71, 1))};
}

void BlockTable::begin(const Record& block) {
  const auto [entry, is_new] = blocks_.try_emplace(key_of(words_(block.text(2))));
  open_ = is_new ? &entry->second : nullptr;
  if (!is_new) return;
  in_order_.push_back(open_);
  open_->base = block.point(10);
  open_->is_elsewhere = block.flag(70, kExternal | kOverlaid);
}

void BlockTable::add(const Record& record) {
  if (open_ != nullptr) open_->entries.push_back({record.compact()});
}

Block* BlockTable::entry(std::string_view raw) {
  const auto found = blocks_.find(key_of(words_(raw)));
  return found == blocks_.end() ? nullptr : &found->second;
}

Block* BlockTable::child_of(const Record& record) {
  return record.kind() == "INSERT" ? entry(record.text(2)) : nullptr;
}

void BlockTable::weigh() {
  for (Block* block : in_order_)
    if (states_[block] == unseen) weigh(*block);
  states_.clear();
}

// Depth first, with a stack of our own: blocks may be nested as deep as the file is long.
void BlockTable::weigh(Block& root) {
  std::vector<Visit> stack{{&root}};
  states_[&root] = in_work;
  while (!stack.empty()) {
    Visit& visit = stack.back();
    if (visit.next == visit.block->entries.size()) {
      visit.block->weight = visit.sum;
      states_[visit.block] = weighed;
      stack.pop_back();
      continue;
    }
    Block::Entry& entry = visit.block->entries[visit.next];
    Block* const child = child_of(entry.record);
    const int state = child == nullptr ? weighed : states_[child];
    if (state == unseen) {
      states_[child] = in_work;
      stack.push_back({child});
      continue;
    }
    entry.is_circular = state == in_work;
    const Grid grid = grid_of(entry.record);
    const double of_child =
        child == nullptr || entry.is_circular ? 0 : child->weight * grid.columns * grid.rows;
    visit.sum += weight_of(entry.record) + of_child;
    ++visit.next;
  }
}

}  // namespace kerf::drawing::dxf
