#include <cairo.h>
#include <gtest/gtest.h>

#include <cstring>

#include "output/picture/drawing/label_placer.hpp"
#include "output/picture/drawing/png_writer.hpp"
#include "output/picture/drawing/svg_writer.hpp"

// What fontconfig keeps for the whole process is no leak of ours. Only LeakSanitizer calls this.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }

namespace kerf::output::plot {
namespace {

constexpr Color kRed{255, 0, 0};

DisplayList sheet() {
  DisplayList list;
  list.width = 200;
  list.height = 100;
  return list;
}

DisplayList with(Outline outline, const Ink& ink) {
  DisplayList list = sheet();
  list.add(std::move(outline), ink);
  return list;
}

std::string path_data(const DisplayList& list) {
  const std::string svg = write_svg(list);
  const std::size_t begin = svg.find(" d=\"") + 4;
  return svg.substr(begin, svg.find('"', begin) - begin);
}

TEST(SvgWriter, WritesRelativeCoordinatesInFewCharacters) {
  Outline outline;
  outline.move_to({10, 20.5});
  outline.line_to({10.25, 20});
  outline.line_to({20, 20});
  outline.close();
  EXPECT_EQ(path_data(with(outline, {kRed, 1, false, {}})), "m10 20.5l.25-.5 9.75 0z");
}

TEST(SvgWriter, WritesCurvesFromTheirStart) {
  Outline outline;
  outline.move_to({10, 10});
  outline.curve_to({11, 10}, {12, 11}, {12, 12});
  outline.curve_to({12, 13}, {11, 14}, {10, 14});
  outline.move_to({50, 50});
  outline.line_to({51, 50});
  EXPECT_EQ(path_data(with(outline, {kRed, 1, false, {}})),
            "m10 10c1 0 2 1 2 2 0 1-1 2-2 2m40 36l1 0");
}

TEST(SvgWriter, GoesOnFromTheStartOfAClosedOutline) {
  Outline outline;
  outline.rectangle({10, 10, 30, 20});
  outline.segment({11, 10}, {12, 10});
  EXPECT_EQ(path_data(with(outline, {kRed, 1, false, {}})), "m10 10l30 0 0 20-30 0zm1 0l1 0");
}

TEST(SvgWriter, RoundingDoesNotAddUp) {
  Outline outline;
  outline.move_to({0, 0});
  for (int i = 1; i <= 1000; ++i) outline.line_to({i * 0.033333, 0});
  double x = 0;
  const std::string data = path_data(with(outline, {kRed, 1, false, {}}));
  for (const char* at = data.c_str() + data.find('l') + 1; *at != '\0';) {
    char* end = nullptr;
    x += std::strtod(at, &end);
    (void)std::strtod(end, &end);
    at = end;
  }
  EXPECT_NEAR(x, 33.33, 0.005);
}

TEST(SvgWriter, LeavesEmptyOutlinesOut) {
  EXPECT_EQ(write_svg(with(Outline{}, {kRed, 1, false, {}})), write_svg(sheet()));
}

TEST(SvgWriter, EscapesText) {
  DisplayList list = sheet();
  list.title = "<title>";
  list.add(Text{{1, 2}, "a < b & c"});
  const std::string svg = write_svg(list);
  EXPECT_NE(svg.find("<title>&lt;title&gt;</title>"), std::string::npos);
  EXPECT_NE(svg.find(">a &lt; b &amp; c</text>"), std::string::npos);
}

// A PNG file read back.
class Image {
 public:
  explicit Image(const std::string& file) : rest_(file) {
    surface_ = cairo_image_surface_create_from_png_stream(read, this);
  }
  ~Image() { cairo_surface_destroy(surface_); }
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
  [[nodiscard]] int width() const { return cairo_image_surface_get_width(surface_); }
  [[nodiscard]] int height() const { return cairo_image_surface_get_height(surface_); }
  [[nodiscard]] std::uint32_t pixel(int x, int y) const {
    std::uint32_t value = 0;
    const int offset = y * cairo_image_surface_get_stride(surface_) + 4 * x;
    std::memcpy(&value, cairo_image_surface_get_data(surface_) + offset, sizeof value);
    return value & 0xffffffU;
  }

 private:
  static cairo_status_t read(void* self, unsigned char* into, unsigned int size) {
    std::string_view& rest = static_cast<Image*>(self)->rest_;
    if (rest.size() < size) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(into, rest.data(), size);
    rest.remove_prefix(size);
    return CAIRO_STATUS_SUCCESS;
  }
  std::string_view rest_;
  cairo_surface_t* surface_;
};

TEST(PngWriter, DrawsOnWhiteAtTheScaleAskedFor) {
  Outline outline;
  outline.segment({20, 50}, {180, 50});
  const std::string file = write_png(with(outline, {kRed, 4, false, {}}), 2);
  const Image image(file);
  EXPECT_EQ(image.width(), 400);
  EXPECT_EQ(image.height(), 200);
  EXPECT_EQ(image.pixel(0, 0), 0xffffffU);
  EXPECT_EQ(image.pixel(200, 100), 0xff0000U);
  EXPECT_EQ(image.pixel(200, 110), 0xffffffU);
}

TEST(PngWriter, FillsAndLeavesNoGapsInLongOutlines) {
  DisplayList list = sheet();
  Outline square;
  square.rectangle({10, 10, 30, 30});
  list.add(std::move(square), {{}, 1, false, kRed});
  Outline comb;
  comb.move_to({50, 50});
  for (int i = 1; i <= 1400; ++i) comb.line_to({50 + i * 0.1, 50});
  list.add(std::move(comb), {kRed, 2, false, {}});
  const std::string file = write_png(list, 1);
  const Image image(file);
  EXPECT_EQ(image.pixel(25, 25), 0xff0000U);
  EXPECT_EQ(image.pixel(45, 25), 0xffffffU);
  for (int x = 51; x < 189; ++x) EXPECT_EQ(image.pixel(x, 49), 0xff0000U) << x;
}

TEST(LabelPlacer, PutsNoLabelOnAnother) {
  LabelPlacer placer({0, 0, 400, 300});
  std::vector<Rect> placed;
  for (int i = 0; i < 12; ++i) {
    const auto rect = placer.place({200, 150}, 30, 15, 8);
    if (!rect) continue;
    for (const Rect& other : placed) {
      EXPECT_TRUE(rect->right() <= other.left || other.right() <= rect->left ||
                  rect->bottom() <= other.top || other.bottom() <= rect->top);
    }
    placed.push_back(*rect);
  }
  EXPECT_GE(placed.size(), 8U);
}

TEST(LabelPlacer, StaysInsideOfTheArea) {
  LabelPlacer placer({0, 0, 400, 300});
  const auto rect = placer.place({399, 1}, 30, 15, 8);
  ASSERT_TRUE(rect);
  EXPECT_LE(rect->right(), 400);
  EXPECT_GE(rect->top, 0);
  EXPECT_FALSE(placer.place({1000, 1000}, 30, 15, 8));
}

}  // namespace
}  // namespace kerf::output::plot
