#pragma once

#include <string>
#include <string_view>

#include "base/scratch_file.hpp"
#include "output/programs/post_flavour.hpp"

namespace kerf::output {

/// A block as the flavour spells it: G01 for G1.
[[nodiscard]] std::string spelled(const PostFlavour& flavour, std::string_view block);

/// The blocks of a posted program behind its head, which is known only when they are.
class PostBody {
 public:
  /// Both must outlive this.
  PostBody(base::OutputFile& output, const PostFlavour& flavour)
      : flavour_(flavour), file_(output) {}

  /// A line of the file; nothing where it is empty.
  void block(std::string_view text);
  /// What the program says in that line of its source: of 80 bytes at most, as GRBL reads.
  void comment(std::uint32_t line, const std::string& text);
  [[nodiscard]] std::uint64_t size() const { return file_.size(); }
  void copy_to_output(std::uint64_t begin, std::uint64_t end) { file_.copy_to_output(begin, end); }

 private:
  const PostFlavour& flavour_;
  base::ScratchFile file_;
};

}  // namespace kerf::output
