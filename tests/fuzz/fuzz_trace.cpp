// Any bytes as a lens trace: sentences with a place, and a drawing whose numbers are sound.
#include "drawing/trace/trace_reader.hpp"
#include "drawing_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kerf::fuzz::read(kerf::drawing::read_trace, data, size);
  return 0;
}
