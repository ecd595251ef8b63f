#pragma once

#include <optional>
#include <string>

#include "drawing/image/picture.hpp"

namespace kerf::drawing {

/// Why a picture of this size is not read.
[[nodiscard]] std::optional<std::string> objection_to_size(std::uint64_t width,
                                                           std::uint64_t height);

[[nodiscard]] inline tl::unexpected<base::Failure> bad_picture(std::string sentence) {
  return tl::unexpected(base::Failure{base::Failure::Kind::input, std::move(sentence)});
}

[[nodiscard]] inline base::Outcome<PictureFacts> of_sound_size(const PictureFacts& facts) {
  if (const auto wrong = objection_to_size(facts.width, facts.height)) return bad_picture(*wrong);
  return facts;
}

}  // namespace kerf::drawing
