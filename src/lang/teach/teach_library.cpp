#include "lang/teach/teach_library.hpp"

namespace kerf::teach {

TeachLibrary::TeachLibrary(const base::SourceSet& sources, const vm::PageSettings& settings)
    : StraightProgram(settings), sources_(sources), compiler_(settings.lines_per_page) {}

void TeachLibrary::compile(TeachPage& page) {
  compiler_.compile(sources_[file()], file(), next_, page);
  next_ = page.next;
}

}  // namespace kerf::teach
