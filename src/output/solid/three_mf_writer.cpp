#include "output/solid/three_mf_writer.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <iterator>
#include <memory>

namespace kerf::output {
namespace {

constexpr const char* kTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr const char* kRelations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

void append_piece(const SolidPiece& piece, std::size_t id, std::string& out) {
  const auto into = std::back_inserter(out);
  fmt::format_to(into, "<object id=\"{}\" type=\"model\" pid=\"1\" pindex=\"0\"><mesh><vertices>\n",
                 id);
  // As floats: two points that other formats tell apart are two here.
  for (const mesh::Vec3& p : piece.surface.mesh.points) {
    fmt::format_to(into, "<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", static_cast<float>(p.x),
                   static_cast<float>(p.y), static_cast<float>(p.z));
  }
  out += "</vertices><triangles>\n";
  for (std::size_t i = 0; i < piece.surface.mesh.triangles.size(); ++i) {
    const mesh::Triangle& t = piece.surface.mesh.triangles[i];
    fmt::format_to(into, "<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"", t[0], t[1], t[2]);
    if (piece.materials[i] != 0) fmt::format_to(into, " pid=\"1\" p1=\"{}\"", piece.materials[i]);
    out += "/>\n";
  }
  out += "</triangles></mesh></object>\n";
}

std::string model_of(const SolidFile& file) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n";
  const auto into = std::back_inserter(out);
  fmt::format_to(into, "<metadata name=\"Title\">{}</metadata>\n", escaped(file.name));
  out += "<metadata name=\"Application\">Kerf</metadata>\n<resources>\n<basematerials id=\"1\">\n";
  for (const SolidFile::Material& material : file.materials) {
    fmt::format_to(into, "<base name=\"{}\" displaycolor=\"#{:02X}{:02X}{:02X}\"/>\n",
                   escaped(material.name), material.color[0], material.color[1], material.color[2]);
  }
  out += "</basematerials>\n";
  for (std::size_t i = 0; i < file.pieces.size(); ++i) append_piece(file.pieces[i], i + 2, out);
  out += "</resources>\n<build>\n";
  for (std::size_t i = 0; i < file.pieces.size(); ++i)
    fmt::format_to(into, "<item objectid=\"{}\"/>\n", i + 2);
  return out + "</build>\n</model>\n";
}

/// An archive in memory.
class Archive {
 public:
  Archive() : source_(zip_source_buffer_create(nullptr, 0, 0, nullptr)) {
    if (source_ == nullptr) return;
    zip_source_keep(source_);
    zip_ = zip_open_from_source(source_, ZIP_TRUNCATE, nullptr);
  }
  ~Archive() {
    if (zip_ != nullptr) zip_discard(zip_);
    if (source_ != nullptr) zip_source_free(source_);
  }
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  /// `text` outlives the archive.
  [[nodiscard]] bool add(const char* name, std::string_view text) {
    if (zip_ == nullptr) return false;
    zip_source_t* const from = zip_source_buffer(zip_, text.data(), text.size(), 0);
    const zip_int64_t at = from == nullptr ? -1 : zip_file_add(zip_, name, from, ZIP_FL_ENC_UTF_8);
    if (at < 0) return false;
    // The first of January 1980, in the archive's own numbers: no time zone changes it.
    constexpr zip_uint16_t kFirstDay = 1U << 5U | 1U;
    return zip_file_set_dostime(zip_, static_cast<zip_uint64_t>(at), 0, kFirstDay, 0) == 0;
  }

  [[nodiscard]] bool take(std::string& out) {
    if (zip_ == nullptr || zip_close(zip_) != 0) return false;
    zip_ = nullptr;
    zip_stat_t stat{};
    if (zip_source_stat(source_, &stat) != 0 || zip_source_open(source_) != 0) return false;
    out.resize(stat.size);
    const zip_int64_t read = zip_source_read(source_, out.data(), out.size());
    zip_source_close(source_);
    return read == static_cast<zip_int64_t>(out.size());
  }

 private:
  zip_source_t* source_;
  zip_t* zip_ = nullptr;
};

}  // namespace

base::Outcome<std::string> three_mf_of(const SolidFile& file) {
  const std::string model = model_of(file);
  Archive archive;
  std::string out;
  const bool made = archive.add("[Content_Types].xml", kTypes) &&
                    archive.add("_rels/.rels", kRelations) &&
                    archive.add("3D/3dmodel.model", model) && archive.take(out);
  if (!made)
    return tl::unexpected(
        base::Failure{base::Failure::Kind::output, "the 3MF archive cannot be made"});
  return out;
}

}  // namespace kerf::output
