#pragma once

#include <optional>
#include <string>
#include <utility>

#include "base/findings.hpp"
#include "lang/vm/page_store.hpp"

namespace kerf::vm {

/// One file as a program without labels and loops, compiled page by page when it is reached. A file
/// of any length runs in the memory of some pages: programs run straight on, so nothing is kept of
/// those that are past.
///
/// `Page` is a CodePage as PageStore wants it, with `bool last`: the file ends with this page.
template <typename Page>
class StraightProgram : public CodeSource {
 public:
  /// Every file is this one program.
  static constexpr CodeId kProgram{0};

  /// The file that is the program from here on.
  void load(base::FileId file) {
    file_ = file;
    pages_ = PageStore<Page>(settings_);
    stand_at_head();
  }
  [[nodiscard]] bool loaded() const { return file_ != base::kNoFile; }
  [[nodiscard]] base::FileId file() const { return file_; }

  /// All mistakes of the file, in the order of its lines.
  void check(const std::string& program, base::Findings& found) {
    for (std::uint32_t number = 0; !found.over(); ++number) {
      const Page& current = page(kProgram, number);
      for (base::Diagnostic failure : current.failures) {
        failure.program = program;
        found.add(std::move(failure));
      }
      if (current.last) return;
    }
  }

  // CodeSource
  /// Asked for is the next page, or the first one again.
  Page& page(CodeId code, std::uint32_t number) override {
    if (Page* const kept = pages_.find(code, number)) return *kept;
    if (number < next_page_) stand_at_head();
    while (next_page_ < number) static_cast<void>(make_next());
    return make_next();
  }
  std::optional<Address> find_label(CodeId /*code*/, Address /*from*/,
                                    std::uint32_t /*label*/) override {
    return std::nullopt;
  }
  Region resolve_region(CodeId /*code*/, std::uint32_t /*page*/,
                        std::uint32_t /*region*/) override {
    return {};
  }

 protected:
  explicit StraightProgram(const PageSettings& settings) : settings_(settings), pages_(settings) {}

  [[nodiscard]] const PageSettings& settings() const { return settings_; }

  /// The page that is compiled next is the first one.
  virtual void rewind() = 0;
  /// Compiles the next page.
  virtual void compile(Page& page) = 0;

 private:
  void stand_at_head() {
    next_page_ = 0;
    rewind();
  }
  Page& make_next() {
    Page& page = pages_.make_room(kProgram, next_page_, false);
    compile(page);
    ++next_page_;
    return page;
  }

  PageSettings settings_;
  PageStore<Page> pages_;
  std::uint32_t next_page_ = 0;  // behind the one that was compiled last
  base::FileId file_ = base::kNoFile;
};

}  // namespace kerf::vm
