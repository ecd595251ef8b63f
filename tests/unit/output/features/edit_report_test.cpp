#include "output/features/edit_report.hpp"

#include <gtest/gtest.h>

namespace kerf::output {
namespace {

EditFacts facts() {
  EditFacts facts{.edits = 1, .bytes_changed = 4, .crc32 = 0x1fU};
  facts.changes.push_back({"p1.nc", 18, {"N180 X40 F300\r\n"}, {"N180 X30 F300\r\n"}});
  facts.blocks = {.kept = 48, .patched = 2};
  facts.regenerated.push_back({"F1", {2}});
  facts.ids.push_back({"F1", 2, "F2", 1});
  facts.verified = {.recognised = true,
                    .others_unchanged = true,
                    .difference_mm3 = -560,
                    .corner_rest_mm2 = 21.4601836602551,
                    .time_before_s = 81.2,
                    .time_after_s = 79.6};
  return facts;
}

TEST(EditReport, HasItsMembersInTheirOrder) {
  EXPECT_EQ(
      edit_report_json(facts()),
      R"({"kerf":"edit","version":1,"edits":1,"changes":[{"file":"p1.nc","first":18,)"
      R"("old":["N180 X40 F300\r\n"],"new":["N180 X30 F300\r\n"]}],"bytes_changed":4,)"
      R"("blocks":{"kept":48,"patched":2,"inserted":0,"removed":0},)"
      R"("regenerated":[{"feature":"F1","layers":[2]}],"ids":[{"was":["F1",2],"is":["F2",1]}],)"
      R"("verified":{"recognised":true,"others_unchanged":true,"contour_error_mm":0,)"
      R"("difference_mm3":-560,"outside_mm3":0,"corner_rest_mm2":21.460184,"new_findings":[],)"
      R"("findings_skipped":null,"time_s":[81.2,79.6]},"warnings":[],"crc32":"0000001f"})"
      "\n");
}

TEST(EditReport, KeepsBytesThatAreNoText) {
  EditFacts some = facts();
  some.changes[0].old_lines = {"(\xe4\xff)\n"};
  some.changes.push_back({"p1.nc", 20, {"(\xc3\xa4)\n"}, {}});
  const std::string json = edit_report_json(some);
  EXPECT_NE(json.find("\"old\":[\"(\xc3\xa4\xc3\xbf)\\n\"],\"new\":[\"N180 X30 F300\\r\\n\"],"
                      "\"encoding\":\"latin-1\"}"),
            std::string::npos)
      << json;
  EXPECT_NE(json.find("{\"file\":\"p1.nc\",\"first\":20,\"old\":[\"(\xc3\xa4)\\n\"],\"new\":[]}"),
            std::string::npos)
      << json;
}

TEST(EditReport, TellsWarningsAndOtherFiles) {
  EditFacts some = facts();
  some.warnings.push_back({0, base::Code::edit_outside_stock, "F1 GOES BEYOND THE STOCK BY 2 mm"});
  some.libraries.push_back({"lib/O9100.nc", 0xcbf43926U});
  const std::string json = edit_report_json(some);
  EXPECT_NE(json.find(R"("warnings":[{"edit":0,"code":"EDIT_OUTSIDE_STOCK",)"
                      R"("message":"F1 GOES BEYOND THE STOCK BY 2 mm"}],"crc32":"0000001f",)"
                      R"("libraries":[{"file":"lib/O9100.nc","crc32":"cbf43926"}]})"),
            std::string::npos)
      << json;
}

TEST(EditReport, IsToldToPeople) {
  EXPECT_EQ(edit_report_text(facts()),
            "2 blocks patched, 0 inserted, 0 removed, 48 kept\n"
            "  removes 560 mm³ less than before, leaves 21.46 mm² in corners\n"
            "  takes 79.6 s, 81.2 s before\n");
}

}  // namespace
}  // namespace kerf::output
