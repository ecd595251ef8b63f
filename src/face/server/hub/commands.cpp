#include "face/server/hub/commands.hpp"

#include <algorithm>

#include "machine/dialect/registry.hpp"
#include "machine/panel/operation_table.hpp"

namespace kerf::server {
namespace {

using namespace machine::argument;
using Who = Command::Who;

constexpr double kMostTime_s = 1e9;

// A key of the panel: the operator's.
Command key(std::string_view name, std::string_view more = {}, std::string_view answer = {}) {
  const machine::OperationRow& row = *machine::find_operation(name);
  return {row.name, Who::op, row.arguments, std::string(row.sentence).append(more), answer, &row};
}

std::vector<Command> make_table() {
  const Argument program_text = text("text", limits::kTextBytes);
  return {
      {"machines",
       Who::anyone,
       {},
       "Lists the machines of this server.",
       "`machines`: list of `{name, title, definition, status, program, operator, clients, "
       "suits}`, "
       "`suits`: the "
       "kinds of `recognise` that it makes; `definitions`: "
       "names and titles of the built-in machines"},
      {"ping",
       Who::anyone,
       {},
       "Tells the server's clock. Who has sent one and is silent for 3 s lets go of the jog keys.",
       "`time_ms`"},
      {"introduce",
       Who::anyone,
       {text("name", 40, "empty: none")},
       "Says what the person at this client is called, for `people`."},
      {"create",
       Who::anyone,
       {name_of("name", "1 to 32 letters, digits, - and _"),
        name_of("definition", "a built-in machine")},
       "Makes a machine. It stays until it is removed."},
      {"remove",
       Who::anyone,
       {name_of("name")},
       "Removes a machine with its memory, unless someone else operates or watches it."},
      {"watch",
       Who::anyone,
       {name_of("machine")},
       "Sends the states, paths and chunks of this machine from now on, the chunks from the first "
       "one; those of another machine end.",
       "`definition`, `client`: your own name, `settings`: the machine file"},
      {"operate",
       Who::watcher,
       {flag("take", "false: gives the machine free"),
        name_of("hand_to", "another client of the machine, which operates it then",
                Need::optional)},
       "Takes over, gives free or hands over the operation of the machine. A free machine is given "
       "to who asks; a closed connection frees it."},
      {"request-operation",
       Who::watcher,
       {flag("ask", "false: withdraws the request")},
       "Asks the operator for the machine. He sees it in `request`; it is handed over when he says "
       "nothing for 10 s, and at once when nobody operates it."},
      {"answer-request",
       Who::op,
       {flag("grant")},
       "Hands the machine over to who asks for it, or refuses."},
      {"load",
       Who::op,
       {name_of("program", "of the library", Need::optional),
        text("text", limits::kTextBytes, "a program that is not in the library", Need::optional),
        name_of("name", "with `text`", Need::optional),
        choice("dialect", machine::text_dialects(),
               "otherwise the ending of the name says it, or that of the machine", Need::optional)},
       "Loads a program; its preview run begins.",
       "`program`: its name"},
      key("mode"),
      key("cycle-start"),
      key("feed-hold"),
      key("reset"),
      key("interrupt"),
      key("switch"),
      key("block-skip"),
      key("override"),
      key("jog"),
      key("jog-stop"),
      key("home"),
      key("mdi"),
      key("enter"),
      key("step"),
      key("run-to"),
      key("start-at"),
      key("breakpoints", {}, "`list`: where they stand now"),
      {"variables",
       Who::watcher,
       {integer("level", {0, 1000}, "of the calls, 0 is the main program; otherwise the innermost",
                Need::optional),
        texts("names", "only these")},
       "Tells values of variables.",
       "`variables`: list of `{name, value, level, changed}`, `scopes`"},
      key("set-variable"),
      key("set-input"),
      {"offsets",
       Who::watcher,
       {},
       "Tells work offsets and tool offsets.",
       "`offsets`: list of `{offset, axis, value}`"},
      key("set-offset", " Answered when it is on the disk."),
      {"tools",
       Who::watcher,
       {},
       "Tells the tool table.",
       "`tools`: list of `{number, length_geometry, length_wear, radius_geometry, radius_wear}`, "
       "those that are not all 0"},
      {"set-tool",
       Who::op,
       {integer("number", {1, 999}), number("length_geometry", {-1e6, 1e6}, "mm", Need::optional),
        number("length_wear", {-1e6, 1e6}, "mm", Need::optional),
        number("radius_geometry", {-1e6, 1e6}, "mm", Need::optional),
        number("radius_wear", {-1e6, 1e6}, "mm", Need::optional)},
       "Changes a row of the tool table. Answered when it is on the disk."},
      {"instant",
       Who::watcher,
       {number("time_s", {0, kMostTime_s})},
       "Tells the state at that instant of this run, which is made once more up to there; behind "
       "now that of the program as it would run without anybody at the panel.",
       "the keys of `state` that the machine says, and `variables`"},
      {"speeds",
       Who::watcher,
       {number("from_s", {0, kMostTime_s}), number("to_s", {0, kMostTime_s}),
        integer("points", {2, 5000})},
       "Tells the speed along the path of the preview between two times.",
       "`time_s`, `speed_mm_min`, `line`: lists of equal length; the fastest of each interval"},
      {"pulses",
       Who::watcher,
       {number("seconds", {0, 10})},
       "Tells the edges of the step pulses of the last seconds.",
       "`time_s`: now, `pulses`: `{joint: [time_s, direction, …]}`, `lines`: list of `[from_s, "
       "to_s, "
       "line]`; the first question begins to record"},
      {"journal",
       Who::watcher,
       {},
       "Tells what was done in this run, to be done again with `kerf replay`: what it began with "
       "(the machine file, the memory, the panel, the program with its text, what it had printed) "
       "and every key since. Nobody's name is in it.",
       "`name`: of a file, `text`"},
      {"check",
       Who::anyone,
       {program_text, name_of("name"),
        name_of("machine", "otherwise the one that is watched, or mill3", Need::optional)},
       "Tells what is wrong with a text. A check that takes longer than 5 s ends in the warning "
       "BUDGET.",
       "`diagnostics`: the first 1,000, a list of `{severity, code, message, line, column, length, "
       "cause, remedy}`, `more`: how many there are besides them"},
      {"dialect",
       Who::anyone,
       {name_of("name"), text("text", limits::kHeadBytes, "its beginning")},
       "Tells in which dialect the watched machine reads a text.",
       "`dialect`: a name of `hello`"},
      {"tokens",
       Who::anyone,
       {choice("dialect", machine::dialect_names()),
        text("lines", limits::kLineBytes, "lines of a program, apart by line feeds")},
       "Cuts lines into tokens, as the compiler of the dialect reads them.",
       "`tokens`: for each line a list `[kind, length, kind, length, …]` of whole lines, kinds as "
       "places in `token_kinds` of `hello`, lengths in UTF-16 units"},
      {"exercises",
       Who::anyone,
       {},
       "Lists the exercises of the training mode.",
       "`exercises`: list of `{name, title, task, machine, file, start, zero_mm}`; `title` and "
       "`task` have `en` and `zh-Hant`, `zero_mm` is where G54 lies on the machine"},
      {"assess",
       Who::anyone,
       {name_of("exercise"), program_text},
       "Runs a text as the program of an exercise on a machine of its own and judges it.",
       "`score`: 0 to 100, `criteria`: list of `{kind, points, most, met, finding, sentence, "
       "values, code, message, file, line}`"},
      {"settings", Who::watcher, {}, "Tells the machine file.", "`toml`"},
      {"set-settings",
       Who::op,
       {text("toml", 100'000)},
       "Replaces the machine file while nothing moves; the memory stays."},
      {"teach-capture",
       Who::op,
       {choice("kind", {"point", "line", "arc-via", "arc-end", "circle-end"}),
        name_of("name", "of the point", Need::optional)},
       "Puts the position of the machine into the taught program, in the mode teach.",
       "`text`: the whole program, `line`: the new one"},
      {"teach-record",
       Who::op,
       {text("text", 200, "FEED 600, LASER ON 40, DWELL 0.5, END")},
       "Puts another record into the taught program.",
       "`text`, `line`"},
      {"teach-back",
       Who::op,
       {},
       "Takes back the last record, or the waiting middle of an arc.",
       "`text`, `line`"},
      {"teach-new", Who::op, {}, "Begins a new taught program.", "`text`, `line`"},
      {"programs",
       Who::anyone,
       {},
       "Lists the library.",
       "`programs`: list of `{name, bytes, modified}`"},
      {"read",
       Who::anyone,
       {name_of("name"), integer("revision", {1, 1e9}, "otherwise as it is now", Need::optional),
        name_of("machine", "if it has loaded a program of this name, that one", Need::optional)},
       "Reads a program of at most 4 MiB; of a pattern (`.pat`) its listing, as `machine` or the "
       "watched one reads the bytes.",
       "`text`"},
      {"recognise",
       Who::anyone,
       {name_of("name")},
       "Tells for which kind of machine a program of the library looks to be written.",
       "`kind`: any, mill, lathe, laser, laser-basic, teach or pattern; `line`, `word`: where that "
       "shows; `usual`: the built-in machine for it, or empty"},
      {"write",
       Who::anyone,
       {name_of("name"), program_text},
       "Saves a program. Answered when it is on the disk. Of a pattern (`.pat`) the text is its "
       "listing, and the library gets the bytes, as the watched machine reads them.",
       "`revision`; of a pattern `text`, the listing of its bytes, which hold no comments"},
      {"rename", Who::anyone, {name_of("from"), name_of("to")}, "Renames a program."},
      {"delete", Who::anyone, {name_of("name")}, "Deletes a program; its revisions stay."},
      {"revisions",
       Who::anyone,
       {name_of("name")},
       "Lists the revisions of a program.",
       "`revisions`: list of `{revision, modified, bytes, kept}`, the newest first"},
  };
}

}  // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> table = make_table();
  return table;
}

const Command* find_command(std::string_view name) {
  const auto found = std::find_if(commands().begin(), commands().end(),
                                  [&](const Command& c) { return c.name == name; });
  return found == commands().end() ? nullptr : &*found;
}

}  // namespace kerf::server
