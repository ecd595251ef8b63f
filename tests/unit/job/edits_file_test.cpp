#include "job/edits_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace kerf::job {
namespace {

using contour::Edge;
using contour::Vec2;
using features::Edit;

std::string file_of(const std::string& edits) { return R"({"version":1,"edits":[)" + edits + "]}"; }

/// The only edit of a file.
Edit edit_of(const std::string& edit, bool turns = false) {
  const auto edits = read_edits(file_of(edit), turns);
  EXPECT_TRUE(edits) << edit << ": " << edits.error().sentence;
  if (!edits || edits->size() != 1) return {};
  return edits->front();
}

template <typename Operation>
Operation read(const std::string& members, bool turns = false) {
  const Edit edit = edit_of(R"({"feature":"F1",)" + members + "}", turns);
  const auto* const operation = std::get_if<Operation>(&edit.operation);
  EXPECT_NE(operation, nullptr) << members;
  return operation == nullptr ? Operation{} : *operation;
}

void expect_near(Vec2 actual, Vec2 expected) {
  EXPECT_NEAR(actual.u, expected.u, 1e-9);
  EXPECT_NEAR(actual.v, expected.v, 1e-9);
}

TEST(EditsFile, TellsWhereEachEditBegins) {
  const auto edits = read_edits(
      "{\"version\": 1, \"edits\": [\n  {\"feature\":\"F1\",\"layer\":2,\"op\":\"delete\","
      "\"element\":5},\n    {\"pattern\":\"P1\",\"op\":\"depth\",\"z\":-20}]}\n");
  ASSERT_TRUE(edits);
  ASSERT_EQ(edits->size(), 2U);
  EXPECT_EQ((*edits)[0].target, "F1");
  EXPECT_EQ((*edits)[0].layer, 2U);
  EXPECT_EQ((*edits)[0].line, 2U);
  EXPECT_EQ((*edits)[0].column, 3U);
  EXPECT_EQ((*edits)[1].target, "P1");
  EXPECT_EQ((*edits)[1].layer, std::nullopt);
  EXPECT_EQ((*edits)[1].line, 3U);
  EXPECT_EQ((*edits)[1].column, 5U);
}

TEST(EditsFile, HasLayersIslandScopeAndUnroll) {
  const Edit plain = edit_of(R"({"feature":"5b3956dc","op":"unroll"})");
  EXPECT_TRUE(std::holds_alternative<features::Unroll>(plain.operation));
  EXPECT_EQ(plain.target, "5b3956dc");
  EXPECT_EQ(plain.layers, features::LayerRule::rebuild);
  EXPECT_EQ(plain.scope, features::EditScope::unsaid);
  EXPECT_FALSE(plain.unrolls);
  const Edit full = edit_of(R"({"feature":"F1","layer":3,"island":0,"layers":"only",
    "scope":"this","unroll":true,"op":"fillet-all","r":2})");
  EXPECT_EQ(full.layer, 3U);
  EXPECT_EQ(full.island, 0U);
  EXPECT_EQ(full.layers, features::LayerRule::only);
  EXPECT_EQ(full.scope, features::EditScope::this_call);
  EXPECT_TRUE(full.unrolls);
  EXPECT_EQ(
      edit_of(R"({"feature":"F1","layers":"all","scope":"all","op":"scale","factor":2})").scope,
      features::EditScope::all);
}

TEST(EditsFile, ReadsContours) {
  const auto wish = read<features::ReplaceContour>(
      R"("op":"replace","contour":[[10,10],[40,10,0.5],[40,38,0]],"islands":[[[20,20],[24,20,-1]]])");
  ASSERT_TRUE(wish.contour && wish.islands);
  ASSERT_EQ(wish.contour->vertices.size(), 3U);
  EXPECT_TRUE(wish.contour->is_closed);
  EXPECT_EQ(wish.contour->vertices[1], (contour::Vertex{{40, 10}, 0.5}));
  EXPECT_EQ(wish.islands->at(0).vertices[1].bulge, -1);
  EXPECT_FALSE(wish.centre_line);
  const auto line = read<features::ReplaceContour>(R"("op":"replace","center_line":[[0,0],[9,0]])");
  ASSERT_TRUE(line.centre_line);
  EXPECT_FALSE(line.centre_line->is_closed);
  EXPECT_EQ(read<features::AddIsland>(R"("op":"add-island","contour":[[21,30,1],[39,30,1]])")
                .contour.vertices.size(),
            2U);
  EXPECT_EQ(read<features::DeleteIsland>(R"("op":"delete-island","island":2)").island, 2U);
}

TEST(EditsFile, ReadsLines) {
  const Edge line =
      read<features::AddElement>(R"("op":"add-line","from":[0,0],"length":10,"angle_deg":30)").edge;
  expect_near(line.to, {5 * std::numbers::sqrt3, 5});
  EXPECT_EQ(line.bulge, 0);
  expect_near(read<features::AddElement>(R"("op":"add-line","from":[1,2],"to":[3,4])").edge.to,
              {3, 4});
  const auto modified =
      read<features::ModifyLine>(R"("op":"modify-line","element":3,"from":[10,10],"to":[45,10])");
  EXPECT_EQ(modified.element, 3U);
  EXPECT_EQ(modified.from, (Vec2{10, 10}));
  EXPECT_EQ(modified.to, (Vec2{45, 10}));
  EXPECT_EQ(read<features::ModifyLine>(R"("op":"modify-line","element":0,"length":7)").length, 7);
}

TEST(EditsFile, ReadsArcs) {
  const Edge through =
      read<features::AddElement>(R"("op":"add-arc","through":[[0,0],[5,5],[10,0]])").edge;
  expect_near(through.to, {10, 0});
  EXPECT_NEAR(through.bulge, -1, 1e-12);
  const std::string about =
      R"("op":"add-arc","center":[10,20],"radius":5,"start_deg":0,"end_deg":90,"direction":)";
  const Edge counterclockwise = read<features::AddElement>(about + R"("ccw")").edge;
  expect_near(counterclockwise.from, {15, 20});
  expect_near(counterclockwise.to, {10, 25});
  EXPECT_NEAR(contour::sweep_rad(counterclockwise), std::numbers::pi / 2, 1e-12);
  const Edge clockwise = read<features::AddElement>(about + R"("cw")").edge;
  EXPECT_NEAR(contour::sweep_rad(clockwise), -std::numbers::pi * 3 / 2, 1e-12);
  const auto modified = read<features::ModifyArc>(
      R"("op":"modify-arc","element":3,"radius":12,"center":[1,2],"start_deg":-30,"end_deg":40)");
  EXPECT_EQ(modified.radius, 12);
  EXPECT_EQ(modified.centre, (Vec2{1, 2}));
  EXPECT_EQ(modified.start_deg, -30);
  EXPECT_EQ(modified.end_deg, 40);
  EXPECT_EQ(
      read<features::ModifyArc>(R"("op":"modify-arc","element":3,"through":[[0,0],[5,5],[10,0]])")
          .through.size(),
      3U);
}

TEST(EditsFile, ArcsOfALatheLieOnRadii) {
  // From X20 to X40 about a point of X20 (diameters): a quarter of radius 10.
  const Edge about = read<features::AddElement>(
                         R"("op":"add-arc","center":[-30,20],"radius":10,"start_deg":0,
                            "end_deg":90,"direction":"ccw")",
                         true)
                         .edge;
  expect_near(about.from, {-20, 20});
  expect_near(about.to, {-30, 40});
  EXPECT_NEAR(contour::sweep_rad(about), std::numbers::pi / 2, 1e-12);
  const Edge through =
      read<features::AddElement>(R"("op":"add-arc","through":[[0,0],[5,10],[10,0]])", true).edge;
  EXPECT_NEAR(through.bulge, -1, 1e-12);
}

TEST(EditsFile, ReadsCorners) {
  const auto chamfer = read<features::ChamferCorner>(R"("op":"chamfer","corner":2,"d1":2,"d2":4)");
  EXPECT_EQ(chamfer.corner, 2U);
  EXPECT_EQ(chamfer.before, 2);
  EXPECT_EQ(chamfer.after, 4);
  EXPECT_FALSE(chamfer.angle_deg);
  const auto angled = read<features::ChamferCorner>(R"("op":"chamfer-all","d":3,"angle_deg":30)");
  EXPECT_FALSE(angled.corner);
  EXPECT_EQ(angled.before, 3);
  EXPECT_EQ(angled.angle_deg, 30);
  EXPECT_EQ(read<features::FilletCorner>(R"("op":"fillet","corner":0,"r":3)").corner, 0U);
  EXPECT_FALSE(read<features::FilletCorner>(R"("op":"fillet-all","r":3)").corner);
  const auto join = read<features::JoinElements>(R"("op":"join","elements":[0,4])");
  EXPECT_EQ(join.first, 0U);
  EXPECT_EQ(join.second, 4U);
  EXPECT_EQ(read<features::DeleteElement>(R"("op":"delete","element":5)").element, 5U);
}

TEST(EditsFile, ReadsWhatPlacesAFeature) {
  const auto move = read<features::MoveFeature>(R"("op":"move","dx":1.5,"dy":-2)");
  EXPECT_EQ(move.dx, 1.5);
  EXPECT_EQ(move.dy, -2);
  EXPECT_EQ(read<features::MoveFeature>(R"("op":"move","dz":-4)").dz, -4);
  const auto turn = read<features::RotateFeature>(R"("op":"rotate","deg":30,"about":[1,2])");
  EXPECT_EQ(turn.deg, 30);
  EXPECT_EQ(turn.about, (Vec2{1, 2}));
  EXPECT_EQ(read<features::ScaleFeature>(R"("op":"scale","factor":1.2)").factor, 1.2);
  EXPECT_EQ(read<features::SetDepth>(R"("op":"depth","z":-5)").z, -5);
  EXPECT_EQ(read<features::SetDepth>(R"("op":"depth","x":37)").x, 37);
  (void)read<features::DeleteFeature>(R"("op":"delete-feature")");
}

TEST(EditsFile, ReadsHolesToolsAndOrder) {
  EXPECT_EQ(read<features::MoveHole>(R"("op":"hole-move","to":[30,14])").to, (Vec2{30, 14}));
  EXPECT_EQ(read<features::AddHole>(R"("op":"hole-add","at":[70,10])").at, (Vec2{70, 10}));
  (void)read<features::DeleteFeature>(R"("op":"hole-delete")");
  EXPECT_EQ(read<features::SetPeck>(R"("op":"peck","q":2)").depth, 2);
  const auto feed = read<features::SetFeed>(R"("op":"feed","cut":300)");
  EXPECT_EQ(feed.cut, 300);
  EXPECT_FALSE(feed.entry);
  const auto tool = read<features::SetTool>(R"("op":"tool","tool":9,"split":true)");
  EXPECT_EQ(tool.tool, 9U);
  EXPECT_TRUE(tool.split);
  const auto order = read<features::ChangeOrder>(R"("op":"order","after":"F3")");
  EXPECT_FALSE(order.is_before);
  EXPECT_EQ(order.other, "F3");
}

TEST(EditsFile, ReadsArguments) {
  const Edit call = edit_of(R"({"call":"C1","op":"argument","letter":"R","value":35})");
  EXPECT_EQ(call.target, "C1");
  const auto* const letter = std::get_if<features::SetArgument>(&call.operation);
  ASSERT_NE(letter, nullptr);
  EXPECT_EQ(letter->letter, "R");
  EXPECT_EQ(letter->value, 35);
  const Edit main = edit_of(R"({"op":"argument","variable":101,"value":-2.5})");
  const auto* const variable = std::get_if<features::SetArgument>(&main.operation);
  ASSERT_NE(variable, nullptr);
  EXPECT_EQ(variable->variable, 101U);
  EXPECT_TRUE(main.target.empty());
}

struct Wrong {
  std::string text;
  std::string sentence;
  std::uint32_t line;
  std::uint32_t column;
};

TEST(EditsFile, ThatIsWrongIsToldWithItsPlace) {
  const std::string f1 = R"({"feature":"F1",)";
  const std::vector<Wrong> wrongs{
      {"", "THIS IS NO JSON", 1, 1},
      {"[]", "THIS IS NO OBJECT", 1, 1},
      {"{}", "`version` IS MISSING", 1, 1},
      {"{\"version\":2,\"edits\":[]}", "THIS IS NOT VERSION 1", 1, 12},
      {"{\"version\":\"1\",\"edits\":[]}", "`version` IS NO NUMBER", 1, 12},
      {"{\"version\":1}", "`edits` IS MISSING", 1, 1},
      {"{\"version\":1,\"edits\":{}}", "`edits` IS NO LIST", 1, 22},
      {"{\"version\":1,\n\"edits\":[],\n \"more\":0}", "THE FILE HAS NO MEMBER `more`", 3, 2},
      {"{\"version\":1,\n\"edits\":[],\n \"version\":1}", "`version` IS SAID TWICE", 3, 2},
      {"{\"version\":1,\n\"edits\":[}", "THIS IS NO JSON", 2, 10},
      {"\xEF\xBB\xBF{\"version\":2}", "THIS IS NOT VERSION 1", 1, 15},
      {"[[[[[[[[[[]]]]]]]]]]", "NOTHING LIES SO DEEP", 1, 9},
      {file_of("7"), "THIS IS NO OBJECT", 1, 23},
      {file_of(f1 + R"("op":"weld"})"), "NO OPERATION `weld`", 1, 44},
      {file_of(R"({"feature":"F1"})"), "`op` IS MISSING", 1, 23},
      {file_of(R"({"op":"delete","element":1})"), "`feature` IS MISSING", 1, 23},
      {file_of(f1 + R"("pattern":"P1","op":"depth","z":1})"), "TWO TARGETS OF ONE EDIT", 1, 49},
      {file_of(f1 + R"("op":"delete","element":1,"r":2})"),
       "THE OPERATION `delete` HAS NO MEMBER `r`", 1, 65},
      {file_of(f1 + R"("op":"delete","element":-1})"), "`element` IS NO WHOLE NUMBER FROM 0", 1,
       63},
      {file_of(f1 + R"("op":"delete","element":1.5})"), "`element` IS NO WHOLE NUMBER FROM 0", 1,
       63},
      {file_of(f1 + R"("layer":0,"op":"delete","element":1})"), "`layer` IS NO WHOLE NUMBER FROM 1",
       1, 47},
      {file_of(f1 + R"("op":"depth","z":"low"})"), "`z` IS NO NUMBER", 1, 56},
      {file_of(f1 + R"("op":"depth","z":1e7})"), "`z` IS BEYOND 1000000", 1, 56},
      {file_of(f1 + R"("op":"depth"})"), "`z` OR `x` IS MISSING", 1, 23},
      {file_of(f1 + R"("op":"fillet-all","r":0})"), "`r` IS NOT ABOVE 0", 1, 61},
      {file_of(f1 + R"("op":"add-island","contour":[[0,0],[1]]})"),
       "A POINT OF A CONTOUR IS [x, y] OR [x, y, bulge]", 1, 74},
      {file_of(f1 + R"("op":"add-island","contour":[[0,0],[1,null]]})"),
       "A COORDINATE IS NO NUMBER", 1, 77},
      {file_of(f1 + R"("op":"add-island","contour":[[0,0]]})"), "A CONTOUR HAS TWO POINTS OR MORE",
       1, 67},
      {file_of(f1 + R"("op":"add-arc","through":[[0,0],[1,1],[2,2]]})"),
       "NO ARC GOES THROUGH THE THREE POINTS", 1, 64},
      {file_of(f1 + R"("op":"chamfer-all","d":3,"d1":2,"angle_deg":45})"),
       "`d` AND `d1` EXCLUDE EACH OTHER", 1, 69},
      {file_of(f1 + R"("scope":"some","op":"unroll"})"), "`scope` IS NEITHER `all` NOR `this`", 1,
       47},
      {file_of(f1 + R"("unroll":1,"op":"unroll"})"), "`unroll` IS NEITHER true NOR false", 1, 48},
      {file_of(R"({"call":"C1","op":"argument","letter":"r","value":1})"),
       "`letter` IS NO LETTER FROM A TO Z", 1, 61}};
  for (const Wrong& wrong : wrongs) {
    const auto edits = read_edits(wrong.text);
    ASSERT_FALSE(edits) << wrong.text;
    EXPECT_EQ(edits.error().sentence, wrong.sentence) << wrong.text;
    EXPECT_EQ(edits.error().line, wrong.line) << wrong.text;
    EXPECT_EQ(edits.error().column, wrong.column) << wrong.text;
  }
}

// The example of the manual, with what strings and numbers may hold.
const std::string kExample = R"({"version":1, "edits":[
 {"feature":"F1","layer":2,"op":"replace","contour":[[10,10,0],[4.0e1,10,0],[40,38,0],[10,38,-0.5]]},
 {"feature":"F1","layer":2,"op":"fillet","corner":1,"r":3},
 {"feature":"\u00e9\"\\","op":"order","before":"H1"},
 {"feature":"F1","unroll":false,"op":"add-arc","through":[[0,0],[5,5],[10,0]]}]}
)";

TEST(EditsFile, CutOffAnywhereIsToldWithAPlaceInIt) {
  ASSERT_TRUE(read_edits(kExample));
  const auto lines = static_cast<std::uint32_t>(std::count(kExample.begin(), kExample.end(), '\n'));
  for (std::size_t length = 0; length + 1 < kExample.size(); ++length) {
    const auto edits = read_edits(kExample.substr(0, length));
    ASSERT_FALSE(edits) << length;
    EXPECT_FALSE(edits.error().sentence.empty());
    EXPECT_GE(edits.error().line, 1U);
    EXPECT_LE(edits.error().line, lines);
    EXPECT_GE(edits.error().column, 1U);
    EXPECT_LE(edits.error().column, length + 1);
  }
}

TEST(EditsFile, WithAnyByteChangedIsReadOrTold) {
  for (std::size_t at = 0; at < kExample.size(); ++at) {
    for (const char byte : {'\0', '"', '\\', '[', '}', ',', '9', 'e', '\xFF', '\n'}) {
      std::string text = kExample;
      text[at] = byte;
      const auto edits = read_edits(text);
      EXPECT_TRUE(edits || !edits.error().sentence.empty()) << at;
    }
  }
}

TEST(EditsFile, HasNoMoreEditsThanPeopleWrite) {
  std::string edits = R"({"feature":"F1","op":"unroll"})";
  std::string many = edits;
  for (int i = 1; i < 20000; ++i) many += "," + edits;
  EXPECT_TRUE(read_edits(file_of(many)));
  const auto more = read_edits(file_of(many + "," + edits));
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().sentence, "MORE THAN 20000 EDITS");
}

TEST(EditsFile, HasNoMorePointsThanAMillion) {
  std::string points = "[0,0]";
  points.reserve(6'000'100);
  for (int i = 1; i < 1'000'000; ++i) points += ",[0,0]";
  const std::string before = R"({"feature":"F1","op":"add-island","contour":[)";
  EXPECT_TRUE(read_edits(file_of(before + points + "]}")));
  const auto more = read_edits(file_of(before + points + ",[0,0]]}"));
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().sentence, "MORE THAN 1000000 POINTS OF CONTOURS");
}

}  // namespace
}  // namespace kerf::job
