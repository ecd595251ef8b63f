#include "lang/basic/page.hpp"

namespace kerf::basic {

void BasicPage::clear() {
  clear_code();
  statements.clear();
  items.clear();
  texts.clear();
  labels.clear();
}

std::size_t BasicPage::bytes() const {
  std::size_t bytes = sizeof(*this) + bytes_of_code() + bytes_of(statements) + bytes_of(items) +
                      bytes_of(texts) + bytes_of(labels);
  for (const std::string& text : texts) bytes += text.capacity();
  return bytes;
}

}  // namespace kerf::basic
