#include "output/reports/time_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/decimal.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::output {
namespace {

using motion::Mark;

constexpr std::size_t kMostLines = 100'000;
constexpr std::size_t kDearest = 10;
constexpr std::array kMoveKinds = {motion::MoveKind::rapid, motion::MoveKind::cut,
                                   motion::MoveKind::dwell};

const char* kind_name(motion::MoveKind kind) {
  switch (kind) {
    case motion::MoveKind::rapid: return "rapid";
    case motion::MoveKind::cut: return "cut";
    case motion::MoveKind::dwell: return "dwell";
  }
  return "";
}

std::string file_of(const Mark& mark, const base::SourceSet& sources) {
  return sources.contains(mark.block.file) ? printable(sources[mark.block.file].name())
                                           : std::string("-");
}

std::string programmed_text(const std::array<float, 2>& speeds) {
  if (!(speeds[1] > 0)) return "-";
  return speeds[0] == speeds[1] ? fmt::format("{:.2f}", speeds[1])
                                : fmt::format("{:.2f}-{:.2f}", speeds[0], speeds[1]);
}

nlohmann::ordered_json programmed_json(const std::array<float, 2>& speeds) {
  if (!(speeds[1] > 0)) return nullptr;
  const auto per_minute = [](float speed) { return base::tidy(static_cast<double>(speed) * 60); };
  return {per_minute(speeds[0]), per_minute(speeds[1])};
}

}  // namespace

TimeReport::TimeReport(const motion::AxisSetup& axes, double period_s)
    : axes_(axes), period_s_(period_s) {}

std::uint64_t TimeReport::key_of(const Mark& mark) {
  return static_cast<std::uint64_t>(mark.block.file) << 34 |
         static_cast<std::uint64_t>(mark.kind) << 32 | mark.block.line;
}

double TimeReport::seconds(std::uint64_t periods) const {
  return static_cast<double>(periods) * period_s_;
}

void TimeReport::line_begins(base::FileId file, std::uint32_t line) {
  runs_.count(file, line);
  if (runs_.size() > 4 * kMostLines)
    runs_.forget([this](base::FileId of, std::uint32_t number) { return !moves(of, number); });
}

bool TimeReport::moves(base::FileId file, std::uint32_t line) const {
  return std::any_of(kMoveKinds.begin(), kMoveKinds.end(), [&](motion::MoveKind kind) {
    return lines_.contains(key_of({.block = {.file = file, .line = line}, .kind = kind}));
  });
}

void TimeReport::take(const motion::AxisPoint& point) {
  const Mark& mark = point.tip.mark;
  if (current_.periods == 0 || key_of(mark) != key_of(current_.mark)) {
    book();
    current_ = {mark, 0, 0, {mark.speed, mark.speed}};
  }
  double square = 0;
  for (std::size_t m = 0; m < axes_.count(); ++m) {
    const double d = point.tip.tip.values[m] - at_.values[m];
    if (!axes_.axes[m].rotary) square += d * d;
  }
  current_.length_mm += std::sqrt(square);
  current_.programmed = {std::min(current_.programmed[0], mark.speed),
                         std::max(current_.programmed[1], mark.speed)};
  ++current_.periods;
  ++tools_[mark.tool][static_cast<std::size_t>(mark.kind)];
  at_ = point.tip.tip;
}

void TimeReport::book() {
  if (current_.periods == 0) return;
  Account& account =
      lines_.try_emplace(key_of(current_.mark), Account{current_.mark, 0, 0, current_.programmed})
          .first->second;
  account.periods += current_.periods;
  account.length_mm += current_.length_mm;
  account.programmed = {std::min(account.programmed[0], current_.programmed[0]),
                        std::max(account.programmed[1], current_.programmed[1])};
  current_.periods = 0;
  if (lines_.size() > kMostLines) forget_the_cheap();
}

void TimeReport::forget_the_cheap() {
  std::vector<std::uint64_t> periods;
  for (const auto& [key, account] : lines_) periods.push_back(account.periods);
  const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
  std::nth_element(periods.begin(), middle, periods.end());
  const std::uint64_t limit = *middle;
  std::erase_if(lines_, [&](const auto& item) { return item.second.periods <= limit; });
  has_forgotten_ = true;
}

std::vector<TimeReport::Account> TimeReport::dearest() {
  book();
  std::vector<Account> list;
  for (const auto& [key, account] : lines_) list.push_back(account);
  std::sort(list.begin(), list.end(), [](const Account& a, const Account& b) {
    return a.periods != b.periods ? a.periods > b.periods : key_of(a.mark) < key_of(b.mark);
  });
  list.resize(std::min(list.size(), kDearest));
  return list;
}

std::vector<TimeReport::ToolTime> TimeReport::tool_times() const {
  std::vector<ToolTime> times;
  for (const auto& [tool, kinds] : tools_)
    times.push_back({tool, seconds(kinds[0]), seconds(kinds[1]), seconds(kinds[2])});
  return times;
}

TimeReport::Kinds TimeReport::totals() const {
  Kinds totals{};
  for (const auto& [tool, kinds] : tools_) {
    for (std::size_t k = 0; k < kKinds; ++k) totals[k] += seconds(kinds[k]);
  }
  return totals;
}

std::string TimeReport::text(const RunFacts& run, const base::SourceSet& sources) {
  const double total = run.time_s;
  const std::string ratio =
      total > 0 ? fmt::format(" (x {:.2f})", run.feed_s / total) : std::string();
  std::string text = fmt::format("{} on {}: {:.3f} s, without acceleration {:.3f} s{}\n\n",
                                 printable(run.title), run.machine, total, run.feed_s, ratio);
  const Kinds sums = totals();
  text += fmt::format("{:>8} {:>12} {:>12} {:>12} {:>12}\n", "tool", "time s", "rapid s", "cut s",
                      "dwell s");
  const auto row = [&](const std::string& name, const Kinds& kinds) {
    text += fmt::format("{:>8} {:>12.3f} {:>12.3f} {:>12.3f} {:>12.3f}\n", name,
                        kinds[0] + kinds[1] + kinds[2], kinds[0], kinds[1], kinds[2]);
  };
  for (const auto& [tool, kinds] : tools_)
    row("T" + std::to_string(tool), {seconds(kinds[0]), seconds(kinds[1]), seconds(kinds[2])});
  row("all", sums);
  text += "\nthe lines that cost most\n";
  text += fmt::format("{:>12} {:>7} {:>7}  {:<5} {:>12} {:>15}  {}\n", "time s", "share", "runs",
                      "kind", "reached mm/s", "programmed mm/s", "where");
  for (const Account& account : dearest()) {
    const double time_s = seconds(account.periods);
    text += fmt::format(
        "{:>12.3f} {:>6.1f}% {:>7}  {:<5} {:>12} {:>15}  {}:{}\n", time_s,
        total > 0 ? 100 * time_s / total : 0,
        runs_.of(account.mark.block.file, account.mark.block.line), kind_name(account.mark.kind),
        account.length_mm > 0 ? fmt::format("{:.2f}", account.length_mm / time_s) : "-",
        programmed_text(account.programmed), file_of(account.mark, sources),
        account.mark.block.line);
  }
  if (has_forgotten_) text += "of very many lines those that cost least were not kept\n";
  return text;
}

std::string TimeReport::json(const RunFacts& run, const base::SourceSet& sources) {
  using Json = nlohmann::ordered_json;
  const Kinds sums = totals();
  Json object{{"time_s", base::tidy(run.time_s)},
              {"time_feed_s", base::tidy(run.feed_s)},
              {"rapid_s", base::tidy(sums[0])},
              {"cut_s", base::tidy(sums[1])},
              {"dwell_s", base::tidy(sums[2])}};
  object["tools"] = Json::array();
  for (const auto& [tool, kinds] : tools_) {
    object["tools"].push_back({{"tool", tool},
                               {"rapid_s", base::tidy(seconds(kinds[0]))},
                               {"cut_s", base::tidy(seconds(kinds[1]))},
                               {"dwell_s", base::tidy(seconds(kinds[2]))}});
  }
  object["places"] = Json::array();
  for (const Account& account : dearest()) {
    object["places"].push_back(
        {{"file", file_of(account.mark, sources)},
         {"line", account.mark.block.line},
         {"kind", kind_name(account.mark.kind)},
         {"time_s", base::tidy(seconds(account.periods))},
         {"runs", runs_.of(account.mark.block.file, account.mark.block.line)},
         {"length_mm", base::tidy(account.length_mm)},
         {"programmed_mm_min", programmed_json(account.programmed)}});
  }
  return object.dump() + "\n";
}

}  // namespace kerf::output
