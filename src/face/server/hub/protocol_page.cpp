#include "face/server/hub/protocol_page.hpp"

#include <fmt/format.h>

#include "face/server/hub/commands.hpp"

namespace kerf::server {
namespace {

constexpr std::string_view kPreface =
    R"md(<!-- Made by `kerf serve --protocol` from src/face/server/hub/commands.def and src/machine/panel/operations.def: change
those, run this. -->

# The panel's protocol

What a page or another program says to `kerf serve`, and hears from it. Version {version}. Units stand in the keys: mm, degrees,
seconds, mm/min.

## Frames
`/ws` is a WebSocket. Its text frames are JSON, its binary frames are chunks of a path, or what is seen of a part.

A command is `{{"id":7,"do":"NAME",…}}`; it is answered by `{{"id":7,"ok":true,…}}` or `{{"id":7,"ok":false,"error":"sentence"}}`.
A refusal that operators meet has `code` and `values` as well, for who says it in another language: [base/refusals.def](../src/base/refusals.def).
Answers come when they are ready, not in the order of the commands. `id` may be any number or text; without one it is null.

A command may carry `at_ms`, the time at which it was given, by the clock that `ping` tells: one that has become older
than {late} s before it is carried out is refused. So nothing moves because a key was pressed long ago and the line was hung.

| who | may send a command |
| --- | --- |
| anyone | who is connected |
| watcher | who has sent `watch` |
| operator | who operates the machine that he watches: `operate` |

## Limits
A message has at most {message} bytes, a connection sends at most {rate} commands a second on average and {burst} at once, a server has
at most {machines} machines. When more than {queue} MiB of answers wait for a client, or he takes nothing for {stalled} s, his
connection is closed. Who has sent a `ping` and then nothing for {silent} s lets go of the jog
keys. A client gets at most {states} states a second, the newest each time; chunks and answers are never left out.

## Commands
| do | who | arguments | what it does, and the answer |
| --- | --- | --- | --- |
)md";

constexpr std::string_view kRest = R"md(
## Events
`{"event":"NAME",…}`.

`hello`: `{"event":"hello","protocol","server","began_ms","client":"client-1","dialects":[{"name","language","ending","shows_by_ending",
"comment":["(",")"],"example","fresh","is_listing"},…],"token_kinds":["blank",…]}`, the first of all. `server` is another text each
time the server begins, `began_ms` when that was, since 1970. Of a dialect: the usual ending of its files, and whether that alone
says what a file is; the marks of a comment, the second one empty where it goes to the end of its line; what a line looks like;
what a new program begins with; whether files are bytes, and texts their listing. `blank` and `error` are kinds of tokens, too:
each character of a line is in exactly one token.

`request-refused`: `{"event":"request-refused","machine"}`, to who has asked to operate it.

`state`: of the machine that is watched. The first has every key, the others only those whose value has changed.
`{"event":"state","machine","status":"idle|running|held|stopped|step|end|alarm","mode","program","file","line","text","time_s",
"total_s","run","motion","motions","position":{"machine":{},"work":{},"distance":{}},"joints":{},"modal":["G01",…],
"feed":{"programmed_mm_min","actual_mm_min","programmed_mm_rev"},"spindle":{"speed_rpm","direction","surface_m_min","limit_rpm","load"},
"tool","tool_offset","coolant","power_percent","beam",
"override":{"feed","rapid","spindle"},"switches":{},"skip":[],"alarm":null|{"code","message","program","file","line","column",
"length","cause","remedy"},"messages":[],"stack":[{"program","file","line","level"}],"variables_revision","printed",
"waits_for_input","inputs":[bits,word,word,word],"breakpoint":null|{…},"preview_run","operator":null|"client-1",
"clients":["client-1",…],
"people":{"client-1":"Lee"},"request":null|{"client","until_ms"},"fault":null|"sentence",
"unsaved":null|"sentence"}`. `unsaved`: why the memory cannot be written to the disk; the server goes on trying.
Positions are as people count: of an axis with `diameter` in the definition twice the way, as are its travel there, offsets and
what a jog by a distance says; `joints`, rates and paths are the ways themselves. `programmed_mm_rev` is 0 where the feed counts minutes,
`surface_m_min` where the speed of the spindle is fixed; `tool_offset` is the number that T of a lathe has brought; `speed_rpm` is what it turns now.
`inputs` are the signals #1000 to #1015 as bits of one number, and #1033 to #1035 as words of 32 bits.
`total_s` is how long the program takes, as soon as its preview has come to the end. `file` is MDI while an entry executes.

`path`: `{"event":"path","machine","run","done","motions","vertices","time_s","bounds":null|{"min":[x,y,z],"max":[x,y,z]},
"files":["O1.nc",…],"dialect","error":null|{…},"findings":[{…},…],"stop":null|{"motion","time_s"},"cut_short"}`, when the preview of a
program begins, whenever it has gone further, and when it ends. The preview goes on behind alarms, without their blocks:
`findings` are all of them, each code once a line, the first one being `error`; `stop` is the last motion that a machine
would make and the time when it rests behind that. `cut_short`: of what comes behind the stop, not everything was looked at.
`error` may be a warning, where a preview ends though the machine would go on: BUDGET, or INPUT_WAIT of a program that waits for an
input signal. `set-input` renews the preview of a program that reads inputs, at most twice a second.

`stock`: of the part of what is loaded, to who has it shown, with the keys whose value has changed; of another `run` all are new.
`{"event":"stock","machine","run","model":"zmap|tridexel|profile|sheet","reason","stock":{"origin","low","high"},"cell_mm",
"levels":[null|{"first":[x,y],"cell_mm":[x,y],"cells":[nx,ny]},…],"files":["O1.nc",…],"done_s","done","removed_mm3",
"findings":[{…},…],"more_findings","threads":[{…},…],"assumed":[{"line","what"},…],"not_checked":[…],"behind","error":null|{"message"},"design":null|{"file","tolerance_mm"},
"owners":{"from","rows":[[file,line,tool,null|engagement_deg],…]}}`.
Places and lengths count from the zero of the stock, mm, X of a lathe as a radius; `origin` is that zero in machine coordinates, `low` and
`high` are the box of the stock. A level tells the middle of its first column; one that is no grid of columns is null. `done_s`: up to
this second of the program the part is cut. `removed_mm3` is up to the time that is shown; `behind`: it is not cut as far as was
asked for. A finding is a diagnostic with `time_s`, `tool`, `motion`, `at`: `[x,y,z]`, `depth_mm`, `volume_mm3` and `count`, how often the
block did it; one of the whole run has line 0. `owners`: rows that are new or known better, from the number `from` on, or with `from` 0
in place of all before; a frame names who cut a place by the number of a row, and row 0 is nobody's. A program of more than 65,535
blocks that cut has several neighbours in a row, which then names the first of them. `engagement_deg`: over so much of its circle the
tool was in the material, the most of all motions of the row, 180 in a full slot; null: not known, as of drills and inserts. `design`:
the file of the set-up that the part is seen against; deviations are told where `stock_at` asks for them. `error`: why the part is not cut, or not to its end.

`features`: `{"event":"features","machine","revision"}`, when another program is loaded, its set-up or the machine has changed: what was told of
an older revision of its features holds no more.

`machines`: `{"event":"machines","machines":[…]}` with the rows of the command, when machines, clients or operators have changed.

`definition`: `{"event":"definition","machine","definition","settings"}`, when the machine file has been replaced. A definition has
`modal_groups`: list of `{group, number, codes}` of the machine's dialect and G-code system, `number`: that behind #40, `codes`: list of `{code, title, sentence, quiet}`, in the order in which a page shows them;
`quiet` says that nothing special is on.

## Chunks
A binary frame, little endian:

| bytes | type | what |
| --- | --- | --- |
| 0 | 4 bytes | `KPTH` |
| 4 | u16 | version 1; bit 8 set: with rotary axes |
| 6 | u16 | source: 0 preview |
| 8 | u32 | run, as in `path` |
| 12 | u32 | number of the chunk, from 0 |
| 16 | u32 | motion of the first segment |
| 20 | u32 | n: vertices, 2 to 65,536 |
| 24 | f64 | time base, s |

Then arrays, each padded to 4 bytes: f32 `xyz[3n]` (tool tip, machine coordinates, mm), f32 `time_s[n]` (from the time base on),
f32 `feed_mm_min[n]` (programmed; of rapids 0), f32 `speed_mm_min[n]` (mean over the segment, as the axes reach it), u32 `motion[n]`
(from 1, in the order of the run), u32 `line[n]`, u16 `file[n]` (of `files`), u8 `kind[n]` (0 rapid, 1 cut, 2 dwell, 3 thread,
4 probe), u8 `tool[n]`, u8 `power_percent[n]`, and with rotary axes f32 `rotary[2n]` (the first two, degrees).

Vertex 0 is where the first segment begins, the last vertex of the chunk before; vertex i is the end of segment i. Arcs are cut into
chords that leave them by at most 0.01 mm.

## Frames of the part
A binary frame, little endian:

| bytes | type | what |
| --- | --- | --- |
| 0 | 4 bytes | `KSTK` |
| 4 | u16 | version 1 |
| 6 | u16 | kind: 0 heights, 1 triangles, 2 half section, 3 sheet, 4 facts |
| 8 | u32 | run, as in `stock` |
| 12 | u32 | number of the frame; 0: it begins a picture, which replaces the one before |
| 16 | u32 | level |
| 20 | u32 | n: parts |
| 24 | f64 | time that is shown, s of the program |

Then n parts, each padded to 4 bytes. Only tiles that have changed are sent, and of those that have changed several times the newest
state: a client has at most one frame of about a MiB under way, and the next one is made when he has taken it.

Kind 0: i32 `x`, `y` of the tile, u16 `nx`, `ny` (at most 65), f32 `z0`, `dz`, u16 `height[nx·ny]` (z = z0 + dz·height, rows along X; 65535:
nothing is left), u16 `owner[nx·ny]`. Tiles begin every 64 columns.

Kind 1: i32 `x`, `y`, `z` of the tile, u32 `nv`, `nt`, f32 `origin[3]`, `scale`, i16 `position[3nv]` (a vertex stands at origin + scale·position),
i8 `normal[2nv]` (octahedral), u16 `owner[nv]`, u16 `index[3nt]`. A tile replaces what it was; nt = 0: there is nothing.

Kind 2: a part is a closed line: u32 n, n times f64 z, ρ (a radius) and bulge (the tangent of a quarter of the angle of the arc to the
next corner; 0: a line). All lines together are what is left, on the left of them.

Kind 3: i32 `x`, `y` of the tile, u16 `nx`, `ny`, f32 `full`, u8 `energy[nx·ny]` (255: `full` J/mm²), u8 `coverage[nx·ny]` (255: cut).

Kind 4: of parts that have come, what is known besides; it holds until the part itself comes anew, and is none of a picture of another
run or level. i32 `x`, `y`, `z` of the tile (of heights z is 0; of a half section x is the number of the line), u16 `what`, u16 0, u32 n,
f32 `scale`, i16 `value[n]`, in the order of the columns, vertices or corners. `what` 0: how far each place is from the design, scale·value
mm: above 0 material is left, below 0 it is cut away; -32768: not known. `what` 1: the owner of the line or arc that begins at
the corner, as u16; of half sections alone. A part with a design has corners all along its half section, so that between two of them deviations run evenly.

## HTTP
`GET /` and what it refers to: the page. `GET /api`: this document. `GET /notices`: licences. `GET /health`. `GET /library/NAME`: a program.
`PUT /library/NAME`: saves the body as a program of at most 256 MiB; the answer is `{"name","bytes","revision"}`, or 413 with a
sentence, and then nothing is kept. An `Origin` must be the host that was asked for; without a token that host must be this
computer. The token is given once as `/?token=…`, which sets a cookie.
)md";

const char* name_of(Command::Who who) {
  switch (who) {
    case Command::Who::anyone: return "anyone";
    case Command::Who::watcher: return "watcher";
    case Command::Who::op: return "operator";
  }
  return "";
}

std::string argument_text(const Argument& argument) {
  std::string text = "`" + std::string(argument.name) + "`";
  if (argument.need == Argument::Need::optional) text += "?";
  text += ": " + kind_text(argument);
  if (!argument.fields.empty()) {
    text += " with ";
    for (const Argument& field : argument.fields)
      text += (&field == &argument.fields.front() ? "" : ", ") + argument_text(field);
  }
  if (!argument.note.empty()) text += " (" + std::string(argument.note) + ")";
  return text;
}

std::string row_of(const Command& command) {
  std::string arguments;
  for (const Argument& argument : command.arguments)
    arguments += (arguments.empty() ? "" : "<br>") + argument_text(argument);
  std::string what(command.sentence);
  if (!command.answer.empty()) what += " Answer: " + std::string(command.answer) + ".";
  return fmt::format("| `{}` | {} | {} | {} |\n", command.name, name_of(command.who), arguments,
                     what);
}

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else
      html += c;
  }
  return html;
}

}  // namespace

std::string protocol_markdown() {
  std::string text = fmt::format(
      kPreface, fmt::arg("version", kProtocol), fmt::arg("message", limits::kMessageBytes),
      fmt::arg("rate", limits::kCommandsPerSecond), fmt::arg("burst", limits::kCommandBurst),
      fmt::arg("machines", limits::kMachines), fmt::arg("queue", limits::kQueueBytes >> 20U),
      fmt::arg("stalled", limits::kStalledSeconds), fmt::arg("silent", limits::kSilentSeconds),
      fmt::arg("late", limits::kLateMs / 1000), fmt::arg("states", limits::kStatesPerSecond));
  for (const Command& command : commands()) text += row_of(command);
  return text + std::string(kRest);
}

std::string protocol_html() {
  return "<!doctype html><html lang=en><meta charset=utf-8><title>The panel's protocol</title>"
         "<pre style=\"white-space:pre-wrap;max-width:60rem;margin:2rem auto\">" +
         escaped(protocol_markdown()) + "</pre></html>\n";
}

}  // namespace kerf::server
