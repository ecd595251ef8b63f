#include <gtest/gtest.h>
#include <jpeglib.h>
#include <zlib.h>

#include <array>
#include <cmath>
#include <cstdio>  // which jpeglib.h needs
#include <cstdlib>

#include "drawing/image/picture.hpp"
#include "drawing/image/read_image.hpp"

namespace kerf::drawing {
namespace {

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(value >> shift);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string both = type + data;
  const uLong sum =
      crc32(0, reinterpret_cast<const Bytef*>(both.data()), static_cast<uInt>(both.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + both +
         big_endian(static_cast<std::uint32_t>(sum));
}

struct PngHead {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  char bits = 8;
  char colour = 0;  ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
  char interlaced = 0;
};

/// Rows with a filter byte in front of each, as PNG has them.
std::string png_of(const PngHead& head, const std::string& rows, const std::string& chunks = {}) {
  std::string packed(compressBound(rows.size()), 0);
  uLongf size = packed.size();
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(rows.data()), rows.size());
  packed.resize(size);
  const std::string how{head.bits, head.colour, 0, 0, head.interlaced};
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", big_endian(head.width) + big_endian(head.height) + how) + chunks +
         chunk("IDAT", packed) + chunk("IEND", "");
}

std::vector<int> values(const base::Outcome<GreyPicture>& grey) {
  if (!grey) return {-1};
  return {grey->pixels.begin(), grey->pixels.end()};
}

std::string bytes(std::initializer_list<int> list) {
  std::string result;
  for (const int byte : list) result += static_cast<char>(byte);
  return result;
}

struct JpegWish {
  int channels = 1;
  J_COLOR_SPACE space = JCS_GRAYSCALE;
  bool is_progressive = false;
  int density_unit = 0;
  int density = 1;
};

/// A picture of one colour.
std::string jpeg_of(unsigned width, unsigned height, std::vector<unsigned char> colour,
                    const JpegWish& wish) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &buffer, &size);
  jpeg.image_width = width;
  jpeg.image_height = height;
  jpeg.input_components = wish.channels;
  jpeg.in_color_space = wish.space;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  if (wish.is_progressive) jpeg_simple_progression(&jpeg);
  jpeg.density_unit = static_cast<UINT8>(wish.density_unit);
  jpeg.X_density = jpeg.Y_density = static_cast<UINT16>(wish.density);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<unsigned char> row;
  for (unsigned i = 0; i < width; ++i) row.insert(row.end(), colour.begin(), colour.end());
  JSAMPROW rows = row.data();
  for (unsigned y = 0; y < height; ++y) jpeg_write_scanlines(&jpeg, &rows, 1);
  jpeg_finish_compress(&jpeg);
  std::string result(reinterpret_cast<char*>(buffer), size);
  jpeg_destroy_compress(&jpeg);
  std::free(buffer);
  return result;
}

// Figures of the picture test below: g = (299 R + 587 G + 114 B) / 1000, half up.

TEST(Picture, grey_of_eight_bits_is_what_is_stored) {
  const auto png = png_of({3, 2}, bytes({0, 0, 7, 255, 0, 128, 1, 2}));
  EXPECT_EQ(values(read_grey(png)), (std::vector<int>{0, 7, 255, 128, 1, 2}));
}

TEST(Picture, colours_are_weighed_and_half_is_rounded_up) {
  // 0.299*10 + 0.587*20 + 0.114*30 = 18.15; 0.299*255 = 76.245; 0.587*250 + 0.114*250 = 175.25;
  // 0.299*1 + 0.587*0 + 0.114*0 = 0.299; 0.114*250 = 28.5, half up 29
  const auto png =
      png_of({5, 1, 8, 2}, bytes({0, 10, 20, 30, 255, 0, 0, 0, 250, 250, 1, 0, 0, 0, 0, 250}));
  EXPECT_EQ(values(read_grey(png)), (std::vector<int>{18, 76, 175, 0, 29}));
}

TEST(Picture, what_is_transparent_lies_on_white) {
  // (100 * 128 + 255 * 127) / 255 = 177.196
  const auto png = png_of({3, 1, 8, 4}, bytes({0, 100, 255, 100, 0, 100, 128}));
  EXPECT_EQ(values(read_grey(png)), (std::vector<int>{100, 255, 177}));
}

TEST(Picture, one_two_and_four_bits_reach_from_black_to_white) {
  EXPECT_EQ(values(read_grey(png_of({9, 1, 1}, bytes({0, 0xA5, 0x80})))),
            (std::vector<int>{255, 0, 255, 0, 0, 255, 0, 255, 255}));
  EXPECT_EQ(values(read_grey(png_of({4, 1, 2}, bytes({0, 0x1B})))),
            (std::vector<int>{0, 85, 170, 255}));
  EXPECT_EQ(values(read_grey(png_of({3, 1, 4}, bytes({0, 0x0F, 0x70})))),
            (std::vector<int>{0, 255, 119}));
}

TEST(Picture, sixteen_bits_are_rounded_once) {
  // 0x8000 / 257 = 127.502, half up 128; 0x7F80 * 255 / 65535 = 127.0039...
  const auto png = png_of({3, 1, 16}, bytes({0, 0x80, 0x00, 0x7F, 0x80, 0xFF, 0xFF}));
  EXPECT_EQ(values(read_grey(png)), (std::vector<int>{128, 127, 255}));
}

TEST(Picture, a_palette_has_colours_and_transparency) {
  const std::string chunks =
      chunk("PLTE", bytes({0, 0, 0, 255, 255, 255, 0, 200, 0})) + chunk("tRNS", bytes({0, 255}));
  const auto png = png_of({4, 1, 2, 3}, bytes({0, 0x1A}), chunks);
  EXPECT_EQ(values(read_grey(png)), (std::vector<int>{255, 255, 117, 117}));
}

TEST(Picture, an_interlaced_one_is_the_same) {
  // 5 x 5, value 10 y + x; Adam7: pass 1 (0,0); 2 (4,0); 3 (0,4) (4,4); 4 (2,0) (2,4);
  // 5 row 2: 0 2 4; 6 rows 0, 2, 4: 1 3; 7 rows 1, 3: all
  std::string rows = bytes({0, 0, 0, 4, 0, 40, 44, 0, 2, 0, 42, 0, 20, 22, 24});
  for (const int y : {0, 2, 4}) rows += bytes({0, 10 * y + 1, 10 * y + 3});
  for (const int y : {1, 3})
    rows += bytes({0, 10 * y, 10 * y + 1, 10 * y + 2, 10 * y + 3, 10 * y + 4});
  const auto grey = values(read_grey(png_of({5, 5, 8, 0, 1}, rows)));
  ASSERT_EQ(grey.size(), 25U);
  for (std::size_t i = 0; i < 25; ++i) EXPECT_EQ(grey[i], static_cast<int>(10 * (i / 5) + i % 5));
}

TEST(Picture, density_is_in_pixels_a_millimetre) {
  const auto metre = chunk("pHYs", big_endian(3937) + big_endian(2000) + bytes({1}));
  const auto facts = picture_facts(png_of({1, 1}, bytes({0, 0}), metre));
  ASSERT_TRUE(facts && facts->density);
  EXPECT_DOUBLE_EQ(facts->density->across, 3.937);
  EXPECT_DOUBLE_EQ(facts->density->down, 2);
  const auto aspect = chunk("pHYs", big_endian(3937) + big_endian(2000) + bytes({0}));
  EXPECT_FALSE(picture_facts(png_of({1, 1}, bytes({0, 0}), aspect))->density);
  const auto jpeg = picture_facts(jpeg_of(3, 2, {9}, {1, JCS_GRAYSCALE, false, 1, 254}));
  ASSERT_TRUE(jpeg && jpeg->density);
  EXPECT_DOUBLE_EQ(jpeg->density->across, 10);
  EXPECT_DOUBLE_EQ(
      picture_facts(jpeg_of(3, 2, {9}, {1, JCS_GRAYSCALE, false, 2, 40}))->density->down, 4);
  EXPECT_FALSE(picture_facts(jpeg_of(3, 2, {9}, {}))->density);
}

TEST(Picture, a_jpeg_of_grey_colour_and_ink) {
  EXPECT_EQ(values(read_grey(jpeg_of(2, 2, {100}, {}))), (std::vector<int>{100, 100, 100, 100}));
  // 0.299*200 + 0.587*100 + 0.114*50 = 124.2
  for (const bool is_progressive : {false, true}) {
    const auto grey = read_grey(jpeg_of(9, 3, {200, 100, 50}, {3, JCS_RGB, is_progressive}));
    ASSERT_TRUE(grey);
    ASSERT_EQ(grey->pixels.size(), 27U);
    for (const int value : grey->pixels) EXPECT_NEAR(value, 124, 1);
  }
  // libjpeg writes Adobe's mark, so samples say what is left: 255, 127, 0 of 204/255: 0.8 (76.2 +
  // 74.5) = 120.6
  const auto ink = read_grey(jpeg_of(8, 8, {255, 127, 0, 204}, {4, JCS_CMYK}));
  ASSERT_TRUE(ink);
  EXPECT_NEAR(ink->pixels[0], 121, 1);
}

TEST(Picture, damage_is_a_sentence) {
  const std::string png = png_of({3, 2}, bytes({0, 0, 7, 255, 0, 128, 1, 2}));
  for (std::size_t size = 0; size < png.size(); ++size)
    EXPECT_FALSE(read_grey(png.substr(0, size))) << size;
  for (std::size_t i = 8; i < png.size(); ++i) {
    std::string other = png;
    other[i] = static_cast<char>(other[i] ^ 0x10);
    const auto grey = read_grey(other);
    EXPECT_TRUE(grey || !grey.error().message.empty());
  }
  const std::string jpeg = jpeg_of(40, 40, {200, 100, 50}, {3, JCS_RGB});
  for (std::size_t size = 0; size + 2 < jpeg.size(); size += 5)
    EXPECT_FALSE(read_grey(jpeg.substr(0, size))) << size;
  EXPECT_NE(read_grey("GIF89a").error().message.find("neither"), std::string::npos);
}

TEST(Picture, a_wrong_sum_is_damage) {
  std::string png = png_of({3, 2}, bytes({0, 0, 7, 255, 0, 128, 1, 2}));
  png[png.size() - 14] = static_cast<char>(png[png.size() - 14] ^ 1);  // the sum of IDAT
  const auto grey = read_grey(png);
  ASSERT_FALSE(grey);
  EXPECT_NE(grey.error().message.find("damaged"), std::string::npos);
}

TEST(Picture, more_than_100_megapixels_are_refused_before_their_memory) {
  const auto large = picture_facts(png_of({10001, 10000}, ""));
  ASSERT_FALSE(large);
  EXPECT_NE(large.error().message.find("10001 x 10000"), std::string::npos);
  EXPECT_TRUE(picture_facts(png_of({10000, 10000}, "")));
  EXPECT_FALSE(picture_facts(png_of({0, 10}, "")));
  EXPECT_FALSE(picture_facts(png_of({0x7fffffff, 0x7fffffff}, "")));
  EXPECT_FALSE(read_grey(png_of({10000, 10000}, "")));  // no rows
}

struct FileOf {
  Reading reading;
  Drawing drawing;

  explicit FileOf(const std::string& text, const Reading& how = {}) : reading(how) {
    Canvas canvas(reading, drawing);
    const auto file = base::SourceFile::from_text("some/portrait.png", text);
    read_image(*file, base::FileId{}, canvas);
  }
};

TEST(ReadImage, a_picture_lies_on_zero_and_is_as_large_as_its_density_says) {
  const auto density = chunk("pHYs", big_endian(10000) + big_endian(5000) + bytes({1}));
  const FileOf file(png_of({3, 2}, bytes({0, 0, 7, 255, 0, 128, 1, 2}), density));
  ASSERT_EQ(file.drawing.images.size(), 1U);
  const Image& image = file.drawing.images[0];
  EXPECT_NEAR(image.to_mm({1, 1}).u, 0.3, 1e-12);
  EXPECT_NEAR(image.to_mm({1, 1}).v, 0.4, 1e-12);
  EXPECT_TRUE(image.size_is_known);
  EXPECT_EQ(file.drawing.names[file.drawing.entities[0].layer], "portrait.png");
  EXPECT_EQ(file.drawing.files[0].unit_from, "pHYs");
  EXPECT_TRUE(file.drawing.findings.empty());
}

TEST(ReadImage, a_size_that_nobody_says_is_told) {
  const std::string png = png_of({3, 2}, bytes({0, 0, 7, 255, 0, 128, 1, 2}));
  const FileOf file(png);
  ASSERT_EQ(file.drawing.findings.size(), 1U);
  EXPECT_EQ(file.drawing.findings[0].diagnostic.number, "DRAW_UNIT");
  EXPECT_FALSE(file.drawing.images[0].size_is_known);
  EXPECT_NEAR(file.drawing.images[0].to_mm.x.u, 3 * 25.4 / 96, 1e-12);
  Reading dpi;
  dpi.dpi = 254;
  const FileOf said(png, dpi);
  EXPECT_TRUE(said.drawing.findings.empty());
  EXPECT_NEAR(said.drawing.images[0].to_mm.x.u, 0.3, 1e-12);
}

TEST(ReadImage, a_damaged_one_is_told) {
  const FileOf file("\x89PNG\r\n\x1a\n");
  ASSERT_EQ(file.drawing.findings.size(), 1U);
  EXPECT_EQ(file.drawing.findings[0].diagnostic.number, "IMAGE_BAD");
  EXPECT_TRUE(file.drawing.images.empty());
}

}  // namespace
}  // namespace kerf::drawing
