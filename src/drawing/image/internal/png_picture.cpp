#include "drawing/image/internal/png_picture.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>

#include "drawing/image/internal/grey.hpp"
#include "drawing/image/internal/size_check.hpp"

namespace kerf::drawing {
namespace {

/// What is left of the bytes, and what libpng has said. Its errors are jumps back to where
/// setjmp stands: what they pass has no destructors.
struct PngSource {
  std::string_view rest;
  char said[128] = {};
};

void give_bytes(png_structp png, png_bytep into, std::size_t count) {
  auto* source = static_cast<PngSource*>(png_get_io_ptr(png));
  if (source->rest.size() < count) png_error(png, "the file ends too early");
  std::memcpy(into, source->rest.data(), count);
  source->rest.remove_prefix(count);
}

[[noreturn]] void keep_error(png_structp png, png_const_charp words) {
  auto* source = static_cast<PngSource*>(png_get_error_ptr(png));
  std::strncpy(source->said, words, sizeof source->said - 1);
  png_longjmp(png, 1);
}

void drop_warning(png_structp, png_const_charp) {}

/// libpng's two handles. They are there after open(), or memory was short.
class PngReader {
 public:
  explicit PngReader(std::string_view bytes)
      : source_{bytes},
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, keep_error, drop_warning)),
        info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
    if (info_ == nullptr) return;
    png_set_read_fn(png_, &source_, give_bytes);
    png_set_user_limits(png_, kMostPixels, kMostPixels);
    png_set_chunk_malloc_max(png_, kMostOfAChunk);
    // Words, profiles and whatever else is packed: nothing of it is of use here.
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, kLeftOut, kLeftOutCount);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  /// Up to the first pixels.
  [[nodiscard]] bool open() {
    if (info_ == nullptr) return false;
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_info(png_, info_);
    return true;
  }
  /// All samples as bytes or pairs of bytes: those of the palette, of 1, 2 and 4 bits as they are
  /// but one a byte, with an alpha where the file has any.
  [[nodiscard]] bool prepare() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
    if (png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY)
      png_set_expand_gray_1_2_4_to_8(png_);
    if (png_get_valid(png_, info_, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(png_);
    png_read_update_info(png_, info_);
    return true;
  }
  [[nodiscard]] bool read_row(std::uint8_t* into) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_row(png_, into, nullptr);
    return true;
  }
  /// What stands behind the pixels, its sums included.
  [[nodiscard]] bool finish() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_end(png_, nullptr);
    return true;
  }

  [[nodiscard]] PictureFacts facts() const {
    PictureFacts facts;
    facts.kind = PictureKind::png;
    facts.width = png_get_image_width(png_, info_);
    facts.height = png_get_image_height(png_, info_);
    const double across = png_get_x_pixels_per_meter(png_, info_);
    const double down = png_get_y_pixels_per_meter(png_, info_);
    if (across > 0 && down > 0) facts.density = {across / 1000, down / 1000};
    return facts;
  }
  [[nodiscard]] bool is_interlaced() const {
    return png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
  }
  [[nodiscard]] std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
  [[nodiscard]] unsigned channels() const { return png_get_channels(png_, info_); }
  [[nodiscard]] unsigned bits() const { return png_get_bit_depth(png_, info_); }

  [[nodiscard]] tl::unexpected<base::Failure> refusal() const {
    return bad_picture(fmt::format("the PNG is damaged: {}",
                                   source_.said[0] != 0 ? source_.said : "it cannot be begun"));
  }

 private:
  static constexpr png_alloc_size_t kMostOfAChunk = 1 << 20;
  static constexpr int kLeftOutCount = 7;
  static constexpr png_byte kLeftOut[] = "iCCP\0tEXt\0zTXt\0iTXt\0sPLT\0hIST\0eXIf";

  PngSource source_;
  png_structp png_;
  png_infop info_;
};

/// Makes grey of a row's samples, `step` columns apart from `first` on.
class RowOfPng {
 public:
  explicit RowOfPng(const PngReader& reader)
      : channels_(reader.channels()), is_wide_(reader.bits() == 16) {}

  void put(const std::uint8_t* row, std::uint8_t* into, std::uint32_t count,
           std::uint32_t step) const {
    const std::uint32_t most = is_wide_ ? 65535 : 255;
    for (std::uint32_t i = 0; i < count; ++i)
      into[std::size_t{i} * step] = grey_of(sample(row, std::size_t{i} * channels_, most), most);
  }

 private:
  [[nodiscard]] std::uint32_t value(const std::uint8_t* row, std::size_t at) const {
    return is_wide_ ? std::uint32_t{row[2 * at]} << 8U | row[2 * at + 1] : row[at];
  }
  /// One or two channels are grey, three or four red, green and blue; the last of an even number
  /// is alpha.
  [[nodiscard]] Sample sample(const std::uint8_t* row, std::size_t at, std::uint32_t most) const {
    const bool has_alpha = channels_ % 2 == 0;
    const std::uint32_t alpha = has_alpha ? value(row, at + channels_ - 1) : most;
    if (channels_ <= 2) {
      const std::uint32_t grey = value(row, at);
      return {grey, grey, grey, alpha};
    }
    return {value(row, at), value(row, at + 1), value(row, at + 2), alpha};
  }

  unsigned channels_;
  bool is_wide_;
};

/// Every pixel of a pass comes alone, and goes where it belongs: no second picture is needed.
struct Pass {
  std::uint32_t first_row = 0;
  std::uint32_t row_step = 1;
  std::uint32_t first_column = 0;
  std::uint32_t column_step = 1;
};

std::vector<Pass> passes_of(bool is_interlaced) {
  if (!is_interlaced) return {{}};
  return {{0, 8, 0, 8}, {0, 8, 4, 8}, {4, 8, 0, 4}, {0, 4, 2, 4},
          {2, 4, 0, 2}, {0, 2, 1, 2}, {1, 2, 0, 1}};
}

bool read_pass(PngReader& reader, const Pass& pass, GreyPicture& picture,
               std::vector<std::uint8_t>& row) {
  const std::uint32_t width = picture.facts.width;
  if (pass.first_column >= width) return true;
  const std::uint32_t count = (width - pass.first_column + pass.column_step - 1) / pass.column_step;
  const RowOfPng grey(reader);
  for (std::uint32_t y = pass.first_row; y < picture.facts.height; y += pass.row_step) {
    if (!reader.read_row(row.data())) return false;
    grey.put(row.data(), &picture.pixels[std::size_t{y} * width + pass.first_column], count,
             pass.column_step);
  }
  return true;
}

}  // namespace

base::Outcome<PictureFacts> png_facts(std::string_view bytes) {
  PngReader reader(bytes);
  if (!reader.open()) return reader.refusal();
  return of_sound_size(reader.facts());
}

base::Outcome<GreyPicture> read_png(std::string_view bytes) {
  PngReader reader(bytes);
  if (!reader.open()) return reader.refusal();
  GreyPicture picture{reader.facts(), {}};
  const auto [width, height] = std::pair(picture.facts.width, picture.facts.height);
  if (const auto wrong = objection_to_size(width, height)) return bad_picture(*wrong);
  if (!reader.prepare()) return reader.refusal();
  picture.pixels.resize(std::size_t{width} * height);
  std::vector<std::uint8_t> row(reader.row_bytes());
  for (const Pass& pass : passes_of(reader.is_interlaced()))
    if (!read_pass(reader, pass, picture, row)) return reader.refusal();
  if (!reader.finish()) return reader.refusal();
  return picture;
}

}  // namespace kerf::drawing
