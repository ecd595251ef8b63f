#pragma once

#include <gtest/gtest.h>

#include <string>

#include "process/recipe_file.hpp"

namespace kerf::process {

inline constexpr base::FileId kFile{3};

inline Recipe recipe_of(const std::string& text) {
  auto read = read_recipe(text, "a.toml", kFile);
  if (!read) {
    for (const base::Diagnostic& each : read.error())
      ADD_FAILURE() << each.place.line << ":" << each.place.column << ": " << each.message;
    return {};
  }
  return *read;
}

/// "1:8 JOB_KEY: [job] has no key fed (feed is the nearest name)"
inline std::string told(const Diagnostics& list) {
  std::string all;
  for (const base::Diagnostic& each : list) {
    EXPECT_TRUE(each.place.line == 0 || each.place.file == kFile);
    all += std::to_string(each.place.line) + ":" + std::to_string(each.place.column) + " " +
           each.number + ": " + each.message.substr(each.message.find(": ") + 2);
    if (!each.hint.empty()) all += " (" + each.hint + ")";
    all += "\n";
  }
  return all;
}

inline std::string wrong_in(const std::string& text) {
  const auto read = read_recipe(text, "a.toml", kFile);
  return read ? "nothing is wrong" : told(read.error());
}

inline std::string wrong_setting(Recipe& recipe, std::string_view key, std::string_view value) {
  return told(set(recipe, key, value));
}

/// Every key, each with another value than it has by itself.
inline constexpr const char* kAllKeys = R"(
job = {machine = "laser5", material = "co2-paper", tolerance = 0.02, join = 0.3, same = 0.004, order = "file", end = [3, 4]}
place = {fit = [100, 50], mirror = "y", rotate = 30, anchor = "upper-center", at = [1, 2]}
array = {columns = 3, rows = 2, dx = 45, dy = -30, order = "travel"}
lens = {side = "L"}
[image]
width = 30
height = 40
[text]
font = "a.ttf"
height = 7
spacing = 1.5
align = "center"
serial = {start = 12, step = 2, width = 3, keep = "serial.txt"}
[[text.line]]
text = "No. {serial}"
at = [5, 6]
rotate = 90
layer = "marks"
height = 3
[wrap]
shape = "cone"
axis = "Z"
radius = 20
center = [1, 2, 3]
half_angle = 15
at = 40
clearance = 8
normal_deg = 0.25
[[operation]]
name = "outline"
layers = ["CUT", "#ff0000"]
process = "cut"
power = 80
frequency_hz = 1000
feed = 900
beam = "follow"
passes = 2
z_step = -0.5
z = 1.5
pass_order = "operation"
air = "flood"
gas = "N2"
start = "corner"
dashes = true
overlaps = "once"
min_power = 5
depth = 3
step_down = 1
safe_z = 10
plunge = 100
tool = 4
spindle = 12000
overcut = 0.3
kerf = 0.15
side = "inside"
corner = "sharp"
lead_in = {kind = "line", length = 2, angle = 45}
lead_out = {kind = "arc", radius = 1.5}
lead_open = true
pierce_s = 0.4
pierce_power = 90
tabs = {count = 4, width = 0.5, power = 10}
[[operation]]
name = "area"
layers = "FILL"
process = "fill"
enabled = false
ton_ms = 0.4
toff_ms = 0.1
ms_per_mm = 5
spacing = 0.2
angle = 45
cross = true
kind = "offset"
inset = 0.1
bidirectional = false
overscan = 3
outline = true
[[operation]]
name = "portrait"
process = "raster"
interval = 0.05
pixel = 0.04
mode = "stucki"
level = 100
scan_offset = [[1000, 0.05], [6000, 0.2]]
curve = [[0, 0.1], [0.5, 0.4], [1, 1]]
invert = true
gamma = 1.8
brightness = -10
contrast = 20
mirror = true
overscan = "auto"
[[operation]]
name = "seam"
process = "weld"
ramp_in = 3
ramp_out = 4
close = 1
weave = {shape = "circle", width = 1, pitch = 2}
[[operation]]
name = "track"
process = "heat"
track_width = 5
overlap = 0.3
[[operation]]
name = "holes"
process = "drill"
max_diameter = 3
pulses = 500
ton_ms = 0.2
toff_ms = 0.3
trepan = true
)";

}  // namespace kerf::process
