#include "face/cli/output_files.hpp"

#include <filesystem>

#include "drive/pulse_csv.hpp"
#include "drive/pulse_vcd.hpp"
#include "face/cli/failure.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;
using base::OutputFile;

namespace fs = std::filesystem;

// One that is to be made is one as well.
bool is_ordinary(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return path != "-" && !path.empty() && (fs::is_regular_file(status) || !fs::exists(status));
}

std::vector<std::string> axis_names(const machine::MachineDefinition& machine) {
  std::vector<std::string> names;
  for (const machine::DrivenAxis& axis : machine.driven) names.push_back(axis.name);
  return names;
}

}  // namespace

bool is_same_file(const std::string& a, const std::string& b) {
  if (!is_ordinary(a) || !is_ordinary(b)) return false;
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  const fs::path first = fs::weakly_canonical(fs::absolute(a), error);
  return !error && first == fs::weakly_canonical(fs::absolute(b), error) && !error;
}

Outcome<void> OutputFiles::check_alone(const std::string& path) const {
  for (const std::string& input : inputs_) {
    if (is_same_file(path, input))
      return usage(path + ": is read by this command, and cannot be its output");
  }
  for (const File& other : files_) {
    if (is_same_file(path, other.file->path()))
      return usage(path + ": two outputs cannot go to one file");
  }
  return {};
}

Outcome<OutputFile*> OutputFiles::create(const std::string& path, Kind kind) {
  if (auto alone = check_alone(path); !alone) return tl::unexpected(alone.error());
  auto created = OutputFile::create(path);
  if (!created) return tl::unexpected(created.error());
  files_.push_back({kind, std::move(*created), {}});
  return files_.back().file.get();
}

Outcome<void> OutputFiles::commit(File& file) {
  if (file.finish) file.finish(*file.file);
  auto committed = file.file->commit();
  const std::string& path = file.file->path();
  if (committed && path != "-") written_.push_back(path);
  return committed;
}

void OutputFiles::leave_out(const std::string& path) {
  std::erase_if(files_, [&](const File& file) { return file.file->path() == path; });
}

Outcome<void> OutputFiles::commit(Which which) {
  Outcome<void> result;
  for (File& file : files_) {
    if (file.kind == Kind::drives_a_machine && which == Which::records_only) continue;
    auto committed = commit(file);
    if (!committed && result) result = committed;
  }
  files_.clear();
  return result;
}

Outcome<void> check_picture(const std::string& option, const std::string& path) {
  if (path.empty() || is_png(path) || path.ends_with(".svg")) return {};
  return usage(option + " " + path + ": a picture ends in .svg or .png");
}

Outcome<std::unique_ptr<drive::PulseSink>> open_pulse_file(
    OutputFiles& files, const std::string& path, const machine::MachineDefinition& machine) {
  const bool vcd = path.ends_with(".vcd");
  if (!path.empty() && path != "-" && !vcd && !path.ends_with(".csv"))
    return usage("--pulses " + path + ": step pulses end in .csv or .vcd");
  std::unique_ptr<drive::PulseSink> sink;
  const auto opened = files.open(path, OutputFiles::Kind::drives_a_machine, [&](OutputFile& file) {
    if (!vcd) {
      sink = std::make_unique<drive::PulseCsv>(axis_names(machine), file);
      return;
    }
    auto writer = std::make_unique<drive::PulseVcd>(axis_names(machine),
                                                    machine.drive.timing.direction_setup_ns, file);
    files.when_over([last = writer.get()](OutputFile&) { last->finish(); });
    sink = std::move(writer);
  });
  if (!opened) return tl::unexpected(opened.error());
  return sink;
}

}  // namespace kerf::cli
