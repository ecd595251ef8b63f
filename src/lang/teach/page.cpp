#include "lang/teach/page.hpp"

namespace kerf::teach {

void TeachPage::clear() {
  clear_code();
  blocks.clear();
  next = {};
  last = false;
}

std::size_t TeachPage::bytes() const { return bytes_of_code() + bytes_of(blocks); }

}  // namespace kerf::teach
