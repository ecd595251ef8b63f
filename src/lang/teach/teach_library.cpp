#include "lang/teach/teach_library.hpp"

namespace kerf::teach {

TeachLibrary::TeachLibrary(const base::SourceSet& sources, const vm::PageSettings& settings)
    : sources_(sources),
      settings_(settings),
      compiler_(settings.lines_per_page),
      pages_(settings) {}

void TeachLibrary::load(base::FileId file) {
  file_ = file;
  pages_ = vm::PageStore<TeachPage>(settings_);
  next_page_ = 0;
  next_ = {};
}

TeachPage& TeachLibrary::compile_next(vm::CodeId code) {
  TeachPage& page = pages_.make_room(code, next_page_, false);
  compiler_.compile(sources_[file_], file_, next_, page);
  next_ = page.next;
  ++next_page_;
  return page;
}

// Asked for is the next page, or the first one again.
TeachPage& TeachLibrary::page(vm::CodeId code, std::uint32_t number) {
  if (TeachPage* const kept = pages_.find(code, number)) return *kept;
  if (number < next_page_) {
    next_page_ = 0;
    next_ = {};
  }
  while (next_page_ < number) static_cast<void>(compile_next(code));
  return compile_next(code);
}

std::optional<vm::Address> TeachLibrary::find_label(vm::CodeId /*code*/, vm::Address /*from*/,
                                                    std::uint32_t /*label*/) {
  return std::nullopt;
}

vm::Region TeachLibrary::resolve_region(vm::CodeId /*code*/, std::uint32_t /*page*/,
                                        std::uint32_t /*region*/) {
  return {};
}

void TeachLibrary::check(const std::string& program, base::Findings& found) {
  for (std::uint32_t number = 0; !found.over(); ++number) {
    const TeachPage& current = page(kProgram, number);
    for (base::Diagnostic failure : current.failures) {
      failure.program = program;
      found.add(std::move(failure));
    }
    if (current.last) return;
  }
}

}  // namespace kerf::teach
