#include "machine/panel/internal/table_image.hpp"

#include <cassert>
#include <type_traits>
#include <vector>

#include "control/core/offset_parts.hpp"

namespace kerf::machine {
namespace {

// Of a memory that is only read the numbers themselves are not handed out.
template <typename Rows, typename Each>
void for_each_part(Rows& rows, const Each& each) {
  for (auto& row : rows)
    for (const auto& part : control::parts_of(row)) {
      if constexpr (std::is_const_v<Rows>) {
        each(part.value(row));
      } else {
        each(part.of(row));
      }
    }
}

// Calls `each` with every number of the tables, always in the same order.
template <typename Memory, typename Each>
void for_each_number(Memory& memory, const Each& each) {
  const auto axes = [&](auto& vector) {
    for (auto& value : vector.values) each(value);
  };
  axes(memory.external);
  for (auto& system : memory.work) axes(system);
  for (auto& system : memory.extended) axes(system);
  for_each_part(memory.tools, each);
  for_each_part(memory.turning, each);
  each(memory.parts);
  each(memory.parts_required);
  each(memory.running_hours);
}

std::vector<double> numbers_of(const control::Memory& memory) {
  std::vector<double> numbers;
  for_each_number(memory, [&](double value) { numbers.push_back(value); });
  return numbers;
}

}  // namespace

std::shared_ptr<const TableImage> TableImage::of(const control::Memory& memory,
                                                 const std::shared_ptr<const TableImage>& before) {
  if (before && before->revision_ == memory.revision) {
    assert(before->shows(memory));  // whoever changes the tables counts it
    return before;
  }
  auto image = std::make_shared<TableImage>();
  image->revision_ = memory.revision;
  image->numbers_ = VariableImage::of(numbers_of(memory), before ? before->numbers_ : nullptr);
  image->names_ = before && *before->names_ == memory.names
                      ? before->names_
                      : std::make_shared<const Names>(memory.names);
  return image;
}

bool TableImage::shows(const control::Memory& memory) const {
  return numbers_->shows(numbers_of(memory)) && *names_ == memory.names;
}

void TableImage::put_back(control::Memory& memory) const {
  const std::vector<double> numbers = numbers_->values();
  auto next = numbers.begin();
  for_each_number(memory, [&](double& value) { value = *next++; });
  memory.names = *names_;
  ++memory.revision;
}

}  // namespace kerf::machine
