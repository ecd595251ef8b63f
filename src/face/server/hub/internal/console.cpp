#include "face/server/hub/internal/console.hpp"

#include <cstdio>

#include "output/writing/diagnostic_text.hpp"

namespace kerf::server {

void tell_console(const std::string& sentence) {
  std::fprintf(stderr, "kerf: %s\n", output::printable(sentence).c_str());
}

}  // namespace kerf::server
