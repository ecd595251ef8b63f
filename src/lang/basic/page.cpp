#include "lang/basic/page.hpp"

namespace kerf::basic {
namespace {

template <typename T>
std::size_t bytes_of(const std::vector<T>& items) {
  return items.capacity() * sizeof(T);
}

}  // namespace

void BasicPage::clear() {
  clear_code();
  statements.clear();
  items.clear();
  texts.clear();
  labels.clear();
}

std::size_t BasicPage::bytes() const {
  std::size_t bytes = sizeof(*this) + bytes_of(instructions) + bytes_of(spans) +
                      bytes_of(constants) + bytes_of(marks) + bytes_of(failures) +
                      bytes_of(statements) + bytes_of(items) + bytes_of(texts) + bytes_of(labels);
  for (const std::string& text : texts) bytes += text.capacity();
  return bytes;
}

}  // namespace kerf::basic
