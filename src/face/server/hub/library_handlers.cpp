#include <ctime>

#include "base/refusal.hpp"
#include "face/server/hub/handlers.hpp"
#include "face/server/protocol/diagnostic_json.hpp"
#include "face/server/protocol/pattern_text.hpp"
#include "machine/dialect/program_look.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::server {
namespace {

using base::Outcome;

// "2026-11-21T15:04:05Z"
std::string iso_time(std::int64_t ms) {
  const std::time_t seconds = ms / 1000;
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  std::string text(32, '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc));
  return text;
}

void programs(Hub& hub, const Request& request) {
  hub.background().read_disk(request, [](Library& library) -> Outcome<Json> {
    const auto all = library.programs();
    if (!all) return tl::unexpected(all.error());
    Json rows = Json::array();
    for (const ProgramInfo& info : *all)
      rows.push_back(
          {{"name", info.name}, {"bytes", info.bytes}, {"modified", iso_time(info.modified_ms)}});
    return Json{{"programs", std::move(rows)}};
  });
}

Outcome<Json> text_json(const Outcome<std::string>& text) {
  if (!text) return tl::unexpected(text.error());
  return Json{{"text", *text}};
}

// In which the bytes of a count stand that a machine reads; null: none is watched.
drive::ByteOrder order_for(const MachineRecord* machine) {
  return machine != nullptr ? machine->definition.pattern.byte_order : drive::ByteOrder::big;
}

// As far as an answer can hold it.
Outcome<std::string> shown_listing(const std::string& bytes, const std::string& name,
                                   drive::ByteOrder order) {
  auto listing = listing_of(bytes, name, order);
  if (!listing || listing->size() <= Library::kMostReadBytes) return listing;
  return tl::unexpected(base::refuse(base::Refusal::pattern_unshown,
                                     {name, std::to_string(Library::kMostReadBytes >> 20U)}));
}

// Answers what stands on the disk then: comments do not.
Outcome<Json> write_pattern(Library& library, const std::string& name, const std::string& listing,
                            drive::ByteOrder order) {
  const auto bytes = bytes_of(listing, name, order);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto kept = shown_listing(*bytes, name, order);
  if (!kept) return tl::unexpected(kept.error());
  const auto made = library.write(name, *bytes);
  if (!made) return tl::unexpected(made.error());
  return Json{{"revision", made->number}, {"text", *kept}};
}

// A program that was loaded as a text is in no library: the machine has it.
void read(Hub& hub, const Request& request) {
  const Arguments arguments = request.arguments();
  const std::string name = arguments.text("name");
  const MachineRecord* const machine = hub.machines().find(arguments.text("machine"));
  if (machine != nullptr && machine->program && machine->program->text &&
      machine->program->name == name && !arguments.has("revision"))
    return request.reply.yes({{"text", *machine->program->text}});
  hub.background().read_disk(
      request,
      [name, revision = arguments.integer("revision"),
       order = order_for(machine != nullptr ? machine : request.machine)](Library& library) {
        auto text = revision > 0 ? library.read_revision(name, revision) : library.read(name);
        if (text && is_pattern(name)) text = shown_listing(*text, name, order);
        return text_json(text);
      });
}

void recognise(Hub& hub, const Request& request) {
  hub.background().read_disk(
      request, [name = request.arguments().text("name")](Library& library) -> Outcome<Json> {
        const auto path = library.path_of(name);
        if (!path) return tl::unexpected(path.error());
        const auto file = base::SourceFile::open(*path);
        if (!file) return tl::unexpected(file.error());
        const machine::ProgramLook look = machine::look_of(**file);
        return Json{{"kind", machine::name_of(look.kind)},
                    {"line", look.line},
                    {"word", output::printable(look.word)},
                    {"usual", machine::usual_machine(look.kind)}};
      });
}

void write(Hub& hub, const Request& request) {
  hub.background().change_disk(
      request,
      [body = request.body, order = order_for(request.machine)](Library& library) -> Outcome<Json> {
        const Arguments arguments(*body);
        const std::string name = arguments.text("name");
        if (is_pattern(name)) return write_pattern(library, name, arguments.text("text"), order);
        const auto made = library.write(name, arguments.text("text"));
        if (!made) return tl::unexpected(made.error());
        return Json{{"revision", made->number}};
      });
}

void rename(Hub& hub, const Request& request) {
  hub.background().change_disk(request, [body = request.body](Library& library) {
    const Arguments arguments(*body);
    return done(library.rename(arguments.text("from"), arguments.text("to")));
  });
}

void remove(Hub& hub, const Request& request) {
  hub.background().change_disk(request,
                               [name = request.arguments().text("name")](Library& library) {
                                 return done(library.remove(name));
                               });
}

void revisions(Hub& hub, const Request& request) {
  hub.background().read_disk(
      request, [name = request.arguments().text("name")](Library& library) -> Outcome<Json> {
        const auto all = library.revisions(name);
        if (!all) return tl::unexpected(all.error());
        Json rows = Json::array();
        for (const Revision& revision : *all)
          rows.push_back({{"revision", revision.number},
                          {"modified", iso_time(revision.time_ms)},
                          {"bytes", revision.bytes},
                          {"kept", revision.kept}});
        return Json{{"revisions", std::move(rows)}};
      });
}

}  // namespace

const Handlers& library_handlers() {
  static const Handlers handlers = {
      {"programs", programs}, {"read", read},     {"recognise", recognise}, {"write", write},
      {"rename", rename},     {"delete", remove}, {"revisions", revisions},
  };
  return handlers;
}

}  // namespace kerf::server
