#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace kerf::machine {

[[nodiscard]] inline bool is_zip(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

/// The first file of an archive whose name ends in .json, unpacked. Error: a sentence without a
/// full stop: the archive is damaged or has none, or the file is larger than `most_bytes`.
[[nodiscard]] tl::expected<std::string, std::string> json_in_zip(const std::string& bytes,
                                                                 std::size_t most_bytes);

}  // namespace kerf::machine
