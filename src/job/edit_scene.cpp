#include "job/edit_scene.hpp"

#include <algorithm>

#include "base/checksum.hpp"
#include "base/decimal.hpp"
#include "features/merge/assignments.hpp"
#include "features/merge/text_style.hpp"
#include "features/merge/tool_words.hpp"
#include "features/plan/edit_planner.hpp"
#include "features/rewrite/regenerate.hpp"
#include "job/changed_library.hpp"
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

const base::Language* language_of(const machine::BatchRun& run) {
  const machine::DialectRow* const dialect = machine::find_dialect(run.definition().dialect);
  const bool is_gcode = dialect != nullptr && dialect->kind == machine::DialectRow::Kind::gcode;
  return is_gcode ? dialect->language : nullptr;
}

/// The number behind a letter, blanks and zeros left out; 0: there is none.
std::uint32_t number_behind(std::string_view text, std::size_t at) {
  std::uint32_t number = 0;
  for (at = text.find_first_not_of("0 ", at); at < text.size(); ++at) {
    if (text[at] < '0' || text[at] > '9' || number > 100'000'000) break;
    number = 10 * number + static_cast<std::uint32_t>(text[at] - '0');
  }
  return number;
}

/// The N words that jumps and calls of a text may name, ascending: GOTO10, P10, Q10. Rather one too
/// many.
std::vector<std::uint32_t> named_blocks(std::string_view text) {
  constexpr const char* kLetters = "PQOpqo";
  std::vector<std::uint32_t> names;
  for (std::size_t at = text.find_first_of(kLetters); at != std::string_view::npos;
       at = text.find_first_of(kLetters, at + 1))
    names.push_back(number_behind(text, at + 1));
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

double time_of(const FeaturesResult& result) { return result.run->machine().time_s(); }

// An edit never changes an assumed stock.
StockJob on_same_stock(StockJob job, const FeaturesResult& before) {
  if (!before.knows_stock && before.shape) job.shape = *before.shape;
  return job;
}

std::string asked_by(const features::EditPlan& plan) {
  return plan.wanted.empty() && plan.turned.empty() ? "HOLE" : "CONTOUR";
}

/// Makes a draft of edits.
class Drafting {
 public:
  Drafting(const EditScene& scene, features::OldWays& ways, const features::MergeSources& sources,
           const EditWishes& wishes)
      : job_(scene.job()),
        before_(scene.features()),
        ways_(ways),
        sources_(sources),
        wishes_(wishes) {}

  [[nodiscard]] features::Editing<EditDraft> make() {
    auto plan = features::plan_edits(before_.recording, before_.tree, ways_, wishes_.edits,
                                     {wishes_.allows_collision, wishes_.allows_rest});
    if (!plan) return tl::unexpected(plan.error());
    plan_ = std::move(*plan);
    const features::Recording& rows = plan_.programmed ? *plan_.programmed : before_.recording;
    auto merged = features::merge(rows, plan_.rows, sources_);
    if (!merged) return refuse(merged.error().code, merged.error().sentence);
    for (const features::ToolChange& tool : plan_.tools) {
      auto done = features::change_tool_words(before_.recording, {tool.was, tool.is, tool.rows},
                                              sources_, *merged);
      if (!done) return refuse(done.error().code, done.error().sentence);
    }
    for (const std::size_t edit : plan_.arguments) {
      if (auto done = change_argument(edit, *merged); !done) return tl::unexpected(done.error());
    }
    if (auto put = put_texts(*merged); !put) return tl::unexpected(put.error());
    return EditDraft{std::move(plan_), std::move(result_)};
  }

 private:
  using Done = features::Editing<void>;

  // The literal of a call, in its place.
  [[nodiscard]] Done change_argument(std::size_t edit, features::Merged& merged) {
    const features::Edit& wish = wishes_.edits[edit];
    const auto& argument = std::get<features::SetArgument>(wish.operation);
    if (wish.target.empty()) return change_variable(edit, merged);
    for (std::size_t i = 0; i < before_.tree.calls.size(); ++i) {
      const features::Call& call = before_.tree.calls[i];
      if (wish.target != "C" + std::to_string(i + 1)) continue;
      for (const features::Argument& its : call.words.arguments) {
        const bool is_it = argument.letter.empty() ? its.variable == argument.variable
                                                   : its.letter == argument.letter;
        if (!is_it) continue;
        if (!its.literal)
          return refuse(Code::edit_expression, its.letter + its.text + " IS AN EXPRESSION", edit);
        const auto& [file, text] = *sources_.texts.begin();
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
  [[nodiscard]] Done change_variable(std::size_t edit, features::Merged& merged) {
    const std::map<base::FileId, std::string>& texts = sources_.texts;
    const auto& argument = std::get<features::SetArgument>(wishes_.edits[edit].operation);
    const std::string name = "#" + std::to_string(argument.variable);
    const auto main = std::find_if(texts.begin(), texts.end(), [&](const auto& text) {
      return before_.run->machine().sources()[text.first].name() == job_.job.program.name;
    });
    if (main == texts.end()) return refuse(Code::edit_call_unknown, "NO BLOCK SETS " + name, edit);
    const std::vector<features::Assignment> all =
        features::assignments_of(sources_.language, main->second, argument.variable);
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

  [[nodiscard]] Done put_texts(const features::Merged& merged) {
    EditReport& report = result_.report;
    report.edits = wishes_.edits.size();
    report.blocks = {merged.kept, merged.patched, merged.inserted, merged.removed};
    const base::SourceSet& sources = before_.run->machine().sources();
    for (const auto& [file, text] : sources_.texts) {
      if (sources[file].name() == job_.job.program.name) report.crc32 = base::crc32(text);
    }
    for (const auto& [file, replacements] : merged.replacements) {
      const std::string& name = sources[file].name();
      const bool is_main = name == job_.job.program.name;
      if (!is_main && !wishes_.allows_other_files) return other_file(name);
      const std::string& text = sources_.texts.at(file);
      EditedText edited{name, is_main, text, features::replaced(text, replacements)};
      if (edited.after == text) continue;
      for (const features::Replacement& each : replacements)
        report.bytes_changed += std::max<std::uint64_t>(each.length, each.text.size());
      for (TextChange& change : changes_of(name, text, replacements))
        report.changes.push_back(std::move(change));
      if (is_main) report.crc32 = base::crc32(edited.after);
      result_.texts.push_back(std::move(edited));
    }
    tell_regenerated();
    report.warnings = plan_.warnings;
    warn_outside_stock();
    return {};
  }

  [[nodiscard]] static tl::unexpected<EditFault> other_file(const std::string& name) {
    return tl::unexpected(EditFault{
        Code::edit_other_file, "THE BLOCKS STAND IN " + name,
        "--output-library names a folder for changed files; `\"scope\":\"this\"` writes the call "
        "out in the program",
        0});
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

  const StockJob& job_;
  const FeaturesResult& before_;
  features::OldWays& ways_;
  const features::MergeSources& sources_;
  const EditWishes& wishes_;
  features::EditPlan plan_{};
  EditResult result_{};
};

}  // namespace

EditScene::EditScene(StockJob job, FeaturesResult before)
    : job_(std::move(job)), before_(std::move(before)) {
  const machine::BatchRun& run = before_.run->machine();
  const base::Language* const language = language_of(run);
  if (language == nullptr) return;
  blocks_ = std::make_unique<BlockTexts>(run.sources(), run.control(), language,
                                         BlockTexts::Shapes::none);
  sources_.emplace(features::MergeSources{.language = *language});
  sources_->pointless = run.definition().parameters.calculator_point ? 0 : 0.001;
  sources_->x_counts = before_.recording.turns ? 2 : 1;
  read_texts();
  sources_->sets_up = [this](const base::BlockId& block) { return blocks_->sets_up(block); };
  sources_->is_named = [this](const base::BlockId& block) {
    const std::vector<std::uint32_t>& names = named_[block.file];
    return block.sequence > 0 && std::binary_search(names.begin(), names.end(), block.sequence);
  };
}

EditScene::~EditScene() = default;

void EditScene::read_texts() {
  const base::SourceSet& files = before_.run->machine().sources();
  const features::Recording& recording = before_.recording;
  for (std::size_t i = 0; i < recording.blocks.size(); ++i) {
    const base::FileId file = recording.blocks[i].file;
    if (!files.contains(file) || sources_->texts.count(file) > 0) continue;
    const std::string& text = sources_->texts.emplace(file, text_of(files[file])).first->second;
    named_[file] = named_blocks(text);
  }
  for (const features::Call& call : before_.tree.calls) {
    const base::FileId file = call.block.file;
    if (!files.contains(file) || sources_->texts.count(file) > 0) continue;
    const std::string& text = sources_->texts.emplace(file, text_of(files[file])).first->second;
    named_[file] = named_blocks(text);
  }
}

features::EditSketch EditScene::sketch(const std::vector<features::Edit>& edits) const {
  return features::sketch_edits(before_.recording, before_.tree, edits);
}

// Tools that edits name may not have moved so far.
void EditScene::describe_tools(const std::vector<features::Edit>& edits) {
  RunRack rack(job_, before_.run->machine(), {});
  for (const features::Edit& edit : edits) {
    const auto* const wish = std::get_if<features::SetTool>(&edit.operation);
    if (wish == nullptr) continue;
    const stock::Tool& tool = rack.tool(wish->tool).tool;
    if (tool.source != stock::ToolSource::assumed)
      before_.recording.tools.emplace(wish->tool, tool);
  }
}

features::Editing<EditDraft> EditScene::draft(const EditWishes& wishes) {
  if (!sources_) return refuse(Code::edit_not_editable, "ONLY PROGRAMS IN G-CODE ARE EDITED");
  describe_tools(wishes.edits);
  return Drafting(*this, ways_, *sources_, wishes).make();
}

base::Outcome<features::Editing<EditResult>> EditScene::verified(EditDraft draft,
                                                                 std::stop_token unwanted) const {
  using Verified = features::Editing<EditResult>;
  EditReport& report = draft.result.report;
  if (draft.result.texts.empty()) {
    report.verified = {.recognised = true, .others_unchanged = true};
    report.verified.time_before_s = report.verified.time_after_s = time_of(before_);
    report.warnings.push_back({Code::edit_no_change, "THE PROGRAM CUTS THIS ALREADY", "", 0});
    return Verified(std::move(draft.result));
  }
  const auto not_verified = [](std::string why) {
    return Verified(refuse(Code::edit_not_verified, std::move(why)));
  };
  StockJob original = on_same_stock(job_, before_);
  if (unwanted.stop_possible()) original.job.budget.unwanted = std::move(unwanted);
  StockJob again = original;
  auto library = ChangedLibrary::of(draft.result.texts);
  if (!library) return tl::unexpected(library.error());
  library->change(again.job);
  auto after = recognise_features(again, features::Method::both);
  if (!after) return tl::unexpected(after.error());
  if (after->status != before_.status) return not_verified("IT ENDS OTHERWISE THAN THE ORIGINAL");
  report.verified =
      features::compare_edited(before_.recording, before_.tree, after->tree, draft.plan);
  report.verified.time_before_s = time_of(before_);
  report.verified.time_after_s = time_of(*after);
  report.ids = features::renamed_layers(after->tree, draft.plan);
  if (!report.verified.recognised)
    return not_verified("THE " + asked_by(draft.plan) + " THAT WAS ASKED FOR IS NOT FOUND IN IT");
  if (!report.verified.others_unchanged)
    return not_verified("IT ALSO CHANGES WHAT WAS NOT TO BE EDITED");
  if (!features::has_wanted_feeds(before_.recording, draft.plan, after->recording, after->tree))
    return not_verified("IT IS NOT FED AS ASKED");
  if (report.verified.outside_mm3 > 0.01) return not_verified("IT CUTS ELSEWHERE, TOO");
  const NewFindings added = new_findings(original, again, report.changes);
  report.verified.new_findings = added.found;
  report.verified.findings_skipped = added.skipped;
  if (!added.found.empty()) return not_verified(added.found.front());
  return Verified(std::move(draft.result));
}

}  // namespace kerf::job
