#include <algorithm>
#include <bit>

#include "geometry/mesh/internal/stl_triangles.hpp"

namespace kerf::mesh {
namespace {

using geometry::Vec3;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8U | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

double float_at(std::string_view bytes, std::size_t at) {
  return double{std::bit_cast<float>(word_at(bytes, at))};
}

}  // namespace

std::uint64_t BinaryStl::count_in(std::string_view head) { return word_at(head, 80); }

Wrong BinaryStl::take(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t whole = has_begun_ ? kRecord : kHead;
    const bool is_carried = !carried_.empty() || bytes.size() < whole;
    const std::size_t used = std::min(whole - carried_.size(), bytes.size());
    if (is_carried) carried_ += bytes.substr(0, used);
    if (!is_carried || carried_.size() == whole) {
      if (auto wrong = use(is_carried ? std::string_view(carried_) : bytes)) return wrong;
      carried_.clear();
    }
    bytes.remove_prefix(used);
  }
  return std::nullopt;
}

Wrong BinaryStl::use(std::string_view piece) {
  if (!has_begun_) return begin(piece);
  ++read_;
  constexpr std::size_t kNormal = 12;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t at = kNormal + 12 * i;
    const Vec3 corner{float_at(piece, at), float_at(piece, at + 4), float_at(piece, at + 8)};
    if (auto wrong = add_corner(corner)) return "triangle " + std::to_string(read_) + ": " + *wrong;
  }
  return std::nullopt;
}

/// The count is held against what is there before anything is made room for.
Wrong BinaryStl::begin(std::string_view head) {
  has_begun_ = true;
  expected_ = count_in(head);
  const std::uint64_t room = settings().size - std::min<std::uint64_t>(kHead, settings().size);
  if (room != expected_ * kRecord) {
    return "the file is no sound STL: it says that it has " + std::to_string(expected_) +
           " triangles, which are " + std::to_string(expected_ * kRecord) + " bytes, and " +
           std::to_string(room) + " bytes are there";
  }
  if (expected_ > settings().most_triangles) {
    return std::to_string(expected_) + " triangles are more than the " +
           std::to_string(settings().most_triangles) + " that there is memory for";
  }
  reserve(expected_);
  return std::nullopt;
}

Wrong BinaryStl::end() {
  if (!has_begun_) return "the file is too short for an STL";
  if (read_ != expected_ || !carried_.empty()) return "the file ends within its triangles";
  return std::nullopt;
}

}  // namespace kerf::mesh
