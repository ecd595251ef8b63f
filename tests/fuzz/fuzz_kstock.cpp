// Any bytes as a .kstock: a sentence, or a part whose model can be made and cut, which is saved as
// the same bytes again. The first byte says what the others are: a file; or a head and unpacked
// records, each behind its length in two bytes, which become a file with the right frame and sum,
// so that what is looked at lies behind them.
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "stock/saved/part_file.hpp"
#include "stock/sheet/sheet.hpp"

namespace {

using namespace kerf;
using stock::saved::ReadPart;

constexpr std::size_t kRoom = 2 << 20;
constexpr std::size_t kLargestModel = 1 << 20;

void require(bool condition) {
  if (!condition) std::abort();
}

void put_word(std::string& out, std::uint32_t word) {
  for (unsigned i = 0; i < 4; ++i) out += static_cast<char>(word >> (8 * i) & 0xFFU);
}

std::string packed(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  compress2(reinterpret_cast<Bytef*>(out.data()), &size,
            reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()), 1);
  out.resize(size);
  return out;
}

/// The next part of the input: its length in two bytes, at most what is left.
std::string_view next_part(std::string_view& rest) {
  if (rest.size() < 2) return std::exchange(rest, {});
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(rest[i]));
  };
  const std::size_t size = std::min(byte(0) | byte(1) << 8U, rest.size() - 2);
  const std::string_view part = rest.substr(2, size);
  rest.remove_prefix(2 + size);
  return part;
}

/// A record of one byte alone is a number between the records.
std::string framed(std::string_view rest) {
  const std::string_view head = next_part(rest);
  std::string file = "KSTOCK1\n";
  put_word(file, static_cast<std::uint32_t>(head.size()));
  file += head;
  while (!rest.empty()) {
    const std::string_view part = next_part(rest);
    if (part.size() == 1) {
      const auto number = static_cast<unsigned char>(part[0]);
      put_word(file, number == 0xFF ? 0xFFFF'FFFFU : number);
      continue;
    }
    const std::string record = packed(part);
    put_word(file, static_cast<std::uint32_t>(record.size()));
    file += record;
  }
  put_word(file, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(file.data()),
                                                  static_cast<uInt>(file.size()))));
  return file;
}

base::Outcome<ReadPart> read(std::string_view bytes, std::size_t piece) {
  std::size_t at = 0;
  return stock::saved::read_part(
      [&](std::span<char> into) {
        const std::size_t count = std::min({into.size(), bytes.size() - at, piece});
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), count, into.begin());
        at += count;
        return count;
      },
      kRoom);
}

std::string saved(const ReadPart& part, const stock::Model& model) {
  std::string bytes;
  stock::saved::write_part(part.label, model, [&](std::string_view more) { bytes += more; });
  return bytes;
}

/// A straight cut through the middle of its box.
void cut(stock::Model& model, const stock::Bounds& box) {
  stock::Body body;
  const double r = std::max(0.5, (box.high.x - box.low.x) / 8);
  body.profile = stock::Profile(
      {{{0, 0}, {r, 0}, 0, stock::ToolPart::edge}, {{r, 0}, {r, 1e4}, 0, stock::ToolPart::edge}});
  const stock::Vec3 middle = 0.5 * (box.low + box.high);
  const stock::Sweep sweep{.way = stock::StraightWay{middle, {box.high.x, middle.y, middle.z}},
                           .body = model.add_body(body),
                           .motion = 1};
  if (!model.can_cut(sweep)) return;
  stock::Outcome outcome;
  model.cut({&sweep, 1}, {&outcome, 1});
}

void check_model(const ReadPart& part) {
  if (part.part->bytes() > kLargestModel) return;
  const auto model = part.part->model(1);
  if (!model) return;  // a sheet
  require(std::isfinite(model->left_mm3()));
  const std::string bytes = saved(part, *model);
  const auto again = read(bytes, bytes.size());
  require(again && saved(*again, *again->part->model(1)) == bytes);
  cut(*model, part.part->box());
  require(std::isfinite(model->left_mm3()));
}

void check_places(const ReadPart& part) {
  if (part.part->bytes() > kLargestModel / 16) return;
  for (const double degrees : {90.0, 180.0}) {
    for (const stock::Vec3 turn : {stock::Vec3{degrees, 0, 0}, {0, degrees, 0}, {0, 0, degrees}}) {
      const auto there = part.part->placed(stock::Placing({{}, turn}));
      if (there) require(there->volume_mm3() == part.part->volume_mm3());
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::string file = (data[0] & 1U) != 0 ? framed(rest) : std::string(rest);
  const auto part = read(file, file.size());
  const auto in_pieces = read(file, 5);
  require(part.has_value() == in_pieces.has_value());
  if (!part) {
    require(!part.error().message.empty() && part.error().message == in_pieces.error().message);
    return 0;
  }
  check_model(*part);
  check_places(*part);
  return 0;
}
