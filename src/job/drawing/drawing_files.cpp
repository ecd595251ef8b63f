#include "job/drawing/drawing_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "drawing/contours/contours_reader.hpp"
#include "drawing/dxf/dxf_reader.hpp"
#include "drawing/image/picture.hpp"
#include "drawing/image/read_image.hpp"
#include "drawing/small_letters.hpp"
#include "drawing/svg/read_svg.hpp"
#include "drawing/trace/lens_shape.hpp"
#include "drawing/trace/trace_reader.hpp"

namespace kerf::job {
namespace {

using Read = void (*)(const base::SourceFile&, base::FileId, drawing::Canvas&);

/// A format: the endings of its files, whether a file begins like one, and its reader.
struct Format {
  std::array<std::string_view, 3> endings;
  bool (*begins_so)(std::string_view head);
  Read read;
};

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

bool begins_with_group(std::string_view text) {
  return text.starts_with("0\n") || text.starts_with("0\r") || text.starts_with("999\n") ||
         text.starts_with("999\r");
}

bool begins_as_dxf(std::string_view head) {
  if (head.starts_with("AutoCAD Binary DXF") || head.starts_with("AC10")) return true;
  return begins_with_group(without_blanks(head)) && head.find("SECTION") != std::string_view::npos;
}

bool begins_as_xml(std::string_view text) {
  return text.starts_with("<?xml") || text.starts_with("<!DOCTYPE") || text.starts_with("<!--");
}

bool begins_as_svg(std::string_view head) {
  const std::string_view text = without_blanks(head);
  return text.starts_with("<svg") ||
         (begins_as_xml(text) && head.find("svg") != std::string_view::npos);
}

bool begins_as_trace(std::string_view head) {
  return head.find("TRCFMT=") != std::string_view::npos;
}

bool begins_as_contours(std::string_view head) {
  return without_blanks(head).starts_with('{') && head.find("\"layers\"") != std::string_view::npos;
}

/// Pictures of a drawing lie beside it.
void read_svg_in_its_folder(const base::SourceFile& file, base::FileId id,
                            drawing::Canvas& canvas) {
  const std::filesystem::path folder = std::filesystem::path(file.name()).parent_path();
  drawing::read_svg(file, id, canvas, folder.empty() ? "." : folder.string());
}

const std::array kFormats = {
    Format{{".dxf", ".dwg", ""}, begins_as_dxf, drawing::read_dxf},
    Format{{".svg", "", ""}, begins_as_svg, read_svg_in_its_folder},
    Format{{".png", ".jpg", ".jpeg"},
           [](std::string_view head) { return drawing::picture_kind(head).has_value(); },
           drawing::read_image},
    Format{{".oma", ".vca", ""}, begins_as_trace, drawing::read_trace},
    Format{{".json", "", ""}, begins_as_contours, drawing::read_contours},
};

const Format* format_of(const base::SourceFile& file) {
  constexpr std::size_t kLook = 1024;
  std::string head(kLook, '\0');
  head.resize(file.read(0, head));
  for (const Format& format : kFormats)
    if (format.begins_so(head)) return &format;
  const std::string name = drawing::in_small_letters(file.name());
  for (const Format& format : kFormats) {
    for (const std::string_view ending : format.endings)
      if (!ending.empty() && name.ends_with(ending)) return &format;
  }
  return nullptr;
}

}  // namespace

base::Outcome<void> read_drawings(const std::vector<std::string>& names, double most_seconds,
                                  base::SourceSet& sources, drawing::Canvas& canvas) {
  for (const std::string& name : names) {
    if (drawing::is_lens_shape(name)) {
      auto shape = drawing::read_lens_shape(name);
      if (!shape) return tl::unexpected(shape.error());
      draw_lens_shape(*shape, sources.add(base::SourceFile::from_text(name, "")), canvas);
      continue;
    }
    auto file = base::SourceFile::open(name, {.seconds = most_seconds});
    if (!file) return tl::unexpected(file.error());
    const base::FileId id = sources.add(std::move(*file));
    if (const Format* const format = format_of(sources[id])) {
      format->read(sources[id], id, canvas);
    } else {
      canvas.begin_file(id, "");
      canvas.find(base::Severity::error, base::Code::draw_format, {id, 1, 1}, "");
    }
  }
  return {};
}

}  // namespace kerf::job
