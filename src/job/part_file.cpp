#include "job/part_file.hpp"

#include <array>
#include <string_view>
#include <vector>

#include "job/facts_of_run.hpp"
#include "job/internal/stock_models.hpp"
#include "stock/turned/turned_part.hpp"
#include "stock/turnmill/turn_mill_part.hpp"

namespace kerf::job {
namespace {

using base::Outcome;
using stock::saved::PartLabel;
using stock::saved::ReadPart;
using stock::saved::SheetCut;

constexpr std::size_t kHead = 8;
constexpr std::uint64_t kLargestPipe = std::uint64_t{4} << 30U;

PartLabel label_of(const StockJob& job, const StockResult& result,
                   const output::StockFacts& facts) {
  PartLabel label{.zero = name_of(result.zero),
                  .volume_mm3 = facts.left_mm3,
                  .made_by = job.made_by,
                  .threads = job.threads};
  label.made_by.push_back(title_of(result.run->machine()));
  const auto* part = dynamic_cast<const stock::turned::TurnedPart*>(result.model.get());
  if (const auto* const milled =
          dynamic_cast<const stock::turnmill::TurnMillPart*>(result.model.get()))
    part = &milled->profile();
  if (part == nullptr) return label;
  for (const stock::turned::TurnedThread& thread : part->threads()) label.threads.push_back(thread);
  return label;
}

/// The cuts of the sheet that this run began with, and its own.
std::vector<SheetCut> cuts_of(const StockResult& result) {
  std::vector<SheetCut> cuts;
  if (const auto* const saved = std::get_if<stock::SavedShape>(&result.shape)) {
    if (const auto* const sheet = dynamic_cast<const stock::saved::SavedSheet*>(saved->part.get()))
      cuts = sheet->state().cuts;
  }
  for (const stock::sheet::Trace& way : result.ways)
    cuts.push_back({way, result.sheet_facts->kerf_mm});
  return cuts;
}

}  // namespace

bool is_part(const base::SourceFile& file) {
  std::array<char, kHead> head{};
  const std::size_t count = file.read(0, head);
  return stock::saved::is_saved_part(std::string_view(head.data(), count));
}

Outcome<ReadPart> part_in(const base::SourceFile& file, std::size_t most_bytes) {
  std::uint64_t at = 0;
  const auto give = [&](std::span<char> into) {
    const std::size_t count = file.read(at, into);
    at += count;
    return count;
  };
  auto read = stock::saved::read_part(give, most_bytes);
  if (!read) {
    base::Failure failure = read.error();
    failure.message = file.name() + ": " + failure.message;
    return tl::unexpected(std::move(failure));
  }
  return read;
}

Outcome<ReadPart> read_part(const std::string& path, std::size_t most_bytes) {
  const auto file = base::SourceFile::open(path, {.most_bytes = kLargestPipe, .seconds = 60});
  if (!file) return tl::unexpected(file.error());
  return part_in(**file, most_bytes);
}

Outcome<void> save_part(const StockJob& job, const StockResult& result,
                        const output::StockFacts& facts, base::OutputFile& into) {
  if (!(facts.left_mm3 > 0))
    return tl::unexpected(
        base::Failure{base::Failure::Kind::output, into.path() + ": nothing is left of the part"});
  const auto take = [&](std::string_view bytes) { into.write(bytes); };
  const PartLabel label = label_of(job, result, facts);
  if (result.model) {
    const stock::Model* const dexels = dexels_of(*result.model);
    stock::saved::write_part(label, dexels != nullptr ? *dexels : *result.model, take);
    return {};
  }
  const std::vector<SheetCut> cuts = cuts_of(result);
  const stock::Bounds box = stock::bounds(result.shape);
  stock::saved::write_part(label, {*result.sheet, cuts, box.high.z - box.low.z}, take);
  return {};
}

}  // namespace kerf::job
