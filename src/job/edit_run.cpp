#include "job/edit_run.hpp"

#include <algorithm>
#include <map>

#include "base/checksum.hpp"
#include "base/decimal.hpp"
#include "features/merge/merge.hpp"
#include "features/merge/text_style.hpp"
#include "features/merge/tool_words.hpp"
#include "features/plan/edit_planner.hpp"
#include "features/rewrite/regenerate.hpp"
#include "job/features_run.hpp"
#include "job/internal/assignments.hpp"
#include "job/internal/block_texts.hpp"
#include "job/internal/changed_lines.hpp"
#include "job/internal/new_findings.hpp"
#include "job/internal/run_rack.hpp"
#include "job/text_changes.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::job {
namespace {

using base::Code;
using features::EditFault;

tl::unexpected<EditFault> refuse(Code code, std::string sentence, std::size_t edit = 0) {
  return tl::unexpected(EditFault{code, std::move(sentence), "", edit});
}

std::string text_of(const base::SourceFile& source) {
  std::string text(source.size(), '\0');
  text.resize(source.read(0, text));
  return text;
}

/// Whether a jump or a call of the text names an N word: GOTO10, P10, Q10.
bool is_named_in(const std::string& text, std::uint32_t sequence) {
  if (sequence == 0) return false;
  const std::string digits = std::to_string(sequence);
  for (std::size_t at = text.find(digits); at != std::string::npos;
       at = text.find(digits, at + 1)) {
    const std::size_t end = at + digits.size();
    const bool is_whole = end >= text.size() || text[end] < '0' || text[end] > '9';
    std::size_t before = at;
    while (before > 0 && (text[before - 1] == '0' || text[before - 1] == ' ')) --before;
    const char letter = before > 0 ? text[before - 1] : 'N';
    const bool names = letter == 'P' || letter == 'Q' || letter == 'O' || letter == 'o' ||
                       letter == 'p' || letter == 'q';
    if (is_whole && names) return true;
  }
  return false;
}

/// One edit of a program, from its text to the text that was verified.
class EditWork {
 public:
  EditWork(const StockJob& job, const EditWishes& wishes, FeaturesResult& before)
      : job_(job), wishes_(wishes), before_(before) {}

  [[nodiscard]] base::Outcome<features::Editing<EditResult>> make() {
    auto merged = merged_texts();
    if (!merged) return features::Editing<EditResult>(tl::unexpected(merged.error()));
    if (result_.texts.empty()) return unchanged();
    return verified();
  }

 private:
  using Done = features::Editing<void>;

  [[nodiscard]] const base::Language* language() const {
    const machine::DialectRow* const dialect =
        machine::find_dialect(before_.run->machine().definition().dialect);
    const bool is_gcode = dialect != nullptr && dialect->kind == machine::DialectRow::Kind::gcode;
    return is_gcode ? dialect->language : nullptr;
  }

  [[nodiscard]] std::map<base::FileId, std::string> texts() const {
    const base::SourceSet& sources = before_.run->machine().sources();
    std::map<base::FileId, std::string> texts;
    const features::Recording& recording = before_.recording;
    for (std::size_t i = 0; i < recording.blocks.size(); ++i) {
      const base::FileId file = recording.blocks[i].file;
      if (sources.contains(file) && texts.count(file) == 0)
        texts.emplace(file, text_of(sources[file]));
    }
    for (const features::Call& call : before_.tree.calls) {
      const base::FileId file = call.block.file;
      if (sources.contains(file) && texts.count(file) == 0)
        texts.emplace(file, text_of(sources[file]));
    }
    return texts;
  }

  [[nodiscard]] Done merged_texts() {
    if (language() == nullptr)
      return refuse(Code::edit_not_editable, "ONLY PROGRAMS IN G-CODE ARE EDITED");
    describe_tools();
    auto plan = features::plan_edits(before_.recording, before_.tree, wishes_.edits,
                                     {wishes_.allows_collision, wishes_.allows_rest});
    if (!plan) return tl::unexpected(plan.error());
    plan_ = std::move(*plan);
    const machine::BatchRun& run = before_.run->machine();
    BlockTexts reader(run.sources(), run.control(), language(), BlockTexts::Shapes::none);
    features::MergeSources sources{.language = *language(), .texts = texts()};
    sources.pointless = run.definition().parameters.calculator_point ? 0 : 0.001;
    sources.sets_up = [&](const base::BlockId& block) { return reader.sets_up(block); };
    sources.is_named = [&](const base::BlockId& block) {
      return is_named_in(sources.texts[block.file], block.sequence);
    };
    sources.x_counts = before_.recording.turns ? 2 : 1;
    auto merged = features::merge(before_.recording, plan_.rows, sources);
    if (!merged) return refuse(merged.error().code, merged.error().sentence);
    for (const features::ToolChange& tool : plan_.tools) {
      auto done = features::change_tool_words(before_.recording, {tool.was, tool.is, tool.rows},
                                              sources, *merged);
      if (!done) return refuse(done.error().code, done.error().sentence);
    }
    for (const std::size_t edit : plan_.arguments) {
      if (auto done = change_argument(edit, sources.texts, *merged); !done) return done;
    }
    return put_texts(*merged, sources.texts);
  }

  // Tools that edits name may not have moved so far.
  void describe_tools() {
    RunRack rack(job_, before_.run->machine(), {});
    for (const features::Edit& edit : wishes_.edits) {
      const auto* const wish = std::get_if<features::SetTool>(&edit.operation);
      if (wish == nullptr) continue;
      const stock::Tool& tool = rack.tool(wish->tool).tool;
      if (tool.source != stock::ToolSource::assumed)
        before_.recording.tools.emplace(wish->tool, tool);
    }
  }

  // The literal of a call, in its place.
  [[nodiscard]] Done change_argument(std::size_t edit,
                                     const std::map<base::FileId, std::string>& texts,
                                     features::Merged& merged) {
    const features::Edit& wish = wishes_.edits[edit];
    const auto& argument = std::get<features::SetArgument>(wish.operation);
    if (wish.target.empty()) return change_variable(edit, texts, merged);
    for (std::size_t i = 0; i < before_.tree.calls.size(); ++i) {
      const features::Call& call = before_.tree.calls[i];
      if (wish.target != "C" + std::to_string(i + 1)) continue;
      for (const features::Argument& its : call.words.arguments) {
        const bool is_it = argument.letter.empty() ? its.variable == argument.variable
                                                   : its.letter == argument.letter;
        if (!is_it) continue;
        if (!its.literal)
          return refuse(Code::edit_expression, its.letter + its.text + " IS AN EXPRESSION", edit);
        const auto& [file, text] = *texts.begin();
        const std::size_t at = start_of_line(text, call.line) + its.column;
        features::TextStyle style;
        merged.replacements[file].push_back(
            {at, its.text.size(), style.number_like(its.text, argument.value)});
        std::sort(merged.replacements[file].begin(), merged.replacements[file].end(),
                  [](const auto& a, const auto& b) { return a.from < b.from; });
        ++merged.patched;
        note_call(i);
        return {};
      }
    }
    return refuse(Code::edit_call_unknown, "NO ARGUMENT " + argument.letter + " OF " + wish.target,
                  edit);
  }

  // The literal of a `#n=` of the main program.
  [[nodiscard]] Done change_variable(std::size_t edit,
                                     const std::map<base::FileId, std::string>& texts,
                                     features::Merged& merged) {
    const auto& argument = std::get<features::SetArgument>(wishes_.edits[edit].operation);
    const std::string name = "#" + std::to_string(argument.variable);
    const auto main = std::find_if(texts.begin(), texts.end(), [&](const auto& text) {
      return before_.run->machine().sources()[text.first].name() == job_.job.program.name;
    });
    if (main == texts.end()) return refuse(Code::edit_call_unknown, "NO BLOCK SETS " + name, edit);
    const std::vector<Assignment> all =
        assignments_of(*language(), main->second, argument.variable);
    if (all.size() != 1) {
      return refuse(Code::edit_call_unknown,
                    (all.empty() ? "NO BLOCK" : std::to_string(all.size()) + " BLOCKS") +
                        std::string(all.empty() ? " SETS " : " SET ") + name,
                    edit);
    }
    const std::string old = main->second.substr(all.front().from, all.front().length);
    if (!base::read_number(old))
      return refuse(Code::edit_expression, name + "=" + old + " IS AN EXPRESSION", edit);
    features::TextStyle style;
    merged.replacements[main->first].push_back(
        {all.front().from, all.front().length, style.number_like(old, argument.value)});
    std::sort(merged.replacements[main->first].begin(), merged.replacements[main->first].end(),
              [](const auto& a, const auto& b) { return a.from < b.from; });
    ++merged.patched;
    note_expressions();
    return {};
  }

  // What blocks with variables have cut may become anything.
  void note_expressions() {
    using Kind = features::Origin::Kind;
    const auto is_open = [](const features::Origin& origin) {
      return origin.kind == Kind::expression || origin.kind == Kind::loop;
    };
    plan_.changes_more = true;
    for (std::size_t f = 0; f < before_.tree.features.size(); ++f) {
      if (!is_open(before_.tree.features[f].origin)) continue;
      for (std::size_t layer = 0; layer < before_.tree.features[f].layers.size(); ++layer)
        plan_.gone.emplace_back(f, layer);
    }
    for (std::size_t h = 0; h < before_.tree.holes.size(); ++h) {
      if (is_open(before_.tree.holes[h].origin)) plan_.edited_holes.push_back(h);
    }
  }

  // What a call has cut may become anything.
  void note_call(std::size_t call) {
    plan_.changes_more = true;
    for (const std::size_t feature : before_.tree.calls[call].features) {
      for (std::size_t layer = 0; layer < before_.tree.features[feature].layers.size(); ++layer)
        plan_.gone.emplace_back(feature, layer);
    }
    for (const std::size_t hole : before_.tree.calls[call].holes)
      plan_.edited_holes.push_back(hole);
  }

  [[nodiscard]] Done put_texts(const features::Merged& merged,
                               const std::map<base::FileId, std::string>& texts) {
    EditReport& report = result_.report;
    report.edits = wishes_.edits.size();
    report.blocks = {merged.kept, merged.patched, merged.inserted, merged.removed};
    const base::SourceSet& sources = before_.run->machine().sources();
    for (const auto& [file, text] : texts) {
      if (sources[file].name() == job_.job.program.name) report.crc32 = base::crc32(text);
    }
    for (const auto& [file, replacements] : merged.replacements) {
      const std::string& name = sources[file].name();
      const bool is_main = name == job_.job.program.name;
      if (!is_main) return refuse(Code::edit_other_file, "THE BLOCKS STAND IN " + name);
      const std::string& text = texts.at(file);
      EditedText edited{name, is_main, text, features::replaced(text, replacements)};
      if (edited.after == text) continue;
      for (const features::Replacement& each : replacements)
        report.bytes_changed += std::max<std::uint64_t>(each.length, each.text.size());
      for (TextChange& change : changes_of(name, text, replacements))
        report.changes.push_back(std::move(change));
      report.crc32 = base::crc32(edited.after);
      result_.texts.push_back(std::move(edited));
    }
    tell_regenerated();
    report.warnings = plan_.warnings;
    warn_outside_stock();
    return {};
  }

  // Of a stock that somebody has described.
  void warn_outside_stock() {
    if (!before_.knows_stock || !before_.shape || before_.recording.turns) return;
    const stock::Bounds box = stock::bounds(*before_.shape);
    for (const features::WantedLayer& wanted : plan_.wanted) {
      const features::Feature& feature = before_.tree.features[wanted.feature];
      if (features::bounds_what_stands(feature)) continue;
      const features::Vec3 zero = before_.recording.setups[feature.setup].origin - before_.origin;
      const contour::Box extents = contour::extents(wanted.contours.outer);
      const bool is_inside =
          extents.low.u + zero.x >= box.low.x && extents.high.u + zero.x <= box.high.x &&
          extents.low.v + zero.y >= box.low.y && extents.high.v + zero.y <= box.high.y;
      if (is_inside) continue;
      result_.report.warnings.push_back(
          {Code::edit_outside_stock,
           "F" + std::to_string(wanted.feature + 1) + " WOULD REACH BEYOND THE STOCK", "", 0});
      return;
    }
  }

  void tell_regenerated() {
    for (const features::WantedLayer& wanted : plan_.wanted) {
      const std::string name = "F" + std::to_string(wanted.feature + 1);
      auto& list = result_.report.regenerated;
      if (list.empty() || list.back().feature != name) list.push_back({name, {}});
      list.back().layers.push_back(wanted.layer + 1);
    }
  }

  [[nodiscard]] features::Editing<EditResult> unchanged() {
    features::VerifiedEdit& verified = result_.report.verified;
    verified.recognised = verified.others_unchanged = true;
    verified.time_before_s = verified.time_after_s = time_of(before_);
    result_.report.warnings.push_back(
        {Code::edit_no_change, "THE PROGRAM CUTS THIS ALREADY", "", 0});
    return std::move(result_);
  }

  [[nodiscard]] static double time_of(const FeaturesResult& result) {
    return result.run->machine().time_s();
  }

  [[nodiscard]] base::Outcome<features::Editing<EditResult>> verified() {
    const StockJob original = on_same_stock(job_);
    StockJob again = original;
    again.job.program = base::ProgramText::of(job_.job.program.name, result_.texts.front().after);
    auto after = recognise_features(again, features::Method::both);
    if (!after) return tl::unexpected(after.error());
    if (after->status != before_.status) return not_verified("IT ENDS OTHERWISE THAN THE ORIGINAL");
    EditReport& report = result_.report;
    report.verified = features::compare_edited(before_.recording, before_.tree, after->tree, plan_);
    report.verified.time_before_s = time_of(before_);
    report.verified.time_after_s = time_of(*after);
    report.ids = features::renamed_layers(after->tree, plan_);
    if (!report.verified.recognised)
      return not_verified("THE " + asked() + " THAT WAS ASKED FOR IS NOT FOUND IN IT");
    if (!report.verified.others_unchanged)
      return not_verified("IT ALSO CHANGES WHAT WAS NOT TO BE EDITED");
    if (!features::has_wanted_feeds(before_.recording, plan_, after->recording, after->tree))
      return not_verified("IT IS NOT FED AS ASKED");
    if (report.verified.outside_mm3 > 0.01) return not_verified("IT CUTS ELSEWHERE, TOO");
    const NewFindings added = new_findings(original, again, report.changes);
    report.verified.new_findings = added.found;
    report.verified.findings_skipped = added.skipped;
    if (!added.found.empty()) return not_verified(added.found.front());
    return features::Editing<EditResult>(std::move(result_));
  }

  // An edit never changes an assumed stock.
  [[nodiscard]] StockJob on_same_stock(StockJob job) const {
    if (!before_.knows_stock && before_.shape) job.shape = *before_.shape;
    return job;
  }

  [[nodiscard]] std::string asked() const {
    return plan_.wanted.empty() && plan_.turned.empty() ? "HOLE" : "CONTOUR";
  }

  [[nodiscard]] static features::Editing<EditResult> not_verified(std::string why) {
    return refuse(Code::edit_not_verified, std::move(why));
  }

  const StockJob& job_;
  const EditWishes& wishes_;
  FeaturesResult& before_;
  features::EditPlan plan_{};
  EditResult result_{};
};

}  // namespace

base::Outcome<EditRun> edit_features(const StockJob& job, const EditWishes& wishes) {
  auto before = recognise_features(job, features::Method::both);
  if (!before) return tl::unexpected(before.error());
  EditRun run;
  run.status = before->status;
  if (before->status != machine::RunStatus::alarm && before->status != machine::RunStatus::budget) {
    EditWork work(job, wishes, *before);
    auto edited = work.make();
    if (!edited) return tl::unexpected(edited.error());
    run.edited = std::move(*edited);
  }
  run.run = std::move(before->run);
  return run;
}

}  // namespace kerf::job
