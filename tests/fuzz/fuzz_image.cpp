// Any bytes as a picture: a sentence, or as many grey pixels as its head has said.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "drawing/image/picture.hpp"

namespace {

using namespace kerf;

constexpr std::uint64_t kMostPixelsHere = 1'000'000;  // larger ones take their time

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto facts = drawing::picture_facts(bytes);
  if (!facts) require(!facts.error().message.empty());
  if (facts && std::uint64_t{facts->width} * facts->height > kMostPixelsHere) return 0;
  const auto grey = drawing::read_grey(bytes);
  if (!grey) {
    require(!grey.error().message.empty());
    return 0;
  }
  require(facts.has_value());
  require(grey->facts.width == facts->width && grey->facts.height == facts->height);
  require(grey->pixels.size() == std::size_t{facts->width} * facts->height);
  return 0;
}
