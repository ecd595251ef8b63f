#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "process/material.hpp"
#include "process/recipe.hpp"

namespace kerf::process {

/// What a key of a job file takes.
struct Takes {
  enum class Form : std::uint8_t {
    number,
    whole_number,
    flag,
    word,
    text,
    texts,
    pair,            ///< [x, y]
    triple,          ///< [x, y, z]
    pairs,           ///< [[x, y], …]
    number_or_pair,  ///< of numbers in the range
    number_or_word,
    word_or_pair,
    table  ///< of its own keys
  };

  Form form = Form::number;
  double low = 0;
  double high = 0;
  bool low_itself = true;    ///< else above it
  std::string_view words{};  ///< parted by |
};

[[nodiscard]] std::vector<std::string_view> words_of(const Takes& takes);
/// For a sentence: "a number from 0 to 100", "round or sharp", "[x, y]".
[[nodiscard]] std::string in_words(const Takes& takes);

/// What somebody has said, of the form that a key takes. Of a word `number` is its place among
/// them.
struct KeyValue {
  double number = 0;
  std::string text{};
  std::vector<double> numbers{};
  std::vector<std::string> texts{};
  bool is_word = false;
};

/// Where a key is written: `place` in [place], `lead` in lead_in and lead_out of an operation.
enum class KeyTable : std::uint8_t {
  job,
  place,
  array,
  text,
  serial,
  line,
  image,
  wrap,
  lens,
  operation,
  lead,
  tabs,
  weave,
  material,
  preset
};
/// For a sentence: "[place]", "[[operation]]".
[[nodiscard]] std::string_view title_of(KeyTable table);

/// What a key is a part of.
using KeyOwner =
    std::variant<std::nullptr_t, Recipe*, PlaceWords*, Array*, TextWords*, TextLine*, ImageWords*,
                 Wrap*, Operation*, Lead*, Tabs*, Weave*, Material*, Preset*>;

/// Processes, a bit each.
using Processes = std::uint32_t;
[[nodiscard]] constexpr Processes only(Process process) {
  return 1U << static_cast<unsigned>(process);
}

/// A row of keys.def.
struct JobKey {
  KeyTable table;
  std::string_view name;
  Takes takes;
  std::string_view unit;
  std::string_view otherwise;  ///< what it is where it is not said; empty: nothing
  Processes processes;         ///< that take it
  std::string_view about;      ///< a sentence
  /// Precondition: the owner is of the key's table, the value of its form.
  void (*assign)(const KeyOwner& owner, const KeyValue& value);
  /// The owner of the keys of a table; nullptr of all other forms.
  KeyOwner (*inside)(const KeyOwner& owner);
};

/// Gives a key what somebody has said.
void say(const JobKey& key, const KeyOwner& owner, const KeyValue& value);

[[nodiscard]] std::span<const JobKey> job_keys();
/// Null if there is none of that name.
[[nodiscard]] const JobKey* find_key(KeyTable table, std::string_view name);
/// The table of the keys of `key`, which takes one.
[[nodiscard]] KeyTable table_inside(const JobKey& key);

[[nodiscard]] std::string_view name_of(Process process);
/// "cut", "fill, raster or heat"
[[nodiscard]] std::string names_of(Processes processes);

}  // namespace kerf::process
