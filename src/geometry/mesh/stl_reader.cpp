#include "geometry/mesh/stl_reader.hpp"

#include <algorithm>
#include <utility>

#include "geometry/mesh/internal/stl_triangles.hpp"

namespace kerf::mesh {
namespace {

// So much of a file says what it is: a binary one has bytes behind its head that are no text.
constexpr std::size_t kTelling = 1024;

bool begins_with_solid(std::string_view head) {
  constexpr std::string_view kSolid = "solid";
  const std::size_t at = std::min(head.find_first_not_of(" \t\r\n"), head.size());
  head.remove_prefix(at);
  return head.size() >= kSolid.size() && std::equal(kSolid.begin(), kSolid.end(), head.begin(),
                                                    [](char a, char b) { return a == lower(b); });
}

bool is_text(std::string_view head) {
  return std::none_of(head.begin(), head.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code == 0x7F || (code < ' ' && (code < '\t' || code > '\r'));
  });
}

bool has_binary_size(std::string_view head, std::uint64_t size) {
  return head.size() >= BinaryStl::kHead &&
         size == BinaryStl::kHead + BinaryStl::count_in(head) * BinaryStl::kRecord;
}

}  // namespace

StlReader::StlReader(const Settings& settings) : settings_(settings) {}
StlReader::~StlReader() = default;

void StlReader::begin() {
  const bool is_binary =
      has_binary_size(head_, settings_.size) || !begins_with_solid(head_) || !is_text(head_);
  if (is_binary) {
    triangles_ = std::make_unique<BinaryStl>(settings_);
  } else {
    triangles_ = std::make_unique<TextStl>(settings_);
  }
  wrong_ = triangles_->take(head_);
}

bool StlReader::take(std::string_view bytes) {
  if (triangles_ == nullptr) {
    const std::size_t missing = std::min(kTelling - head_.size(), bytes.size());
    head_ += bytes.substr(0, missing);
    bytes.remove_prefix(missing);
    if (head_.size() == kTelling) begin();
  }
  if (!wrong_ && triangles_ != nullptr) wrong_ = triangles_->take(bytes);
  return !wrong_;
}

base::Outcome<TriangleMesh> StlReader::finish() {
  if (triangles_ == nullptr) begin();
  if (!wrong_) wrong_ = triangles_->end();
  if (wrong_) return tl::unexpected(base::Failure{base::Failure::Kind::input, *wrong_});
  return std::move(*triangles_).mesh();
}

}  // namespace kerf::mesh
