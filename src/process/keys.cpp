#include "process/keys.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "base/decimal.hpp"

namespace kerf::process {

// Its names are short, and other sources of the room may have the same ones.
namespace key_rows {
namespace {

using Form = Takes::Form;

constexpr double kFarthest_mm = 1e6;

constexpr Takes numbers(double low, double high) { return {Form::number, low, high}; }
constexpr Takes any_number() { return numbers(-kFarthest_mm, kFarthest_mm); }
constexpr Takes not_negative() { return numbers(0, kFarthest_mm); }
constexpr Takes positive() { return {Form::number, 0, kFarthest_mm, false}; }
constexpr Takes whole_numbers(double low, double high) { return {Form::whole_number, low, high}; }
constexpr Takes flag() { return {Form::flag}; }
constexpr Takes one_of(std::string_view words) { return {Form::word, 0, 0, true, words}; }
constexpr Takes text() { return {Form::text}; }
constexpr Takes texts() { return {Form::texts}; }
constexpr Takes pair() { return {Form::pair, -kFarthest_mm, kFarthest_mm}; }
constexpr Takes size_pair() { return {Form::pair, 0, kFarthest_mm, false}; }
constexpr Takes triple() { return {Form::triple, -kFarthest_mm, kFarthest_mm}; }
constexpr Takes pairs() { return {Form::pairs, -kFarthest_mm, kFarthest_mm}; }
constexpr Takes number_or_pair(double low, double high) {
  return {Form::number_or_pair, low, high};
}
constexpr Takes number_or_word(double low, double high, std::string_view words) {
  return {Form::number_or_word, low, high, true, words};
}
constexpr Takes word_or_pair(std::string_view words) {
  return {Form::word_or_pair, -kFarthest_mm, kFarthest_mm, true, words};
}
constexpr Takes table() { return {Form::table}; }

constexpr Processes every = ~0U;
template <typename... P>
constexpr Processes of(P... processes) {
  return (only(processes) | ...);
}

// What a value becomes in the member that it is for.
void put(double& member, const KeyValue& value) { member = value.number; }
void put(bool& member, const KeyValue& value) { member = value.number != 0; }
void put(std::uint32_t& member, const KeyValue& value) {
  member = static_cast<std::uint32_t>(value.number);
}
void put(std::string& member, const KeyValue& value) { member = value.text; }
void put(char& member, const KeyValue& value) { member = value.text.front(); }
void put(Vec2& member, const KeyValue& value) { member = {value.numbers[0], value.numbers[1]}; }
void put(std::vector<std::string>& member, const KeyValue& value) { member = value.texts; }
void put(std::array<double, 2>& member, const KeyValue& value) {
  member = value.numbers.empty() ? std::array{value.number, value.number}
                                 : std::array{value.numbers[0], value.numbers[1]};
}
void put(std::array<double, 3>& member, const KeyValue& value) {
  member = {value.numbers[0], value.numbers[1], value.numbers[2]};
}
void put(std::vector<std::pair<double, double>>& member, const KeyValue& value) {
  member.clear();
  for (std::size_t i = 0; i + 1 < value.numbers.size(); i += 2)
    member.emplace_back(value.numbers[i], value.numbers[i + 1]);
}
void put(End& member, const KeyValue& value) {
  member = value.is_word ? End{static_cast<EndKind>(value.number), {}}
                         : End{EndKind::point, {value.numbers[0], value.numbers[1]}};
}
template <typename T>
requires std::is_enum_v<T>
void put(T& member, const KeyValue& value) { member = static_cast<T>(value.number); }
template <typename T>
void put(std::optional<T>& member, const KeyValue& value) {
  member.reset();
  // The one word beside numbers says that there is none.
  if (!value.is_word || std::is_enum_v<T>) put(member.emplace(), value);
}

template <typename Member, typename Owner>
Owner owner_type(Member Owner::*);
template <typename Owner, typename Member>
Member member_type(Member Owner::*);

template <typename T>
constexpr bool kIsTable =
    std::is_same_v<T, Lead> || std::is_same_v<T, Tabs> || std::is_same_v<T, Weave>;

template <auto kMember>
using OwnerOf = decltype(owner_type(kMember));
template <auto kMember>
using MemberOf = std::remove_reference_t<decltype(std::declval<OwnerOf<kMember>&>().*kMember)>;

template <auto kMember>
void assign(const KeyOwner& owner, const KeyValue& value) {
  if constexpr (!kIsTable<MemberOf<kMember>>)
    put(std::get<OwnerOf<kMember>*>(owner)->*kMember, value);
}

template <auto kMember>
KeyOwner inside(const KeyOwner& owner) {
  if constexpr (kIsTable<MemberOf<kMember>>) {
    return &(std::get<OwnerOf<kMember>*>(owner)->*kMember);
  } else {
    return nullptr;
  }
}

/// The types whose members the keys of a table are.
struct Owners {
  using job = Recipe;
  using place = PlaceWords;
  using array = Array;
  using text = TextWords;
  using serial = TextWords;
  using line = TextLine;
  using image = ImageWords;
  using wrap = Wrap;
  using lens = Recipe;
  using operation = Operation;
  using lead = Lead;
  using tabs = Tabs;
  using weave = Weave;
  using material = Material;
  using preset = Preset;
};

constexpr Process engrave = Process::engrave;
constexpr Process mark = Process::mark;
constexpr Process cut = Process::cut;
constexpr Process fill = Process::fill;
constexpr Process raster = Process::raster;
constexpr Process weld = Process::weld;
constexpr Process heat = Process::heat;
constexpr Process drill = Process::drill;

constexpr JobKey kKeys[] = {
#define KEY(table, name, takes, unit, otherwise, processes, member, about) \
  {KeyTable::table,                                                        \
   name,                                                                   \
   takes,                                                                  \
   unit,                                                                   \
   otherwise,                                                              \
   processes,                                                              \
   about,                                                                  \
   assign<&Owners::table::member>,                                         \
   inside<&Owners::table::member>},
#include "process/keys.def"
#undef KEY
};

constexpr std::string_view kTitles[] = {
    "[job]",         "[place]", "[array]", "[text]",       "[text.serial]",
    "[[text.line]]", "[image]", "[wrap]",  "[lens]",       "[[operation]]",
    "a lead",        "tabs",    "weave",   "[[material]]", "a process of a material"};

constexpr std::array<std::string_view, 8> kProcesses = {"engrave", "mark", "cut",  "fill",
                                                        "raster",  "weld", "heat", "drill"};

std::string numbers_in_words(const Takes& takes, std::string_view what) {
  const std::string high = base::number_text(takes.high);
  if (!takes.low_itself)
    return std::string(what) + " above " + base::number_text(takes.low) + ", up to " + high;
  return std::string(what) + " from " + base::number_text(takes.low) + " to " + high;
}

template <typename List>
std::string listed(const List& words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 == words.size() ? " or " : ", ";
    list += words[i];
  }
  return list;
}

}  // namespace
}  // namespace key_rows

using key_rows::kKeys;
using key_rows::kProcesses;
using key_rows::kTitles;
using key_rows::numbers_in_words;

std::vector<std::string_view> words_of(const Takes& takes) {
  std::vector<std::string_view> words;
  for (std::string_view rest = takes.words; !rest.empty();) {
    const std::size_t end = std::min(rest.find('|'), rest.size());
    words.push_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return words;
}

std::string in_words(const Takes& takes) {
  switch (takes.form) {
    case Takes::Form::number: return numbers_in_words(takes, "a number");
    case Takes::Form::whole_number: return numbers_in_words(takes, "a whole number");
    case Takes::Form::flag: return "true or false";
    case Takes::Form::word: return key_rows::listed(words_of(takes));
    case Takes::Form::text: return "a text of at most 1000 bytes";
    case Takes::Form::texts: return "a text, or a list of texts";
    case Takes::Form::pair: return "[x, y], each " + numbers_in_words(takes, "a number");
    case Takes::Form::triple: return "[x, y, z], each " + numbers_in_words(takes, "a number");
    case Takes::Form::pairs: return "a list of pairs of numbers, [[x, y], …]";
    case Takes::Form::number_or_pair:
      return numbers_in_words(takes, "a number") + ", or [x, y] of such numbers";
    case Takes::Form::number_or_word:
      return key_rows::listed(words_of(takes)) + ", or " + numbers_in_words(takes, "a number");
    case Takes::Form::word_or_pair: return key_rows::listed(words_of(takes)) + ", or [x, y]";
    case Takes::Form::table: return "a table, {key = value, …}";
  }
  return {};
}

std::string_view title_of(KeyTable table) { return kTitles[static_cast<std::size_t>(table)]; }

void say(const JobKey& key, const KeyOwner& owner, const KeyValue& value) {
  key.assign(owner, value);
  // What has a value also where nobody says it: a material fills it only then.
  if (key.table != KeyTable::operation) return;
  Operation& operation = *std::get<Operation*>(owner);
  if (key.name == "passes") operation.has_passes = true;
  if (key.name == "pierce_s") operation.has_pierce = true;
}

std::span<const JobKey> job_keys() { return kKeys; }

const JobKey* find_key(KeyTable table, std::string_view name) {
  const auto is_it = [&](const JobKey& key) { return key.table == table && key.name == name; };
  const auto found = std::find_if(std::begin(kKeys), std::end(kKeys), is_it);
  return found == std::end(kKeys) ? nullptr : found;
}

KeyTable table_inside(const JobKey& key) {
  if (key.name == "tabs") return KeyTable::tabs;
  return key.name == "weave" ? KeyTable::weave : KeyTable::lead;
}

std::string_view name_of(Process process) { return kProcesses[static_cast<std::size_t>(process)]; }

std::string names_of(Processes processes) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < kProcesses.size(); ++i) {
    if ((processes >> i & 1U) != 0) names.push_back(kProcesses[i]);
  }
  return key_rows::listed(names);
}

}  // namespace kerf::process
