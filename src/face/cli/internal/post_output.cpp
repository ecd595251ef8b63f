#include "face/cli/internal/post_output.hpp"

#include "face/cli/failure.hpp"

namespace kerf::cli {

using base::Outcome;
using base::OutputFile;
using output::PostFlavour;

Outcome<const PostFlavour*> PostOutput::flavour() const {
  const std::string& name = options_.flavour;
  if (name.empty()) return &output::post_flavours().front();
  if (const PostFlavour* const found = output::find_flavour(name)) return found;
  std::string list;
  for (const PostFlavour& one : output::post_flavours())
    list += (list.empty() ? "" : ", ") + std::string(one.name);
  return usage("--flavour " + name + ": there is no such one; available: " + list);
}

// Without --post the others say how something is written that nobody has asked for.
Outcome<void> PostOutput::check_alone() const {
  const auto alone = [](const std::string& option) {
    return usage(option + " says how --post FILE is written: give that too");
  };
  if (!options_.flavour.empty()) return alone("--flavour");
  if (!options_.post_axes.empty()) return alone("--axes");
  if (!options_.post_tools.empty()) return alone("--post-tools");
  if (options_.post_strict) return alone("--post-strict");
  return {};
}

Outcome<void> PostOutput::check_axes(const machine::MachineDefinition& machine) const {
  for (const char letter : options_.post_axes) {
    if (!machine.axes.find(letter))
      return usage("--axes " + options_.post_axes + ": " + machine.name + " has no axis " + letter);
  }
  return {};
}

Outcome<void> PostOutput::open_tools(const PostFlavour& flavour) {
  if (!options_.post_tools.empty() && flavour.lengths != PostFlavour::Lengths::of_table)
    return usage("--post-tools " + options_.post_tools + ": controls of the flavour " +
                 std::string(flavour.name) + " have no table of tools");
  return files_.open(options_.post_tools, OutputFiles::Kind::drives_a_machine, [&](OutputFile&) {
    files_.when_over([this](OutputFile& into) { into.write(writer_->tools()); });
  });
}

Outcome<void> PostOutput::open(const machine::MachineDefinition& machine,
                               const std::string& title) {
  if (options_.post.empty()) return check_alone();
  const auto chosen = flavour();
  if (!chosen) return tl::unexpected(chosen.error());
  if (auto checked = check_axes(machine); !checked) return checked;
  output::PostSettings settings{**chosen};
  if (!options_.post_axes.empty()) settings.axes = options_.post_axes;
  auto opened =
      files_.open(options_.post, OutputFiles::Kind::drives_a_machine, [&](OutputFile& file) {
        writer_ = output::make_post(machine, title, file, settings);
        files_.when_over([this](OutputFile&) {
          writer_->finish();
          report_ = writer_->json();
        });
      });
  if (!opened) return opened;
  if (!writer_)
    return usage("--flavour " + std::string((*chosen)->name) + ": no control of it turns, " +
                 machine.name + " does; plain and fanuc have lathes");
  return open_tools(**chosen);
}

bool PostOutput::fails() const { return options_.post_strict && writer_ && writer_->lost() > 0; }

void PostOutput::judge() {
  if (!fails() || options_.keep_partial) return;
  files_.leave_out(options_.post);
  if (!options_.post_tools.empty()) files_.leave_out(options_.post_tools);
  report_ = writer_->json();
}

}  // namespace kerf::cli
