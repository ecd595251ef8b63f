#include "face/server/store/library.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>

#include "base/refusal.hpp"
#include "face/server/store/private_files.hpp"
#include "face/server/store/program_name.hpp"

namespace kerf::server {
namespace {

using base::Failure;
using base::Outcome;
using base::usage;
namespace fs = std::filesystem;

tl::unexpected<Failure> refused(base::Refusal why, std::vector<std::string> values) {
  return tl::unexpected(base::refuse(why, std::move(values)));
}

tl::unexpected<Failure> disk(const std::string& message) {
  return tl::unexpected(Failure{Failure::Kind::output, message});
}

// No program has such a name.
std::string set_up_of(const std::string& program) { return "set-up/" + program; }
std::string edits_of(const std::string& program) { return "edits/" + program; }

enum class Entry { nothing, program, other };

struct Look {
  Entry entry = Entry::nothing;
  std::uint64_t bytes = 0;
  std::int64_t modified_ms = 0;
};

// Does not follow a link.
Look look_at(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return {};
  if (!S_ISREG(status.st_mode)) return {Entry::other};
  return {Entry::program, static_cast<std::uint64_t>(status.st_size),
          std::int64_t{status.st_mtim.tv_sec} * 1000 + status.st_mtim.tv_nsec / 1'000'000};
}

std::int64_t now_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

Outcome<std::string> read_whole(const std::string& path, std::uint64_t most) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return disk(path + ": " + std::strerror(errno));
  std::string text;
  constexpr std::size_t kPiece = 1 << 16;
  while (text.size() <= most) {
    const std::size_t size = text.size();
    text.resize(size + kPiece);
    const ssize_t count = ::read(descriptor, text.data() + size, kPiece);
    text.resize(size + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count <= 0) break;
  }
  ::close(descriptor);
  return text;
}

template <typename Work>
auto guarded(Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const DatabaseError& error) {
    return disk("the revisions cannot be kept: " + error.message);
  }
}

}  // namespace

Outcome<std::unique_ptr<Library>> Library::open(const std::string& folder,
                                                const std::string& database) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return disk(folder + ": " + error.message());
  remove_unfinished(folder);
  try {
    return std::unique_ptr<Library>(new Library(folder, std::make_unique<Revisions>(database)));
  } catch (const DatabaseError& failed) {
    return disk(failed.message);
  }
}

Outcome<std::vector<ProgramInfo>> Library::programs() const {
  std::vector<ProgramInfo> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    const Look look = look_at(entry.path().string());
    if (look.entry == Entry::program && check_program_name(name))
      found.push_back({name, look.bytes, look.modified_ms});
  }
  if (error) return disk(folder_ + ": " + error.message());
  std::sort(found.begin(), found.end(),
            [](const ProgramInfo& a, const ProgramInfo& b) { return a.name < b.name; });
  return found;
}

Outcome<std::string> Library::path_of(const std::string& name) const {
  if (auto checked = check_program_name(name); !checked) return tl::unexpected(checked.error());
  const std::string path = join(name);
  switch (look_at(path).entry) {
    case Entry::program: return path;
    case Entry::nothing:
      return tl::unexpected(base::refuse(base::Refusal::no_library_program, {name}));
    case Entry::other: return refused(base::Refusal::no_file, {name});
  }
  return path;
}

Outcome<std::string> Library::read(const std::string& name) const {
  auto path = path_of(name);
  if (!path) return path;
  if (look_at(*path).bytes > kMostReadBytes)
    return usage(name + " is larger than 4 MiB; fetch it with GET /library/" + name);
  return read_whole(*path, kMostReadBytes);
}

Outcome<std::string> Library::read_revision(const std::string& name, std::int64_t number) {
  if (auto checked = check_program_name(name); !checked) return tl::unexpected(checked.error());
  return guarded([&]() -> Outcome<std::string> {
    auto text = revisions_->text(name, number);
    if (!text) return refused(base::Refusal::no_revision, {name, std::to_string(number)});
    if (text->size() > kMostReadBytes) return refused(base::Refusal::revision_large, {name});
    return std::move(*text);
  });
}

Outcome<std::vector<Revision>> Library::revisions(const std::string& name) {
  if (auto checked = check_program_name(name); !checked) return tl::unexpected(checked.error());
  return guarded([&]() -> Outcome<std::vector<Revision>> {
    Transaction looking = revisions_->begin();
    take_over(name);
    looking.commit();
    auto found = revisions_->of(name);
    if (found.empty())
      return tl::unexpected(base::refuse(base::Refusal::no_library_program, {name}));
    return found;
  });
}

Outcome<void> Library::check_room_for(const std::string& name) const {
  if (auto checked = check_program_name(name); !checked) return checked;
  switch (look_at(join(name)).entry) {
    case Entry::program: return {};
    case Entry::other: return refused(base::Refusal::no_file, {name});
    case Entry::nothing: break;
  }
  const auto all = programs();
  if (!all) return tl::unexpected(all.error());
  if (all->size() < kMostPrograms) return {};
  return refused(base::Refusal::library_full, {std::to_string(kMostPrograms)});
}

// What stands on the disk, if it is not the newest revision: someone has changed the file.
void Library::take_over(const std::string& name) {
  const Look look = look_at(join(name));
  if (look.entry != Entry::program) return;
  const auto newest = revisions_->newest(name);
  if (newest && newest->bytes == look.bytes && look.bytes > Revisions::kMostText) return;
  if (look.bytes > Revisions::kMostText) {
    revisions_->add(name, {}, look.bytes, look.modified_ms);
    return;
  }
  const auto text = read_whole(join(name), Revisions::kMostText);
  if (!text) return;
  if (newest && revisions_->text(name, newest->number) == *text) return;
  revisions_->add(name, *text, text->size(), look.modified_ms);
}

// The bytes of `path` are a revision of the program from now on.
Outcome<Revision> Library::note(const std::string& name, const std::string& path) {
  const Look look = look_at(path);
  if (look.bytes > Revisions::kMostText) return revisions_->add(name, {}, look.bytes, now_ms());
  const auto text = read_whole(path, Revisions::kMostText);
  if (!text) return tl::unexpected(text.error());
  return revisions_->add(name, *text, look.bytes, now_ms());
}

Outcome<Revision> Library::write(const std::string& name, const std::string& text) {
  auto file = begin_upload(name);
  if (!file) return tl::unexpected(file.error());
  (*file)->write(text);
  return finish_upload(name, **file);
}

Outcome<std::unique_ptr<base::OutputFile>> Library::begin_upload(const std::string& name) const {
  if (auto room = check_room_for(name); !room) return tl::unexpected(room.error());
  return base::OutputFile::create(join(name));
}

// Whatever can fail comes before the file gets its name. A crash in between leaves a revision that
// the file has never been; the next look at it takes the file over as the newest one.
Outcome<Revision> Library::finish_upload(const std::string& name, base::OutputFile& upload) {
  return guarded([&]() -> Outcome<Revision> {
    if (auto room = check_room_for(name); !room) return tl::unexpected(room.error());
    constexpr auto kDurable = base::OutputFile::Durability::survives_power_loss;
    if (auto ready = upload.prepare(kDurable); !ready) return tl::unexpected(ready.error());
    Transaction saving = revisions_->begin();
    take_over(name);
    auto made = note(name, upload.written_to());
    if (!made) return made;
    saving.commit();
    if (auto done = upload.commit(kDurable); !done) {
      revisions_->take_back(name, made->number);
      return tl::unexpected(done.error());
    }
    return made;
  });
}

Outcome<void> Library::rename(const std::string& from, const std::string& to) {
  auto path = path_of(from);
  if (!path) return tl::unexpected(path.error());
  if (auto checked = check_program_name(to); !checked) return checked;
  return guarded([&]() -> Outcome<void> {
    Transaction renaming = revisions_->begin();
    take_over(from);
    // Unlike rename(), link() does not replace what is there already.
    if (::link(path->c_str(), join(to).c_str()) != 0) {
      if (errno == EEXIST) return tl::unexpected(base::refuse(base::Refusal::program_exists, {to}));
      return disk(to + ": " + std::strerror(errno));
    }
    try {
      revisions_->rename(from, to);
      revisions_->rename(set_up_of(from), set_up_of(to));
      revisions_->rename(edits_of(from), edits_of(to));
      renaming.commit();
    } catch (const DatabaseError&) {
      ::unlink(join(to).c_str());
      throw;
    }
    if (::unlink(path->c_str()) != 0) return disk(from + ": " + std::strerror(errno));
    return base::sync_folder(folder_);
  });
}

Outcome<void> Library::remove(const std::string& name) {
  auto path = path_of(name);
  if (!path) return tl::unexpected(path.error());
  return guarded([&]() -> Outcome<void> {
    Transaction removing = revisions_->begin();
    take_over(name);
    removing.commit();
    if (::unlink(path->c_str()) != 0) return disk(name + ": " + std::strerror(errno));
    return base::sync_folder(folder_);
  });
}

Outcome<std::string> Library::set_up(const std::string& name) {
  if (auto checked = check_program_name(name); !checked) return tl::unexpected(checked.error());
  return guarded([&]() -> Outcome<std::string> {
    const auto newest = revisions_->newest(set_up_of(name));
    return newest ? revisions_->text(set_up_of(name), newest->number).value_or("") : "";
  });
}

Outcome<void> Library::keep_set_up(const std::string& name, const std::string& toml) {
  if (auto checked = check_program_name(name); !checked) return checked;
  return guarded([&]() -> Outcome<void> {
    Transaction saving = revisions_->begin();
    revisions_->add(set_up_of(name), toml, toml.size(), now_ms());
    saving.commit();
    return {};
  });
}

// The report comes first: a text whose edit cannot be taken back is worse than a report of none.
Outcome<Revision> Library::write_edited(const std::string& name, const std::string& text,
                                        const std::string& report) {
  return guarded([&]() -> Outcome<Revision> {
    Transaction keeping = revisions_->begin();
    const Revision kept = revisions_->add(edits_of(name), report, report.size(), now_ms());
    keeping.commit();
    auto made = write(name, text);
    if (!made) revisions_->take_back(edits_of(name), kept.number);
    return made;
  });
}

Outcome<std::optional<Library::KeptEdit>> Library::last_edit(const std::string& name) {
  using Kept = std::optional<KeptEdit>;
  return guarded([&]() -> Outcome<Kept> {
    const std::vector<Revision> all = revisions_->of(edits_of(name));
    if (all.empty()) return Kept();
    auto report = revisions_->text(edits_of(name), all.front().number);
    if (!report) return Kept();
    return Kept({all.front().number, std::move(*report), all.size() - 1});
  });
}

Outcome<Revision> Library::write_unedited(const std::string& name, const std::string& text,
                                          const KeptEdit& edit) {
  auto made = write(name, text);
  if (!made) return made;
  return guarded([&]() -> Outcome<Revision> {
    revisions_->take_back(edits_of(name), edit.number);
    return made;
  });
}

}  // namespace kerf::server
