#pragma once

#include <string>

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "drive/pattern/codec.hpp"

namespace kerf::server {

// Patterns at the border of the server (docs/pattern.md): the library has the bytes of the
// engraver, whoever shows, edits or runs one has its listing. Both ways every bit is kept; what a
// listing has besides its records, comments and blank lines, no bytes can hold.

/// Longest one, in bytes: 1.4 million records, some hours of engraving.
inline constexpr std::uint64_t kMostPatternBytes = 4U << 20U;

/// Whether a program of the library is such bytes.
[[nodiscard]] bool is_pattern(const std::string& name);

/// The records of a pattern, one a line. Failure (usage): where the first wrong byte is, or that it
/// is too long.
[[nodiscard]] base::Outcome<std::string> listing_of(const base::SourceFile& pattern,
                                                    const std::string& name,
                                                    drive::ByteOrder order);
/// The same of bytes.
[[nodiscard]] base::Outcome<std::string> listing_of(const std::string& bytes,
                                                    const std::string& name,
                                                    drive::ByteOrder order);

/// The bytes of a listing. Failure (usage): where the first wrong line is, or that it is too long.
[[nodiscard]] base::Outcome<std::string> bytes_of(const std::string& listing,
                                                  const std::string& name, drive::ByteOrder order);

}  // namespace kerf::server
