// What the reader of SVG makes of a file, for comparison with another renderer:
//   read_svg draw IN.svg OUT.svg fill|stroke   the contours as paths of lines and arcs, black; what
//                                              was found goes to the standard error, a line each
//                                              (OUT -: nothing is written)
//   read_svg text FONT WORDS OUT.svg           words of capitals 10 mm high; \n begins a line
//   read_svg compare A.png B.png               "iou 0.998 farthest 1.0": of the black pixels, how
//                                              much both share, and how far one is from the other's
#include "drawing/svg/read_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/decimal.hpp"
#include "drawing/font/layout.hpp"
#include "drawing/image/picture.hpp"

namespace {

using namespace kerf;
using drawing::Drawing;

std::string number(double value) { return base::rounded_text(value, 6); }

void append_edge(std::string& out, const contour::Edge& edge, double height) {
  const std::string to = number(edge.to.u) + " " + number(height - edge.to.v);
  if (edge.bulge == 0) {
    out += "L" + to;
    return;
  }
  const std::string r = number(contour::radius(edge));
  const int large = std::abs(edge.bulge) > 1 ? 1 : 0;
  out += fmt::format("A{} {} 0 {} {} {}", r, r, large, edge.bulge < 0 ? 1 : 0, to);
}

std::string data_of(const Drawing& drawing, const drawing::Path& path, double height) {
  const contour::Contour contour = contour_of(drawing, path);
  const auto start = contour.vertices.front().point;
  std::string out = "M" + number(start.u) + " " + number(height - start.v);
  for (std::size_t i = 0; i < edge_count(contour); ++i)
    append_edge(out, edge_of(contour, i), height);
  return contour.is_closed ? out + "Z" : out;
}

/// Paths of one entity are one path: its rule says what is inside.
std::string as_svg(const Drawing& drawing, bool is_filled) {
  const auto page = drawing.files.front().page_mm;
  std::string out = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{}mm' height='{}mm' viewBox='0 0 {} {}'>\n",
      number(page.u), number(page.v), number(page.u), number(page.v));
  const auto& paths = drawing.paths;
  for (std::size_t i = 0; i < paths.size();) {
    const std::uint32_t entity = drawing.vertices[paths[i].first].owner;
    std::string data;
    for (; i < paths.size() && drawing.vertices[paths[i].first].owner == entity; ++i)
      data += data_of(drawing, paths[i], page.v);
    const bool is_even_odd = drawing.entities[entity].rule == drawing::FillRule::even_odd;
    out += fmt::format("<path fill-rule='{}' {} d='{}'/>\n", is_even_odd ? "evenodd" : "nonzero",
                       is_filled ? "" : "fill='none' stroke='black' stroke-width='0.3'", data);
  }
  return out + "</svg>\n";
}

int draw(const std::string& in, const std::string& out, bool is_filled) {
  const auto file = base::SourceFile::open(in);
  if (!file) return 3;
  drawing::Reading reading;
  Drawing drawing;
  drawing::Canvas canvas(reading, drawing);
  drawing::read_svg(**file, base::FileId{}, canvas, std::filesystem::path(in).parent_path());
  for (const drawing::Finding& finding : drawing.findings)
    fmt::print(stderr, "{}:{}: {} {}\n", finding.diagnostic.place.line,
               finding.diagnostic.place.column, finding.diagnostic.number,
               finding.diagnostic.message);
  for (const drawing::Ignored& ignored : drawing.files.front().ignored)
    fmt::print(stderr, "{}: ignored {} x {}: {}\n", ignored.line, ignored.count, ignored.what,
               ignored.why);
  if (out != "-") std::ofstream(out) << as_svg(drawing, is_filled);
  return 0;
}

int write_text(const std::string& name, std::string words, const std::string& out) {
  const auto font = drawing::open_font(name);
  if (!font) return 3;
  for (std::size_t at = 0; (at = words.find("\\n", at)) != std::string::npos;)
    words.replace(at, 2, "\n");
  drawing::Reading reading;
  Drawing drawing;
  drawing::Canvas canvas(reading, drawing);
  const auto lines = 1 + std::count(words.begin(), words.end(), '\n');
  const double width = 10 * drawing::width_of(words, **font, {});
  canvas.begin_file({}, "text").page_mm = {width + 10, 17.0 * static_cast<double>(lines) + 10};
  drawing::Text text;
  text.words = words;
  text.height = 10;
  text.to_mm = drawing::Affine::moved({5, drawing.files.front().page_mm.v - 17});
  text.entity = canvas.add(drawing::Entity{});
  draw_text(text, **font, {}, canvas);
  std::ofstream(out) << as_svg(drawing, false);
  return 0;
}

drawing::GreyPicture picture(const std::string& path) {
  const auto bytes = base::read_whole(path, 1U << 26U, "a picture");
  auto grey = bytes ? drawing::read_grey(*bytes) : tl::unexpected(bytes.error());
  if (grey) return std::move(*grey);
  fmt::print(stderr, "{}: {}\n", path, grey.error().message);
  return {};
}

bool is_black(const drawing::GreyPicture& of, long x, long y) {
  const long width = of.facts.width;
  if (x < 0 || y < 0 || x >= width || y >= static_cast<long>(of.facts.height)) return false;
  return of.pixels[static_cast<std::size_t>(y * width + x)] < 128;
}

/// Of the black pixels of one the farthest from the nearest black pixel of the other; what is more
/// than 5 away counts as 99.
double farthest(const drawing::GreyPicture& a, const drawing::GreyPicture& b) {
  constexpr long kReach = 5;
  double most = 0;
  for (long y = 0; y < static_cast<long>(a.facts.height); ++y)
    for (long x = 0; x < static_cast<long>(a.facts.width); ++x) {
      if (!is_black(a, x, y)) continue;
      double least = 99;
      for (long v = -kReach; v <= kReach && least > 0; ++v)
        for (long u = -kReach; u <= kReach; ++u)
          if (is_black(b, x + u, y + v))
            least = std::min(least, std::sqrt(static_cast<double>(u * u + v * v)));
      most = std::max(most, least);
    }
  return most;
}

int compare(const std::string& first, const std::string& second) {
  const auto a = picture(first);
  const auto b = picture(second);
  if (a.pixels.empty() || a.facts.width != b.facts.width || a.facts.height != b.facts.height)
    return 1;
  std::size_t both = 0;
  std::size_t any = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    both += a.pixels[i] < 128 && b.pixels[i] < 128 ? 1U : 0U;
    any += a.pixels[i] < 128 || b.pixels[i] < 128 ? 1U : 0U;
  }
  const double iou = any == 0 ? 0 : static_cast<double>(both) / static_cast<double>(any);
  fmt::print("iou {:.4f} farthest {:.2f} black {}\n", iou, std::max(farthest(a, b), farthest(b, a)),
             any);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> all(words + 1, words + count);
  if (all.size() == 4 && all[0] == "draw") return draw(all[1], all[2], all[3] == "fill");
  if (all.size() == 4 && all[0] == "text") return write_text(all[1], all[2], all[3]);
  if (all.size() == 3 && all[0] == "compare") return compare(all[1], all[2]);
  return 2;
}
