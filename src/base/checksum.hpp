#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kerf::base {

/// The checksum of zip files (CRC, 32 bits, polynomial 0xedb88320).
[[nodiscard]] std::uint32_t crc32(std::string_view bytes);

/// Eight lower-case digits.
[[nodiscard]] std::string hex_text(std::uint32_t value);

}  // namespace kerf::base
