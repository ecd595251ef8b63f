#pragma once

#include <array>
#include <optional>
#include <utility>

#include "base/diagnostic.hpp"
#include "drive/pattern/listing_reader.hpp"
#include "drive/pattern/reader.hpp"
#include "face/cli/pattern_files.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::cli {

/// Goes through the file of a pattern command record by record, be it bytes or a listing, which is
/// told by its beginning; whoever reads lenient axis bits has bytes. Bounded memory.
class PatternPlay {
 public:
  /// Both must outlive this.
  PatternPlay(const base::SourceSet& sources, const machine::MachineDefinition& machine,
              const drive::PatternFormat& format)
      : sources_(sources), machine_(machine), format_(format) {}

  /// Until the end, or until player.spent(). It takes records by player.take(), also of linked
  /// motors, as base::Result<void>. Error: what is wrong with the file, or the player's own.
  template <typename Player>
  base::Result<void> run(Player& player) {
    return is_listing() ? run_listing(player) : run_bytes(player);
  }

  /// The diagnostic is of the record under way: by its byte or, in a listing, its line.
  void stand_here(base::Diagnostic& diagnostic) const {
    diagnostic.place = place_;
    diagnostic.offset = offset_;
  }
  /// Records have places by their bytes.
  [[nodiscard]] bool has_bytes() const { return offset_.has_value(); }

 private:
  [[nodiscard]] bool is_listing() const {
    std::array<char, 2> head{};
    const std::size_t size = sources_[kPatternFile].read(0, head);
    return format_.axis_bits == drive::AxisBits::strict &&
           drive::begins_listing({head.data(), size});
  }

  template <typename Player>
  base::Result<void> run_bytes(Player& player) {
    drive::PatternReader reader(sources_[kPatternFile], kPatternFile, format_);
    for (;;) {
      auto record = reader.next();
      offset_ = reader.offset();
      if (!record) return base::unexpected(std::move(record.error()));
      if (!*record || player.spent()) return {};
      if (auto made = player.take(**record); !made) return made;
    }
  }

  template <typename Player>
  base::Result<void> run_listing(Player& player) {
    const bool linked = machine_.pattern.link == machine::PatternSettings::Link::four;
    drive::ListingReader reader(sources_[kPatternFile], kPatternFile,
                                linked ? drive::Links::four : drive::Links::none);
    for (;;) {
      auto move = reader.next();
      place_ = reader.place();
      if (!move) return base::unexpected(std::move(move.error()));
      if (!*move || player.spent()) return {};
      if (auto made = run_line(**move, player); !made) return made;
    }
  }

  // A line may be many records.
  template <typename Player>
  static base::Result<void> run_line(const drive::ListedMove& move, Player& player) {
    if (const auto* const linked = std::get_if<drive::ListedLinked>(&move))
      return player.take(*linked);
    base::Result<void> made;
    drive::each_record(move, [&](const drive::PatternRecord& record) {
      if (made && !player.spent()) made = player.take(record);
    });
    return made;
  }

  const base::SourceSet& sources_;
  const machine::MachineDefinition& machine_;
  drive::PatternFormat format_;
  std::optional<std::uint64_t> offset_;
  base::Place place_{.file = kPatternFile};
};

}  // namespace kerf::cli
