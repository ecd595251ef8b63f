#include "job/facts_of_edit.hpp"

#include "base/checksum.hpp"

namespace kerf::job {
namespace {

void take_blocks(const EditReport& report, output::EditFacts& facts) {
  facts.blocks = {.kept = report.blocks.kept,
                  .patched = report.blocks.patched,
                  .inserted = report.blocks.inserted,
                  .removed = report.blocks.removed};
  for (const EditReport::Regenerated& one : report.regenerated)
    facts.regenerated.push_back({one.feature, one.layers});
  for (const features::RenamedLayer& one : report.ids)
    facts.ids.push_back({one.was, one.was_layer, one.is, one.is_layer});
}

void take_verified(const features::VerifiedEdit& verified, output::EditFacts& facts) {
  facts.verified = {.recognised = verified.recognised,
                    .others_unchanged = verified.others_unchanged,
                    .contour_error_mm = verified.contour_error_mm,
                    .difference_mm3 = verified.difference_mm3,
                    .outside_mm3 = verified.outside_mm3,
                    .corner_rest_mm2 = verified.corner_rest_mm2,
                    .new_findings = verified.new_findings,
                    .findings_skipped = verified.findings_skipped,
                    .time_before_s = verified.time_before_s,
                    .time_after_s = verified.time_after_s};
}

}  // namespace

output::EditFacts facts_of(const EditResult& result) {
  const EditReport& report = result.report;
  output::EditFacts facts{
      .edits = report.edits, .bytes_changed = report.bytes_changed, .crc32 = report.crc32};
  for (const TextChange& change : report.changes)
    facts.changes.push_back({change.file, change.first, change.old_lines, change.new_lines});
  take_blocks(report, facts);
  take_verified(report.verified, facts);
  for (const features::EditFault& warning : report.warnings)
    facts.warnings.push_back({warning.edit, warning.code, warning.sentence});
  for (const EditedText& text : result.texts) {
    if (!text.is_main) facts.libraries.push_back({text.file, base::crc32(text.after)});
  }
  return facts;
}

}  // namespace kerf::job
