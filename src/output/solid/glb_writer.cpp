#include "output/solid/glb_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "math/math.hpp"
#include "output/solid/bytes.hpp"

namespace kerf::output {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUint = 5125, kByte = 5121;
constexpr int kVertices = 34962, kIndices = 34963;

double linear(std::uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : math::pow((v + 0.055) / 1.055, 2.4);
}

Json rounded(double value) { return Json::parse(fmt::format("{:.6g}", value)); }

class Writer {
 public:
  explicit Writer(const SolidFile& file) : file_(file) {}

  std::string write() {
    add_frame();
    for (const SolidFile::Material& material : file_.materials) add_material(material);
    for (const SolidPiece& piece : file_.pieces) add_piece(piece);
    // An empty list is none in this format.
    for (const char* const key : {"materials", "meshes", "accessors", "bufferViews"}) {
      if (json_[key].empty()) json_.erase(key);
    }
    if (!bytes_.empty()) json_["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
    return container();
  }

 private:
  void add_frame() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "Kerf"}};
    json_["scene"] = 0;
    json_["scenes"] = Json::array({{{"nodes", {0}}}});
    // A quarter turn back about X: Z up becomes Y up.
    const Json half = Json::parse("0.7071067811865476");
    json_["nodes"] =
        Json::array({{{"name", file_.name},
                      {"rotation", {-half.get<double>(), 0.0, 0.0, half.get<double>()}},
                      {"scale", {0.001, 0.001, 0.001}},
                      {"extras", {{"unit", "mm"}}}}});
    for (const char* const key : {"materials", "meshes", "accessors", "bufferViews"})
      json_[key] = Json::array();
  }

  void add_material(const SolidFile::Material& material) {
    json_["materials"].push_back(
        {{"name", material.name},
         {"pbrMetallicRoughness",
          {{"baseColorFactor",
            {rounded(linear(material.color[0])), rounded(linear(material.color[1])),
             rounded(linear(material.color[2])), 1}},
           {"metallicFactor", 0.1},
           {"roughnessFactor", 0.55}}}});
  }

  void add_piece(const SolidPiece& piece) {
    Json attributes;
    attributes["POSITION"] = add_positions(piece.surface.mesh.points);
    attributes["_MOTION"] = add_motions(piece.surface.point_owners);
    if (piece.deviations) {
      attributes["_DEVIATION"] = add_deviations(*piece.deviations);
      attributes["COLOR_0"] = add_colors(*piece.deviations);
    }
    Json mesh{{"name", fmt::format("piece {}", json_["meshes"].size() + 1)},
              {"primitives", Json::array()}};
    for (std::size_t m = 0; m < std::max<std::size_t>(1, file_.materials.size()); ++m)
      add_primitive(piece, m, attributes, mesh);
    if (piece.deviations) {
      const double far = 2 * piece.deviations->tolerance_mm;
      mesh["extras"]["deviation_mm"] = {{"blue", -far}, {"grey", 0}, {"red", far}};
    }
    json_["nodes"][0]["children"].push_back(json_["nodes"].size());
    json_["nodes"].push_back({{"name", mesh["name"]}, {"mesh", json_["meshes"].size()}});
    json_["meshes"].push_back(std::move(mesh));
  }

  void add_primitive(const SolidPiece& piece, std::size_t material, const Json& attributes,
                     Json& mesh) {
    const std::size_t begin = bytes_.size();
    std::size_t count = 0;
    for (std::size_t i = 0; i < piece.surface.mesh.triangles.size(); ++i) {
      if (piece.materials[i] != material) continue;
      for (const std::uint32_t corner : piece.surface.mesh.triangles[i])
        append_little_endian(bytes_, corner);
      count += 3;
    }
    if (count == 0) return;
    Json primitive{{"attributes", attributes},
                   {"indices", add_accessor(begin, kIndices, kUint, "SCALAR", count)}};
    // Colours of points are multiplied by that of the material, which is white then.
    if (!piece.deviations) primitive["material"] = material;
    mesh["primitives"].push_back(std::move(primitive));
  }

  std::size_t add_positions(const std::vector<mesh::Vec3>& points) {
    const std::size_t begin = bytes_.size();
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::infinity());
    high.fill(-std::numeric_limits<float>::infinity());
    for (const mesh::Vec3& p : points) {
      const std::array<float, 3> at{static_cast<float>(p.x), static_cast<float>(p.y),
                                    static_cast<float>(p.z)};
      for (std::size_t k = 0; k < 3; ++k) {
        append_little_endian(bytes_, at[k]);
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
    const std::size_t number = add_accessor(begin, kVertices, kFloat, "VEC3", points.size());
    for (std::size_t k = 0; k < 3; ++k) {
      json_["accessors"][number]["min"].push_back(double{low[k]});
      json_["accessors"][number]["max"].push_back(double{high[k]});
    }
    return number;
  }

  std::size_t add_motions(const std::vector<std::uint32_t>& owners) {
    const std::size_t begin = bytes_.size();
    for (const std::uint32_t owner : owners)
      append_little_endian(bytes_, static_cast<float>(owner));
    return add_accessor(begin, kVertices, kFloat, "SCALAR", owners.size());
  }

  std::size_t add_deviations(const Deviations& deviations) {
    const std::size_t begin = bytes_.size();
    for (const float each : deviations.mm) append_little_endian(bytes_, each);
    return add_accessor(begin, kVertices, kFloat, "SCALAR", deviations.mm.size());
  }

  std::size_t add_colors(const Deviations& deviations) {
    const std::size_t begin = bytes_.size();
    for (const float each : deviations.mm) {
      const auto color = deviation_color(double{each} / (2 * deviations.tolerance_mm));
      // Points have light, not sRGB.
      for (const std::uint8_t part : color)
        bytes_ += static_cast<char>(static_cast<unsigned char>(255 * linear(part) + 0.5));
      bytes_ += static_cast<char>(0xff);
    }
    const std::size_t number = add_accessor(begin, kVertices, kByte, "VEC4", deviations.mm.size());
    json_["accessors"][number]["normalized"] = true;
    return number;
  }

  std::size_t add_accessor(std::size_t begin, int target, int type, const char* shape,
                           std::size_t count) {
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", begin},
                                    {"byteLength", bytes_.size() - begin},
                                    {"target", target}});
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", type},
                                  {"count", count},
                                  {"type", shape}});
    return json_["accessors"].size() - 1;
  }

  [[nodiscard]] std::string container() {
    std::string text = json_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    const std::size_t size = 12 + 8 + text.size() + (bytes_.empty() ? 0 : 8 + bytes_.size());
    std::string out = "glTF";
    append_little_endian(out, std::uint32_t{2});
    append_little_endian(out, static_cast<std::uint32_t>(size));
    append_little_endian(out, static_cast<std::uint32_t>(text.size()));
    out += "JSON" + text;
    if (bytes_.empty()) return out;
    append_little_endian(out, static_cast<std::uint32_t>(bytes_.size()));
    out.append("BIN\0", 4);
    return out + bytes_;
  }

  const SolidFile& file_;
  Json json_;
  std::string bytes_;
};

}  // namespace

std::string glb_of(const SolidFile& file) { return Writer(file).write(); }

}  // namespace kerf::output
