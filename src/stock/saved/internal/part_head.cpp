#include "stock/saved/internal/part_head.hpp"

#include <cmath>

#include "stock/saved/internal/part_format.hpp"
#include "stock/saved/internal/unpacking.hpp"

namespace kerf::stock::saved {
namespace {

using nlohmann::json;

constexpr double kMostVolume_mm3 = 1e18;
constexpr std::size_t kMostThreads = 1000;

WrongPart wrong_value(const char* key) {
  return damaged("its head has no " + std::string(key) + " that can be");
}

double number_of(const json& value, double low, double high, const char* key) {
  if (!value.is_number()) throw wrong_value(key);
  const double number = value.get<double>();
  if (!(number >= low && number <= high)) throw wrong_value(key);
  return number;
}

turned::TurnedThread thread_of(const json& value) {
  const auto number = [&](const char* key) {
    const auto found = value.find(key);
    if (found == value.end()) throw wrong_value("threads");
    return number_of(*found, -kFarthest_mm, kMostVolume_mm3, "threads");
  };
  turned::TurnedThread thread;
  const json axis = value.value("axis", json("Z"));
  if (axis != "X" && axis != "Z") throw wrong_value("threads");
  thread.axis = axis == "X" ? 'X' : 'Z';
  thread.from = number("from");
  thread.to = number("to");
  thread.major = number("major");
  thread.minor = number("minor");
  thread.pitch = number("pitch");
  thread.starts = static_cast<int>(std::min(100.0, std::max(1.0, number("starts"))));
  const json inside = value.value("inside", json(false));
  if (!inside.is_boolean()) throw wrong_value("threads");
  thread.is_inside = inside.get<bool>();
  thread.volume_mm3 = number("volume_mm3");
  return thread;
}

}  // namespace

PartHead::PartHead(const std::string& text) : json_(json::parse(text, nullptr, false)) {
  if (!json_.is_object()) throw damaged("its head is no JSON");
}

const json& PartHead::at(const char* key) const {
  const auto found = json_.find(key);
  if (found == json_.end()) throw wrong_value(key);
  return *found;
}

const json& PartHead::list(const char* key, std::size_t size) const {
  const json& value = at(key);
  if (!value.is_array() || value.size() != size) throw wrong_value(key);
  return value;
}

std::string PartHead::text(const char* key) const {
  const json& value = at(key);
  if (!value.is_string()) throw wrong_value(key);
  return value.get<std::string>();
}

bool PartHead::flag(const char* key) const {
  const json& value = at(key);
  if (!value.is_boolean()) throw wrong_value(key);
  return value.get<bool>();
}

double PartHead::number(const char* key, double low, double high) const {
  return number_of(at(key), low, high, key);
}

int PartHead::count(const char* key, double most) const {
  return static_cast<int>(std::floor(number(key, 0, most)));
}

std::vector<int> PartHead::cells(std::size_t size) const {
  std::vector<int> counts;
  for (const json& value : list("cells", size))
    counts.push_back(static_cast<int>(number_of(value, 1, kMostCellsAlong, "cells")));
  return counts;
}

std::vector<double> PartHead::box(std::size_t axes) const {
  std::vector<double> values;
  for (const json& value : list("box", 2 * axes))
    values.push_back(number_of(value, -kFarthest_mm, kFarthest_mm, "box"));
  for (std::size_t i = 0; i < axes; ++i) {
    if (!(values[i] < values[axes + i])) throw wrong_value("box");
  }
  return values;
}

PartLabel PartHead::label() const {
  PartLabel label{.zero = text("zero"), .volume_mm3 = number("volume_mm3", 0, kMostVolume_mm3)};
  const json& programs = at("made_by");
  if (!programs.is_array() || programs.size() > kMostPrograms) throw wrong_value("made_by");
  for (const json& name : programs) {
    if (!name.is_string()) throw wrong_value("made_by");
    label.made_by.push_back(name.get<std::string>());
  }
  const auto threads = json_.find("threads");
  if (threads == json_.end()) return label;
  if (!threads->is_array() || threads->size() > kMostThreads) throw wrong_value("threads");
  for (const json& thread : *threads) {
    if (!thread.is_object()) throw wrong_value("threads");
    label.threads.push_back(thread_of(thread));
  }
  return label;
}

}  // namespace kerf::stock::saved
