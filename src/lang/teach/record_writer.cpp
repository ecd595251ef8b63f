#include "lang/teach/record_writer.hpp"

#include <cmath>

#include "base/decimal.hpp"

namespace kerf::teach {
namespace {

// Only of 0 the sign is lost in other files.
void number(std::string& out, double value) {
  out += ' ';
  if (value == 0 && std::signbit(value)) out += '-';
  base::append_number(out, value);
}

void pose(std::string& out, const Pose& pose) {
  for (const double value : {pose.x, pose.y, pose.z, pose.a_deg, pose.c_deg}) number(out, value);
}

void append(std::string& out, const Version& /*version*/) { out += "TEACH 1"; }
void append(std::string& out, const Units& /*units*/) { out += "UNITS MM DEG"; }
void append(std::string& out, const End& /*end*/) { out += "END"; }

void append(std::string& out, const Period& period) {
  out += "PERIOD";
  number(out, period.milliseconds);
}

void append(std::string& out, const Radii& radii) {
  out += "RADII";
  number(out, radii.r_a_mm);
  number(out, radii.r_c_mm);
}

void append(std::string& out, const Point& point) {
  out += "POINT";
  pose(out, point.to);
  if (point.name.view().empty()) return;
  out += ' ';
  out += point.name.view();
}

void append(std::string& out, const Feed& feed) {
  out += "FEED";
  number(out, feed.mm_per_min);
}

void append(std::string& out, const Laser& laser) {
  out += laser.on ? "LASER ON" : "LASER OFF";
  if (laser.percent) number(out, *laser.percent);
}

void append(std::string& out, const Line& line) {
  out += "LINE";
  pose(out, line.to);
}

void append(std::string& out, const Arc& arc) {
  out += "ARC";
  pose(out, arc.via);
  pose(out, arc.to);
}

void append(std::string& out, const Circle& circle) {
  out += "CIRCLE";
  pose(out, circle.via);
  pose(out, circle.second_via);
}

void append(std::string& out, const Dwell& dwell) {
  out += "DWELL";
  number(out, dwell.seconds);
}

}  // namespace

void append_record(std::string& out, const Record& record) {
  std::visit([&](const auto& kind) { append(out, kind); }, record);
}

void append_comment(std::string& out, std::string_view text) {
  out += ';';
  for (const char c : text) out += c == '\n' || c == '\r' ? ' ' : c;
}

void append_line(std::string& out, const Record* record, const std::string_view* comment) {
  if (record != nullptr) append_record(out, *record);
  if (record != nullptr && comment != nullptr) out += ' ';
  if (comment != nullptr) append_comment(out, *comment);
  out += '\n';
}

}  // namespace kerf::teach
