#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/language.hpp"
#include "base/source_file.hpp"
#include "control/core/control.hpp"
#include "features/merge/file_marks.hpp"
#include "features/path/block_facts.hpp"

namespace kerf::job {

/// The texts of the blocks of a run that is over. Files without variables, brackets and slashes are
/// looked through once, and their blocks are not read. Of a language that is no G-code nothing is
/// known but the calls.
class BlockTexts final : public features::BlockReader {
 public:
  /// Whether blocks may have cycles of shapes, G70 to G73.
  enum class Shapes : std::uint8_t { none, some };

  /// All must outlive this. `language`: null of what is no G-code.
  BlockTexts(const base::SourceSet& sources, const control::Control& control,
             const base::Language* language, Shapes shapes)
      : sources_(sources), control_(control), language_(language), shapes_(shapes) {}

  [[nodiscard]] features::BlockFacts facts(const base::BlockId& block) override;
  [[nodiscard]] bool sets_up(const base::BlockId& block) override;
  [[nodiscard]] std::vector<base::BlockId> calls(const base::BlockId& block) override;
  [[nodiscard]] features::CallWords call_of(const base::BlockId& block) override;
  [[nodiscard]] std::optional<features::LineSpan> loop_round(base::FileId file,
                                                             features::LineSpan lines) override;

 private:
  struct File {
    bool has_marks = false;  // something of it is a variable, an expression, or left out
    std::optional<features::FileMarks> marks{};
  };

  [[nodiscard]] File& file(base::FileId id);
  [[nodiscard]] const features::FileMarks& marks(base::FileId id);
  [[nodiscard]] std::string text_of(const base::BlockId& block) const;

  const base::SourceSet& sources_;
  const control::Control& control_;
  const base::Language* language_;
  Shapes shapes_;
  std::map<base::FileId, File> files_;
  base::BlockId last_;  // whose facts were asked for
  features::BlockFacts facts_;
};

}  // namespace kerf::job
