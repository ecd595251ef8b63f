#include "drawing/dxf/internal/layer_table.hpp"

#include <cstdlib>

#include "drawing/colour_index.hpp"
#include "drawing/small_letters.hpp"

namespace kerf::drawing::dxf {

std::string key_of(std::string_view name) { return in_small_letters(name); }

std::optional<Colour> own_colour(const Record& record) {
  constexpr std::uint32_t kRgb = 0xFFFFFF;
  if (record.has(420)) return Colour{static_cast<std::uint32_t>(record.integer(420)) & kRgb};
  const int index = std::abs(record.integer(62, kByLayer));
  if (index == kByLayer || index == kByBlock) return std::nullopt;
  return colour_of_index(index);
}

Layer& LayerTable::entry(std::string_view raw) {
  const std::string name(words_(raw));
  const auto [entry, is_new] = layers_.try_emplace(key_of(name));
  Layer& layer = entry->second;
  if (is_new) {
    layer.name = canvas_.name(name);
    layer.colour = colour_of_index(kForeground);
    layer.is_wanted = canvas_.wants(name);
    layer.is_named = canvas_.names(name);
  }
  return layer;
}

void LayerTable::define(const Record& record) {
  constexpr int kFrozen = 1;
  Layer& layer = entry(record.text(2));
  layer.colour = own_colour(record).value_or(colour_of_index(kForeground));
  layer.is_off = record.integer(62) < 0;
  layer.is_frozen = record.flag(70, kFrozen);
}

const Layer& LayerTable::find(std::string_view raw) {
  if (last_found_ != nullptr && last_ == raw) return *last_found_;
  last_found_ = &entry(raw);
  last_ = raw;
  return *last_found_;
}

}  // namespace kerf::drawing::dxf
