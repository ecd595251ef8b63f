// Tools of other programs.
#include "machine/definition/tools/tool_import.hpp"

#include <gtest/gtest.h>
#include <zip.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "machine/definition/tools/internal/zip_archive.hpp"

namespace kerf::machine {
namespace {

using stock::Measure;
using stock::Tool;

ToolLibrary library_of(const std::string& text, ToolsUnit unit = ToolsUnit::mm) {
  auto library = read_tools(text, "tools", unit);
  EXPECT_TRUE(library) << library.error().message;
  return library ? *library : ToolLibrary{};
}

std::string refusal(const std::string& text) {
  const auto library = read_tools(text, "tools", ToolsUnit::mm);
  return library ? "" : library.error().message;
}

TEST(ToolImport, OfLinuxcncHasNumberDiameterLengthAndTheKindThatItsTextNames) {
  const std::string table =
      ";tools\nT1 P1 D6.0 Z+80.5 ;6 mm flat end mill\nT2 P2 D0.25 Z-1.5;ball 1/4\n"
      "T3  P3  D8.5 ; drill\nT4 P4 Z12.5 ;no diameter\n";
  const ToolLibrary library = library_of(table);
  ASSERT_EQ(library.tools.size(), 4U);
  EXPECT_EQ(library.tools[0].type, "flat");
  EXPECT_EQ(library.tools[0].said(Measure::length), 80.5);
  EXPECT_EQ(library.tools[1].type, "ball");
  EXPECT_EQ(library.tools[2].type, "drill");
  EXPECT_EQ(library.tools[3].said(Measure::length), 12.5);
  ASSERT_EQ(library.remarks.size(), 1U);
  EXPECT_EQ(library.remarks[0].number, 4);
  EXPECT_EQ(library_of(table, ToolsUnit::inch).tools[1].said(Measure::diameter), 6.35);
}

// The tools of LinuxCNC's own sample configuration: one insert in all its directions.
TEST(ToolImport, OfLinuxcncKnowsTheDirectionsOfInserts) {
  const ToolLibrary library = library_of(
      "T1 P1 D0.8 Z+0.1 I+95 J+155 Q1 ;\nT2 P2 D0.8 I+85 J+25 Q2 ;\nT3 P3 D0.8 I+275 J+335 Q3 ;\n"
      "T4 P4 D0.8 I+265 J+205 Q4 ;\nT5 P5 D0.8 I+210 J+150 Q5 ;\nT7 P7 D0.8 I-30 J+30 Q7\n"
      "T9 P9 D0.8 Q9 ;\n");
  ASSERT_EQ(library.tools.size(), 7U);
  const std::array<int, 7> tips = {4, 3, 2, 1, 5, 7, 9};
  for (std::size_t i = 0; i < 7; ++i) {
    const Tool& tool = library.tools[i];
    EXPECT_EQ(tool.said(Measure::tip), tips[i]) << i;
    EXPECT_EQ(tool.said(Measure::nose_radius), 0.4);
    if (i < 6) {
      EXPECT_EQ(tool.said(Measure::tip_angle), 60) << i;
    }
    if (i < 4) {
      EXPECT_EQ(tool.said(Measure::kapr), 95) << i;
    }
  }
  EXPECT_TRUE(library.remarks.empty());
}

constexpr const char* kFusion = R"({"data":[
 {"type":"holder","description":"ER20"},
 {"type":"bull nose end mill","unit":"millimeters","description":"12 R2",
  "geometry":{"DC":12,"LCF":26,"LB":45,"OAL":83,"NOF":4,"RE":2,"SFDM":12,"HAND":true,"CSP":false,
              "assemblyGaugeLength":120,"shoulder-length":30,"shoulder-diameter":11.5},
  "holder":{"segments":[{"height":25,"lower-diameter":30,"upper-diameter":40},
                        {"height":40,"lower-diameter":63,"upper-diameter":63}]},
  "post-process":{"number":5}},
 {"type":"drill","unit":"inches","geometry":{"DC":0.25,"SIG":118,"LCF":2,"LB":2.5,"SFDM":0.25},
  "post-process":{"number":6}},
 {"type":"chamfer mill","unit":"millimeters",
  "geometry":{"DC":10,"TA":45,"tip-diameter":1,"LCF":4.5},"post-process":{"number":7}},
 {"type":"slot mill","unit":"millimeters",
  "geometry":{"DC":16,"LCF":4,"LB":30,"shoulder-diameter":7,"shoulder-length":20,"SFDM":10},
  "post-process":{"number":8}},
 {"type":"tap left hand","unit":"millimeters","geometry":{"DC":8,"TP":1.25},
  "post-process":{"number":9}},
 {"type":"turning general","unit":"millimeters","geometry":{},"post-process":{"number":10}},
 {"type":"ball end mill","unit":"millimeters","geometry":{"DC":6,"LCF":1},
  "post-process":{"number":11}},
 {"type":"flat end mill","unit":"millimeters","geometry":{"DC":"six"},"post-process":{"number":12}},
 {"type":"flat end mill","unit":"millimeters","geometry":{"DC":6},"post-process":{"number":5}},
 {"type":"flat end mill","unit":"furlongs","geometry":{"DC":6},"post-process":{"number":13}},
 {"type":"flat end mill","unit":"millimeters","description":"spare","geometry":{"DC":6}},
 7, null, {}],"version":12})";

TEST(ToolImport, OfFusionHasWhatTheFieldsSay) {
  const ToolLibrary library = library_of(kFusion);
  ASSERT_EQ(library.tools.size(), 6U);
  const Tool& bull = library.tools[0];
  EXPECT_EQ(bull.number, 5);
  EXPECT_EQ(bull.type, "bull");
  EXPECT_EQ(bull.said(Measure::corner_radius), 2);
  EXPECT_EQ(bull.said(Measure::stickout), 45);
  EXPECT_EQ(bull.said(Measure::length), 120);
  EXPECT_EQ(bull.shank, (std::vector<stock::Segment>{{4, 11.5, 11.5}, {15, 12, 12}}));
  EXPECT_EQ(stock::profile_of(bull).height(), 110);
  const Tool& drill = library.tools[1];
  EXPECT_NEAR(*drill.said(Measure::diameter), 6.35, 1e-12);
  EXPECT_EQ(drill.said(Measure::angle), 118);
  EXPECT_EQ(drill.said(Measure::length), std::nullopt) << "lengths overall are no gauge lengths";
  EXPECT_EQ(library.tools[2].said(Measure::angle), 90);
  EXPECT_EQ(library.tools[2].said(Measure::tip_diameter), 1);
  EXPECT_EQ(library.tools[3].said(Measure::width), 4);
  EXPECT_EQ(stock::profile_of(library.tools[3]).radius_at(10), 3.5);
  EXPECT_EQ(library.tools[4].hand, stock::Hand::left);
  EXPECT_EQ(library.tools[5].said(Measure::flute_length), std::nullopt) << "a ball of 1 mm";
}

TEST(ToolImport, OfFusionTellsWhatItDoesNotUnderstandByTheNumberOfTheTool) {
  std::string all;
  for (const ImportRemark& remark : library_of(kFusion).remarks)
    all += std::to_string(remark.number) + ": " + remark.text + "\n";
  EXPECT_EQ(all,
            "10: type \"turning general\" is not understood\n"
            "11: flute_length, 1, ends where the tool has not its diameter yet: that begins at 3: "
            "it is left out\n"
            "12: a tool of type flat needs its diameter\n"
            "5: it is there more than once; the first one counts\n"
            "13: unit \"furlongs\" is not understood\n"
            "0: \"spare\" has no number that a program can call\n"
            "0: type \"\" is not understood\n0: type \"\" is not understood\n"
            "0: type \"\" is not understood\n");
}

/// An archive with one file in it.
std::string zipped(const std::string& name, const std::string& text) {
  zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  zip_source_keep(target);
  zip_t* const archive = zip_open_from_source(target, ZIP_TRUNCATE, nullptr);
  zip_source_t* const content = zip_source_buffer(archive, text.data(), text.size(), 0);
  zip_file_add(archive, name.c_str(), content, 0);
  zip_close(archive);
  zip_source_open(target);
  zip_stat_t status;
  zip_source_stat(target, &status);
  std::string bytes(status.size, '\0');
  zip_source_read(target, bytes.data(), bytes.size());
  zip_source_close(target);
  zip_source_free(target);
  return bytes;
}

TEST(ToolImport, OfAnArchiveIsThatOfItsLibrary) {
  EXPECT_EQ(library_of(zipped("tools.json", kFusion)).tools, library_of(kFusion).tools);
  EXPECT_EQ(refusal(zipped("readme.txt", "hello")), "tools: the archive holds no library, a .json");
  EXPECT_EQ(refusal(zipped("a.json", zipped("tools.json", kFusion))), "tools: its JSON is none");
}

TEST(ToolImport, DoesNotUnpackWithoutEnd) {
  const std::string bomb = zipped("tools.json", std::string(kLargestToolFile + 1, ' '));
  EXPECT_LT(bomb.size(), 100000U);
  EXPECT_EQ(refusal(bomb), "tools: its library is larger than 16 MiB");
}

TEST(ToolImport, OfDamagedFilesEndsInASentence) {
  EXPECT_NE(refusal(""), "");
  EXPECT_NE(refusal("G10 L11 P1 R5.\n"), "");
  EXPECT_NE(refusal("{\"data\":7}"), "");
  EXPECT_NE(refusal("{\"data\":[NaN]}"), "");
  EXPECT_NE(refusal("{\"data\":" + std::string(5000000, '[')), "");
  EXPECT_NE(refusal("{\"tools\":{}}"), "");
  EXPECT_NE(refusal("PK\x03\x04"), "");
  EXPECT_NE(refusal("[[tool]]\nnumber = \n"), "");
  const std::string deep = "{\"data\":[" + std::string(100, '[') + std::string(100, ']') + "]}";
  EXPECT_EQ(library_of(deep).tools.size(), 0U);
}

// Some bytes of a good file changed, or the end cut off: a sentence or tools, never anything else.
TEST(ToolImport, SurvivesEveryDamage) {
  std::mt19937 random(11);
  const std::vector<std::string> files = {
      kFusion, zipped("tools.json", kFusion), "T1 P1 D0.8 Z+0.1 I+95 J+155 Q1 ;\nT2 P2 D6 ;drill\n",
      "[[tool]]\nnumber = 1\ntype = \"bull\"\ndiameter = 6\ncorner_radius = 1\n"};
  for (int i = 0; i < 3000; ++i) {
    std::string text = files[random() % files.size()];
    const std::size_t changes = random() % 8;
    for (std::size_t k = 0; k < changes; ++k)
      text[random() % text.size()] = static_cast<char>(random());
    if (random() % 2 == 0) text.resize(random() % text.size());
    const auto library = read_tools(text, "tools", ToolsUnit::mm);
    if (!library) {
      EXPECT_FALSE(library.error().message.empty());
      continue;
    }
    for (const Tool& tool : library->tools) {
      if (!stock::objection(tool).empty() || tool.is_insert()) continue;
      EXPECT_FALSE(stock::profile_of(tool).is_empty());
    }
  }
}

/// A folder of its own, gone with the test.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / "kerf_tool_import_test") {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_ / "Library");
    std::filesystem::create_directories(path_ / "Bit");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

TEST(ToolImport, OfFreecadHasItsBitsWithTheirUnits) {
  const Folder folder;
  folder.write("Bit/end.fctb", R"({"version":2,"name":"5 mm","shape":"endmill.fcstd","parameter":{
    "CuttingEdgeHeight":"30.0000 mm","Diameter":"5.0000 mm","Length":"50.0000 mm",
    "ShankDiameter":"3.0000 mm","Flutes":2}})");
  folder.write("Bit/drill.fctb", R"({"shape":"drill.fcstd","parameter":{
    "Diameter":"1/4 in","TipAngle":"119.00 °","Length":"3 furlongs"}})");
  folder.write("Library/v.fctb", R"({"shape-type":"V-Bit","shape":"v-bit.fcstd","parameter":{
    "Diameter":"10,0 mm","CuttingEdgeAngle":"60 °"}})");
  folder.write("Library/saw.fctb", R"({"shape":"slittingsaw.fcstd","parameter":{
    "Diameter":"76.2 mm","BladeThickness":"3 mm","ShankDiameter":"19 mm"}})");
  folder.write("Bit/odd.fctb", R"({"shape":"spoon.fcstd","parameter":{}})");
  const std::string library = folder.write("Library/my.fctl", R"({"label":"mine","tools":[
    {"nr":1,"path":"end.fctb"},{"nr":2,"path":"drill.fctb"},{"nr":3,"path":"v.fctb"},
    {"nr":4,"path":"saw.fctb"},{"nr":5,"path":"odd.fctb"},{"nr":6,"path":"gone.fctb"},
    {"nr":7,"path":"/etc/passwd"},{"nr":8,"path":"../Bit/end.fctb"}],"version":1})");
  const auto read = read_tool_file(library, ToolsUnit::mm);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->tools.size(), 3U);
  EXPECT_EQ(read->tools[0].said(Measure::diameter), 5);
  EXPECT_EQ(read->tools[0].said(Measure::flute_length), 30);
  EXPECT_EQ(read->tools[0].shank, (std::vector<stock::Segment>{{20, 3, 3}}));
  EXPECT_EQ(read->tools[0].said(Measure::length), std::nullopt);
  EXPECT_NEAR(*read->tools[1].said(Measure::diameter), 6.35, 1e-12);
  EXPECT_EQ(read->tools[1].said(Measure::angle), 119);
  EXPECT_EQ(read->tools[2].type, "saw");
  EXPECT_EQ(read->tools[2].said(Measure::neck_diameter), 19);
  std::vector<int> told;
  for (const ImportRemark& remark : read->remarks) told.push_back(remark.number);
  EXPECT_EQ(told, (std::vector<int>{3, 3, 5, 6, 7, 8})) << "10,0 is no number; then it has none";
}

TEST(ToolImport, ToldByContent) {
  EXPECT_EQ(tool_format_of(kFusion), ToolFormat::fusion);
  EXPECT_EQ(tool_format_of("{\"tools\":[]}"), ToolFormat::freecad);
  EXPECT_EQ(tool_format_of("; head\n\nT1 P1 D5\n"), ToolFormat::linuxcnc);
  EXPECT_EQ(tool_format_of("# x\n[[tool]]\nnumber = 1\n"), ToolFormat::toml);
  EXPECT_EQ(tool_format_of("T1 M6\nG0 X0\n"), ToolFormat::other);
  EXPECT_EQ(tool_format_of("%\nG10 L10 P1 R80.\n"), ToolFormat::other);
  EXPECT_EQ(tool_format_of("[work.G54]\nX = 1\n"), ToolFormat::other);
}

}  // namespace
}  // namespace kerf::machine
