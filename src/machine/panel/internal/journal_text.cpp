#include "machine/panel/internal/journal_text.hpp"

#include "machine/panel/internal/run_start_json.hpp"
#include "machine/panel/operation_table.hpp"

namespace kerf::machine {
namespace {

using Moment = LiveCore::Moment;

constexpr int kVersion = 1;
constexpr std::size_t kMostEntriesOfJournal = 200'000;
constexpr int kMostDepth = 10;

tl::unexpected<base::Failure> no_journal(const std::string& sentence) {
  return tl::unexpected(base::Failure{base::Failure::Kind::input, "journal: " + sentence});
}

// `[points, turns]`, without turns: the next point is made and waits.
Json moment_json(const Moment& moment) {
  Json json = {moment.points};
  if (moment.turns != Moment::kAllTurns) json.push_back(moment.turns);
  return json;
}

Moment moment_in(const Json& object, const char* key) {
  const Json& list = list_in(object, key, 2);
  Moment moment{0, Moment::kAllTurns};
  const auto count = [&](const Json& value) {
    if (!value.is_number_unsigned()) throw NoJournal{std::string(key) + " is no moment"};
    return value.get<std::uint64_t>();
  };
  if (list.empty()) throw NoJournal{std::string(key) + " is no moment"};
  moment.points = count(list[0]);
  if (list.size() == 2) moment.turns = count(list[1]);
  return moment;
}

// Keys that no operator presses by a word.

Json json_of_key(const Operation& key) {
  if (const auto* const load = std::get_if<Load>(&key))
    return {{"do", "load"}, {"program", program_json(load->program)}, {"dialect", load->dialect}};
  if (const auto* const set = std::get_if<SetMemory>(&key))
    return {{"do", "set-memory"}, {"memory", memory_json(set->memory)}};
  if (std::holds_alternative<Raise>(key))
    throw NoJournal{"a drive has raised an alarm, which it cannot hold"};
  return json_of(key);
}

Operation table_key_of(const Json& json, const std::string& name) {
  const OperationRow* const row = find_operation(name);
  if (row == nullptr) throw NoJournal{"there is no key " + name};
  const auto checked = check_arguments(json, row->arguments, {"at", "do", "before_block"});
  if (!checked) throw NoJournal{name + ": " + checked.error().message};
  auto key = row->read(Arguments(json));
  if (!key) throw NoJournal{key.error().message};
  if (std::holds_alternative<StepBack>(*key))
    throw NoJournal{"a step back is not done again but stops the run earlier"};
  return std::move(*key);
}

Operation key_of(const Json& json, const RunStart& start) {
  const std::string name = text_in(json, "do");
  if (name == "load") return Load{program_in(json, "program"), text_in(json, "dialect")};
  if (name == "set-memory")
    return SetMemory{
        memory_in(json, "memory", control::Memory(start.definition.parameters.n_offsets))};
  return table_key_of(json, name);
}

bool acts_where_the_axes_are(const Operation& key) {
  return std::holds_alternative<SetBlockSkip>(key) || std::holds_alternative<SetVariable>(key) ||
         std::holds_alternative<Interrupt>(key);
}

Json entry_json(const Journal::Entry& entry) {
  Json json = {{"at", moment_json(entry.at)}};
  if (entry.key) json.update(json_of_key(*entry.key));
  if (entry.before_block) json["before_block"] = *entry.before_block;
  if (entry.last_block) json["last_block"] = *entry.last_block;
  return json;
}

Journal::Entry entry_of(const Json& json, const RunStart& start) {
  Journal::Entry entry{moment_in(json, "at")};
  if (json.contains("last_block")) {
    entry.last_block = count_in(json, "last_block");
    return entry;
  }
  entry.key = key_of(json, start);
  if (!json.contains("before_block")) return entry;
  entry.before_block = count_in(json, "before_block");
  if (!acts_where_the_axes_are(*entry.key))
    throw NoJournal{"before_block stands with a key that acts at once"};
  return entry;
}

std::string written(const ToldJournal& told) {
  const Journal& journal = told.journal;
  if (journal.entries.size() > kMostEntriesOfJournal)
    throw NoJournal{"more than " + std::to_string(kMostEntriesOfJournal) + " things were done"};
  Json json = {{"kerf_journal", kVersion},
               {"start", run_start_json(journal.start)},
               {"run", journal.run},
               {"entries", Json::array()},
               {"until", moment_json(told.until)}};
  for (const Journal::Entry& entry : journal.entries) json["entries"].push_back(entry_json(entry));
  std::string text = json.dump(1) + "\n";
  if (text.size() > LiveMachine::kMostJournalBytes)
    throw NoJournal{"it would have " + std::to_string(text.size()) + " bytes"};
  return text;
}

// Brackets within each other cost nothing before they are too many.
Json parsed(std::string_view text) {
  if (text.size() > LiveMachine::kMostJournalBytes)
    throw NoJournal{"it has " + std::to_string(text.size()) + " bytes, more than any"};
  return Json::parse(text, [](int depth, Json::parse_event_t /*event*/, Json& /*value*/) {
    if (depth > kMostDepth) throw NoJournal{"its brackets are too deep"};
    return true;
  });
}

ToldJournal read(std::string_view text, std::vector<std::string> library_folders) {
  const Json json = parsed(text);
  if (!json.is_object() || !json.contains("kerf_journal"))
    throw NoJournal{"this is not a journal of Kerf"};
  if (json["kerf_journal"] != kVersion)
    throw NoJournal{"its version is another one than " + std::to_string(kVersion)};
  ToldJournal told{
      {run_start_of(field(json, "start"), std::move(library_folders)), count_in(json, "run")},
      moment_in(json, "until")};
  for (const Json& entry : list_in(json, "entries", kMostEntriesOfJournal))
    told.journal.entries.push_back(entry_of(entry, told.journal.start));
  return told;
}

}  // namespace

base::Outcome<std::string> journal_text(const ToldJournal& told) {
  try {
    return written(told);
  } catch (const NoJournal& why) {
    return no_journal(why.sentence);
  } catch (const Json::exception&) {
    return no_journal("a text that was entered is no UTF-8");
  }
}

base::Outcome<ToldJournal> read_journal(std::string_view text,
                                        std::vector<std::string> library_folders) {
  try {
    return read(text, std::move(library_folders));
  } catch (const NoJournal& why) {
    return no_journal(why.sentence);
  } catch (const Json::exception&) {
    return no_journal("this is not a journal of Kerf");
  }
}

}  // namespace kerf::machine
