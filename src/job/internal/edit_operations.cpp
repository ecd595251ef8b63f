#include "job/internal/edit_operations.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "features/edit/arc_ways.hpp"
#include "geometry/angle.hpp"
#include "job/internal/edit_contours.hpp"

namespace kerf::job {
namespace {

using contour::Edge;
using contour::Vec2;
using features::EditOperation;

constexpr EditTakes kTakesElements{.layer = true, .island = true, .rule = true};
constexpr EditTakes kTakesLayer{.layer = true, .rule = true};
constexpr EditTakes kTakesIsland{.island = true};  // all layers
constexpr EditTakes kTakesAll{.layer = true, .island = true, .rule = true};
constexpr EditTakes kTakesTarget{};
constexpr EditTakes kTakesCall{.target = false, .call = true};

/// One operation's members, and points of the file.
struct OperationReader {
  EditReading& reading;
  JsonMembers& members;

  [[nodiscard]] Vec2 point(std::string_view name) const {
    return point_at(reading, members.need(name), in_quotes(name));
  }
  [[nodiscard]] std::optional<Vec2> point_if(std::string_view name) const {
    return members.has(name) ? std::optional{point(name)} : std::nullopt;
  }
  [[nodiscard]] std::vector<Vec2> three_points(std::string_view name) const {
    const std::size_t value = members.need(name);
    std::vector<Vec2> points;
    for (const std::size_t one : elements_at(reading.json, value, in_quotes(name))) {
      points.push_back(point_at(reading, one, "A POINT OF " + in_quotes(name)));
    }
    if (points.size() != 3) throw Misread{in_quotes(name) + " IS NOT THREE POINTS", value};
    return points;
  }
  /// Between what is said as diameters of a lathe, and the radii that arcs lie on.
  [[nodiscard]] Vec2 in_plane(Vec2 told) const {
    return {told.u, reading.turns ? told.v / 2 : told.v};
  }
  [[nodiscard]] Edge as_told(Edge edge) const {
    if (!reading.turns) return edge;
    edge.from.v *= 2;
    edge.to.v *= 2;
    return edge;
  }
  /// Refuses what says the same in two ways.
  void expect_one_way(std::string_view one, std::initializer_list<std::string_view> others) const {
    if (!members.has(one)) return;
    for (const std::string_view other : others) {
      if (members.has(other)) {
        throw Misread{in_quotes(one) + " AND " + in_quotes(other) + " EXCLUDE EACH OTHER",
                      *members.find(other)};
      }
    }
  }
};

EditOperation read_replace(const OperationReader& read) {
  features::ReplaceContour wish;
  JsonMembers& members = read.members;
  if (const auto at = members.find("contour")) wish.contour = contour_at(read.reading, *at, true);
  if (const auto at = members.find("islands")) wish.islands = contours_at(read.reading, *at);
  if (const auto at = members.find("center_line")) {
    wish.centre_line = contour_at(read.reading, *at, false);
  }
  read.expect_one_way("center_line", {"contour", "islands"});
  if (!wish.contour && !wish.islands && !wish.centre_line) {
    members.refuse("`contour`, `islands` OR `center_line` IS MISSING");
  }
  return wish;
}

EditOperation read_add_line(const OperationReader& read) {
  Edge line{read.point("from"), {}};
  read.expect_one_way("to", {"length", "angle_deg"});
  if (const auto to = read.point_if("to")) {
    line.to = *to;
    if (line.from == line.to) read.members.refuse("A LINE FROM A POINT TO ITSELF");
    return features::AddElement{line};
  }
  const double length = read.members.positive("length");
  const auto [sine, cosine] = geometry::sine_cosine_deg(read.members.number("angle_deg"));
  const Vec2 from = read.in_plane(line.from);
  return features::AddElement{read.as_told({from, from + length * Vec2{cosine, sine}})};
}

bool is_clockwise(const OperationReader& read) {
  const std::string direction = read.members.word("direction");
  if (direction == "cw") return true;
  if (direction == "ccw") return false;
  throw Misread{"`direction` IS NEITHER `cw` NOR `ccw`", read.members.need("direction")};
}

EditOperation read_add_arc(const OperationReader& read) {
  JsonMembers& members = read.members;
  read.expect_one_way("through", {"center", "radius", "start_deg", "end_deg", "direction"});
  if (members.has("through")) {
    const auto points = read.three_points("through");
    const auto arc = features::arc_through(read.in_plane(points[0]), read.in_plane(points[1]),
                                           read.in_plane(points[2]));
    if (!arc) throw Misread{"NO ARC GOES THROUGH THE THREE POINTS", members.need("through")};
    return features::AddElement{read.as_told(*arc)};
  }
  const Vec2 centre = read.in_plane(read.point("center"));
  const double radius = members.positive("radius");
  const double start = members.number("start_deg");
  const double end = members.number("end_deg");
  const auto arc = features::arc_about(centre, radius, start, end, is_clockwise(read));
  if (!arc) throw Misread{"A WHOLE CIRCLE IS TWO ARCS", members.need("end_deg")};
  return features::AddElement{read.as_told(*arc)};
}

EditOperation read_modify_line(const OperationReader& read) {
  JsonMembers& members = read.members;
  read.expect_one_way("to", {"length", "angle_deg"});
  features::ModifyLine wish{members.count("element", 0), read.point_if("from"), read.point_if("to"),
                            members.positive_if("length"), members.number_if("angle_deg")};
  if (!wish.from && !wish.to && !wish.length && !wish.angle_deg) {
    members.refuse("`from`, `to`, `length` OR `angle_deg` IS MISSING");
  }
  return wish;
}

EditOperation read_modify_arc(const OperationReader& read) {
  JsonMembers& members = read.members;
  read.expect_one_way("through", {"radius", "center", "start_deg", "end_deg"});
  features::ModifyArc wish{members.count("element", 0),  members.positive_if("radius"),
                           read.point_if("center"),      members.number_if("start_deg"),
                           members.number_if("end_deg"), {}};
  if (members.has("through")) wish.through = read.three_points("through");
  const bool says_something =
      wish.radius || wish.centre || wish.start_deg || wish.end_deg || !wish.through.empty();
  if (!says_something) {
    members.refuse("`radius`, `center`, `start_deg`, `end_deg` OR `through` IS MISSING");
  }
  return wish;
}

EditOperation read_join(const OperationReader& read) {
  const std::size_t value = read.members.need("elements");
  const auto numbers = elements_at(read.reading.json, value, "`elements`");
  if (numbers.size() != 2) throw Misread{"`elements` IS NOT TWO ELEMENTS", value};
  const auto element = [&](std::size_t at) {
    const double number = number_at(read.reading.json, at, "AN ELEMENT");
    if (number < 0 || number != static_cast<double>(static_cast<std::size_t>(number))) {
      throw Misread{"AN ELEMENT IS NO WHOLE NUMBER FROM 0", at};
    }
    return static_cast<std::size_t>(number);
  };
  return features::JoinElements{element(numbers[0]), element(numbers[1])};
}

features::ChamferCorner chamfer_lengths(const OperationReader& read) {
  JsonMembers& members = read.members;
  read.expect_one_way("d", {"d1", "d2"});
  read.expect_one_way("angle_deg", {"d1", "d2"});
  features::ChamferCorner wish;
  if (!members.has("d") && !members.has("angle_deg")) {
    wish.before = members.positive("d1");
    wish.after = members.positive("d2");
    return wish;
  }
  wish.before = members.positive("d");
  const double angle = members.positive("angle_deg");
  if (angle >= 180) throw Misread{"`angle_deg` IS NOT BELOW 180", members.need("angle_deg")};
  wish.angle_deg = angle;
  return wish;
}

EditOperation read_chamfer(const OperationReader& read) {
  features::ChamferCorner wish = chamfer_lengths(read);
  wish.corner = read.members.count("corner", 0);
  return wish;
}
EditOperation read_chamfer_all(const OperationReader& read) { return chamfer_lengths(read); }

EditOperation read_fillet(const OperationReader& read) {
  return features::FilletCorner{read.members.count("corner", 0), read.members.positive("r")};
}
EditOperation read_fillet_all(const OperationReader& read) {
  return features::FilletCorner{{}, read.members.positive("r")};
}

EditOperation read_delete(const OperationReader& read) {
  return features::DeleteElement{read.members.count("element", 0)};
}

EditOperation read_add_island(const OperationReader& read) {
  return features::AddIsland{contour_at(read.reading, read.members.need("contour"), true)};
}
EditOperation read_delete_island(const OperationReader& read) {
  return features::DeleteIsland{read.members.count("island", 0)};
}

EditOperation read_move(const OperationReader& read) {
  JsonMembers& members = read.members;
  const auto dx = members.number_if("dx");
  const auto dy = members.number_if("dy");
  const auto dz = members.number_if("dz");
  if (!dx && !dy && !dz) members.refuse("`dx`, `dy` OR `dz` IS MISSING");
  return features::MoveFeature{dx.value_or(0), dy.value_or(0), dz.value_or(0)};
}

EditOperation read_rotate(const OperationReader& read) {
  return features::RotateFeature{read.members.number("deg"), read.point_if("about")};
}
EditOperation read_scale(const OperationReader& read) {
  return features::ScaleFeature{read.members.positive("factor"), read.point_if("about")};
}

EditOperation read_depth(const OperationReader& read) {
  const features::SetDepth wish{read.members.number_if("z"), read.members.number_if("x")};
  if (!wish.z && !wish.x) read.members.refuse("`z` OR `x` IS MISSING");
  return wish;
}

EditOperation read_delete_feature(const OperationReader&) { return features::DeleteFeature{}; }
EditOperation read_hole_move(const OperationReader& read) {
  return features::MoveHole{read.point("to")};
}
EditOperation read_hole_add(const OperationReader& read) {
  return features::AddHole{read.point("at")};
}
EditOperation read_peck(const OperationReader& read) {
  return features::SetPeck{read.members.positive("q")};
}

EditOperation read_feed(const OperationReader& read) {
  const features::SetFeed wish{read.members.positive_if("cut"), read.members.positive_if("entry")};
  if (!wish.cut && !wish.entry) read.members.refuse("`cut` OR `entry` IS MISSING");
  return wish;
}

EditOperation read_tool(const OperationReader& read) {
  return features::SetTool{static_cast<std::uint32_t>(read.members.count("tool", 1)),
                           read.members.flag_if("split")};
}

EditOperation read_order(const OperationReader& read) {
  JsonMembers& members = read.members;
  read.expect_one_way("before", {"after"});
  if (const auto before = members.word_if("before")) return features::ChangeOrder{true, *before};
  if (const auto after = members.word_if("after")) return features::ChangeOrder{false, *after};
  members.refuse("`before` OR `after` IS MISSING");
}

EditOperation read_argument(const OperationReader& read) {
  JsonMembers& members = read.members;
  read.expect_one_way("letter", {"variable"});
  features::SetArgument wish;
  wish.value = members.number("value");
  if (const auto letter = members.word_if("letter")) {
    const bool is_letter = letter->size() == 1 && letter->front() >= 'A' && letter->front() <= 'Z';
    if (!is_letter) throw Misread{"`letter` IS NO LETTER FROM A TO Z", members.need("letter")};
    if (!members.has("call")) members.refuse("`call` IS MISSING");
    wish.letter = *letter;
    return wish;
  }
  if (!members.has("variable")) members.refuse("`letter` OR `variable` IS MISSING");
  wish.variable = static_cast<std::uint32_t>(members.count("variable", 1));
  return wish;
}

EditOperation read_unroll(const OperationReader&) { return features::Unroll{}; }

struct NamedOperation {
  std::string_view name;
  EditOperation (*read)(const OperationReader&);
  EditTakes takes;
};

constexpr std::array kOperations{
    NamedOperation{"replace", read_replace, kTakesElements},
    NamedOperation{"add-line", read_add_line, kTakesElements},
    NamedOperation{"add-arc", read_add_arc, kTakesElements},
    NamedOperation{"modify-line", read_modify_line, kTakesElements},
    NamedOperation{"modify-arc", read_modify_arc, kTakesElements},
    NamedOperation{"join", read_join, kTakesElements},
    NamedOperation{"chamfer", read_chamfer, kTakesElements},
    NamedOperation{"chamfer-all", read_chamfer_all, kTakesElements},
    NamedOperation{"fillet", read_fillet, kTakesElements},
    NamedOperation{"fillet-all", read_fillet_all, kTakesElements},
    NamedOperation{"delete", read_delete, kTakesElements},
    NamedOperation{"add-island", read_add_island, kTakesLayer},
    NamedOperation{"delete-island", read_delete_island, kTakesLayer},
    NamedOperation{"move", read_move, kTakesIsland},
    NamedOperation{"rotate", read_rotate, kTakesAll},
    NamedOperation{"scale", read_scale, kTakesAll},
    NamedOperation{"depth", read_depth, kTakesTarget},
    NamedOperation{"delete-feature", read_delete_feature, kTakesTarget},
    NamedOperation{"hole-move", read_hole_move, kTakesTarget},
    NamedOperation{"hole-add", read_hole_add, kTakesTarget},
    NamedOperation{"hole-delete", read_delete_feature, kTakesTarget},
    NamedOperation{"peck", read_peck, kTakesTarget},
    NamedOperation{"feed", read_feed, kTakesTarget},
    NamedOperation{"tool", read_tool, kTakesTarget},
    NamedOperation{"order", read_order, kTakesTarget},
    NamedOperation{"argument", read_argument, kTakesCall},
    NamedOperation{"unroll", read_unroll, kTakesTarget},
};

}  // namespace

ReadOperation read_operation(EditReading& reading, JsonMembers& members) {
  const std::string name = members.word("op");
  const auto* const found =
      std::find_if(kOperations.begin(), kOperations.end(),
                   [&](const NamedOperation& operation) { return operation.name == name; });
  if (found == kOperations.end()) {
    throw Misread{"NO OPERATION " + in_quotes(name), members.need("op")};
  }
  return {found->read({reading, members}), found->takes};
}

}  // namespace kerf::job
