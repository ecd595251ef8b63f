#include "stock/saved/internal/packing.hpp"

#include <zlib.h>

#include "stock/saved/internal/part_format.hpp"

namespace kerf::stock::saved {
namespace {

// Heights and places are smooth: more effort makes them hardly smaller.
constexpr int kEffort = 3;

Bytef* bytes_in(std::string& text) { return reinterpret_cast<Bytef*>(text.data()); }
const Bytef* bytes_in(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

}  // namespace

void PartPacker::put_out(std::string_view bytes) {
  sum_ = static_cast<std::uint32_t>(crc32(sum_, bytes_in(bytes), static_cast<uInt>(bytes.size())));
  take_(bytes);
}

void PartPacker::head(const std::string& json) {
  put_out(kMagic);
  number(static_cast<std::uint32_t>(json.size()));
  put_out(json);
}

void PartPacker::number(std::uint32_t value) {
  std::string word;
  put_word(word, value);
  put_out(word);
}

void PartPacker::record(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  packed_.resize(size);
  compress2(bytes_in(packed_), &size, bytes_in(bytes), static_cast<uLong>(bytes.size()), kEffort);
  number(static_cast<std::uint32_t>(size));
  put_out(std::string_view(packed_).substr(0, size));
}

void PartPacker::finish() {
  std::string word;
  put_word(word, sum_);
  take_(word);
}

}  // namespace kerf::stock::saved
