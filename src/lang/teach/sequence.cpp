#include "lang/teach/sequence.hpp"

#include "base/decimal.hpp"
#include "geometry/space_arc.hpp"
#include "geometry/tolerance.hpp"

namespace kerf::teach {
namespace {

using base::Code;
using geometry::NoArc;
using geometry::SpaceArc;

bool is_cut(const Record& record) {
  return std::holds_alternative<Line>(record) || std::holds_alternative<Arc>(record) ||
         std::holds_alternative<Circle>(record);
}

const char* name_of_cut(const Record& record) {
  if (std::holds_alternative<Line>(record)) return "LINE";
  return std::holds_alternative<Arc>(record) ? "ARC" : "CIRCLE";
}

Mistake no_arc(NoArc why, const char* what) {
  if (why == NoArc::coincident)
    return {Code::arc_coincident,
            std::string("two of the three points of the ") + what + " are nearer than " +
                base::number_text(geometry::kSamePoint_mm) + " mm to each other",
            {}};
  return {Code::arc_collinear,
          std::string("the three points of the ") + what +
              " lie on one line, the second not between the others",
          {}};
}

}  // namespace

std::optional<Mistake> objection_to_arc(const Pose& from, const Arc& arc) {
  const auto found = SpaceArc::through(from.focus(), arc.via.focus(), arc.to.focus());
  if (found || found.error() == NoArc::straight) return std::nullopt;
  return no_arc(found.error(), "ARC");
}

std::optional<Mistake> objection_to_circle(const Pose& from, const Circle& circle) {
  const auto found = SpaceArc::circle(from.focus(), circle.via.focus(), circle.second_via.focus());
  if (found) return std::nullopt;
  Mistake mistake = no_arc(found.error(), "CIRCLE");
  if (mistake.code == Code::arc_collinear)
    mistake.detail = "the three points of the CIRCLE lie on one line";
  return mistake;
}

std::optional<Mistake> Sequence::objection_to_cut(const Record& record) const {
  const std::string name = name_of_cut(record);
  if (!pointed_) return Mistake{Code::teach_order, name + " needs a POINT before it", {}};
  if (!fed_) return Mistake{Code::teach_order, name + " needs a FEED before it", {}};
  if (!at_) return std::nullopt;
  if (const auto* const arc = std::get_if<Arc>(&record)) return objection_to_arc(*at_, *arc);
  if (const auto* const circle = std::get_if<Circle>(&record))
    return objection_to_circle(*at_, *circle);
  return std::nullopt;
}

std::optional<Mistake> Sequence::objection(const Record& record) const {
  if (ended_) return behind_end();
  const bool version = std::holds_alternative<Version>(record);
  if (!begun_ && !version)
    return Mistake{Code::teach_version, "TEACH 1 must stand before every other record", {}};
  if (begun_ && version) return Mistake{Code::teach_order, "TEACH stands once, at the head", {}};
  return is_cut(record) ? objection_to_cut(record) : std::nullopt;
}

void Sequence::follow(const Record& record) {
  begun_ = true;
  if (const auto* const point = std::get_if<Point>(&record)) at_ = point->to;
  if (const auto* const line = std::get_if<Line>(&record)) at_ = line->to;
  if (const auto* const arc = std::get_if<Arc>(&record)) at_ = arc->to;
  pointed_ = pointed_ || std::holds_alternative<Point>(record) || is_cut(record);
  fed_ = fed_ || std::holds_alternative<Feed>(record) || is_cut(record);
  ended_ = ended_ || std::holds_alternative<End>(record);
}

std::optional<Mistake> Sequence::admit(const Record& record) {
  auto mistake = objection(record);
  follow(record);
  return mistake;
}

void Sequence::pass_over() {
  begun_ = pointed_ = fed_ = true;
  at_.reset();
}

Mistake Sequence::behind_end() {
  return {Code::teach_order, "END is the last record: nothing but comments may follow it", {}};
}

std::optional<Mistake> Sequence::close() const {
  if (ended_) return std::nullopt;
  if (!begun_) return Mistake{Code::empty_program, {}, {}};
  return Mistake{Code::teach_order, "the file stops before END: a part of it may be missing", {}};
}

}  // namespace kerf::teach
