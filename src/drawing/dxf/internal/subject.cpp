#include "drawing/dxf/internal/subject.hpp"

#include <fmt/format.h>

#include <cmath>

namespace kerf::drawing::dxf {
namespace {

constexpr int kHandle = 5;
constexpr int kLayer = 8;

}  // namespace

std::string described(const Record& record, Sheet& sheet) {
  std::string text(sheet.words(record.kind()));
  const std::string_view handle = record.text(kHandle);
  if (!handle.empty()) text += fmt::format(" {}", sheet.words(handle));
  if (record.has(kLayer)) text += fmt::format(" on layer {}", sheet.words(record.text(kLayer)));
  return text;
}

void tell(const Record& record, Sheet& sheet, base::Severity severity, base::Code code,
          std::string_view why, std::uint32_t line) {
  const Name layer = sheet.canvas.name(sheet.words(record.text(kLayer)));
  const Name kind = sheet.canvas.name(sheet.words(record.kind()));
  sheet.canvas.find(severity, code, {base::kNoFile, line > 0 ? line : record.line(), 1},
                    fmt::format("{} {}", described(record, sheet), why), layer, kind);
}

Facing facing_of(const Record& record) {
  constexpr double kUpright = 1e-6;
  if (!record.has(210)) return Facing::up;
  const double z = record.number(230, 1);
  const double aside = std::max(std::abs(record.number(210)), std::abs(record.number(220)));
  if (!(aside <= kUpright * std::abs(z)) || z == 0) return Facing::aside;
  return z > 0 ? Facing::up : Facing::down;
}

EntityId Subject::entity() {
  if (!entity_) {
    Entity entity;
    entity.line = record_.line();
    entity.layer = layer_.name;
    entity.kind = canvas().name(record_.kind());
    entity.handle = canvas().name(words(record_.text(kHandle)));
    entity.colour = colour_;
    entity_ = canvas().add(entity);
  }
  return *entity_;
}

void Subject::tell_heights() {
  canvas().ignore("Z", record_.line(), "points at different heights are drawn as seen from above");
}

}  // namespace kerf::drawing::dxf
