#include "drawing/image/internal/jpeg_picture.hpp"

#include <fmt/format.h>
#include <jpeglib.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>  // which jpeglib.h needs and does not include

#include "drawing/image/internal/grey.hpp"
#include "drawing/image/internal/size_check.hpp"
#include "drawing/units.hpp"

namespace kerf::drawing {
namespace {

/// Pixels times scans: some 20 s of work.
constexpr double kMostWork = 2e9;
constexpr long kMostMemory = 512L << 20U;

/// Errors are jumps back to where setjmp stands; warnings tell of damage that libjpeg paints over,
/// and count as errors here: nobody wants grey bars burnt.
struct JpegErrors {
  jpeg_error_mgr manager;  // first: libjpeg knows this alone
  std::jmp_buf back;
  char said[JMSG_LENGTH_MAX];
};

[[noreturn]] void leave(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<JpegErrors*>(jpeg->err);
  jpeg->err->format_message(jpeg, errors->said);
  std::longjmp(errors->back, 1);
}

void leave_on_damage(j_common_ptr jpeg, int level) {
  if (level < 0) leave(jpeg);
}

void say_nothing(j_common_ptr) {}

/// A small file may ask for any number of scans of a large picture.
void leave_when_endless(j_common_ptr jpeg) {
  auto* decoder = reinterpret_cast<j_decompress_ptr>(jpeg);
  const double pixels = 1.0 * decoder->image_width * decoder->image_height;
  if (decoder->input_scan_number * pixels <= kMostWork) return;
  auto* errors = reinterpret_cast<JpegErrors*>(jpeg->err);
  constexpr char kWords[] = "it has more scans than any picture needs";
  std::copy(std::begin(kWords), std::end(kWords), errors->said);
  std::longjmp(errors->back, 1);
}

class JpegReader {
 public:
  explicit JpegReader(std::string_view bytes) : bytes_(bytes) {
    jpeg_.err = jpeg_std_error(&errors_.manager);
    errors_.manager.error_exit = leave;
    errors_.manager.emit_message = leave_on_damage;
    errors_.manager.output_message = say_nothing;
    errors_.said[0] = 0;
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  [[nodiscard]] bool open() {
    if (setjmp(errors_.back) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    jpeg_.mem->max_memory_to_use = kMostMemory;
    progress_.progress_monitor = leave_when_endless;
    jpeg_.progress = &progress_;
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
    return jpeg_read_header(&jpeg_, TRUE) == JPEG_HEADER_OK;
  }
  [[nodiscard]] bool start() {
    if (setjmp(errors_.back) != 0) return false;
    jpeg_.out_color_space = space();
    jpeg_.dct_method = JDCT_ISLOW;
    return jpeg_start_decompress(&jpeg_) != FALSE;
  }
  [[nodiscard]] bool read_row(std::uint8_t* into) {
    if (setjmp(errors_.back) != 0) return false;
    JSAMPROW row = into;
    return jpeg_read_scanlines(&jpeg_, &row, 1) == 1;
  }
  [[nodiscard]] bool finish() {
    if (setjmp(errors_.back) != 0) return false;
    return jpeg_finish_decompress(&jpeg_) != FALSE;
  }

  [[nodiscard]] PictureFacts facts() const {
    PictureFacts facts;
    facts.kind = PictureKind::jpeg;
    facts.width = jpeg_.image_width;
    facts.height = jpeg_.image_height;
    const double unit_mm = jpeg_.density_unit == 1 ? kMmAnInch : 10;
    const bool says = jpeg_.saw_JFIF_marker != 0 && jpeg_.density_unit != 0;
    if (says && jpeg_.density_unit <= 2 && jpeg_.X_density > 0 && jpeg_.Y_density > 0)
      facts.density = {jpeg_.X_density / unit_mm, jpeg_.Y_density / unit_mm};
    return facts;
  }
  [[nodiscard]] unsigned channels() const { return static_cast<unsigned>(jpeg_.output_components); }
  /// Adobe writes how much paper is left, not how much ink there is.
  [[nodiscard]] bool is_ink_turned() const { return jpeg_.saw_Adobe_marker != 0; }

  [[nodiscard]] tl::unexpected<base::Failure> refusal() const {
    return bad_picture(fmt::format("the JPEG is damaged: {}",
                                   errors_.said[0] != 0 ? errors_.said : "it has no picture"));
  }

 private:
  [[nodiscard]] J_COLOR_SPACE space() const {
    if (jpeg_.num_components == 1) return JCS_GRAYSCALE;
    return jpeg_.num_components == 4 ? JCS_CMYK : JCS_RGB;
  }

  std::string_view bytes_;
  JpegErrors errors_{};
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct jpeg_{};
};

/// Ink takes from the light of a colour its share, and black from what is left.
Sample sample_of_ink(const std::uint8_t* at, bool is_turned) {
  std::uint32_t left[4];
  for (std::size_t i = 0; i < 4; ++i) left[i] = is_turned ? at[i] : 255U - at[i];
  const auto of = [&](std::size_t i) { return (2 * left[i] * left[3] + 255) / 510; };
  return {of(0), of(1), of(2), 255};
}

void put_row(const JpegReader& reader, const std::uint8_t* row, std::uint32_t width,
             std::uint8_t* into) {
  const unsigned channels = reader.channels();
  const bool is_turned = reader.is_ink_turned();
  for (std::uint32_t i = 0; i < width; ++i) {
    const std::uint8_t* at = row + std::size_t{i} * channels;
    if (channels == 1)
      into[i] = at[0];
    else if (channels == 3)
      into[i] = grey_of({at[0], at[1], at[2], 255}, 255);
    else
      into[i] = grey_of(sample_of_ink(at, is_turned), 255);
  }
}

}  // namespace

base::Outcome<PictureFacts> jpeg_facts(std::string_view bytes) {
  JpegReader reader(bytes);
  if (!reader.open()) return reader.refusal();
  return of_sound_size(reader.facts());
}

base::Outcome<GreyPicture> read_jpeg(std::string_view bytes) {
  JpegReader reader(bytes);
  if (!reader.open()) return reader.refusal();
  GreyPicture picture{reader.facts(), {}};
  const std::uint32_t width = picture.facts.width;
  const std::uint32_t height = picture.facts.height;
  if (const auto wrong = objection_to_size(width, height)) return bad_picture(*wrong);
  if (!reader.start()) return reader.refusal();
  picture.pixels.resize(std::size_t{width} * height);
  std::vector<std::uint8_t> row(std::size_t{width} * reader.channels());
  for (std::uint32_t y = 0; y < height; ++y) {
    if (!reader.read_row(row.data())) return reader.refusal();
    put_row(reader, row.data(), width, &picture.pixels[std::size_t{y} * width]);
  }
  if (!reader.finish()) return reader.refusal();
  return picture;
}

}  // namespace kerf::drawing
