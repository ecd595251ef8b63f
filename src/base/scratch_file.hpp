#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/output_file.hpp"

namespace kerf::base {

/// Bytes of an output that wait for what is to stand before them: a little in memory, more than
/// that in a nameless file beside the output, on the same disk. Nothing is left behind, however the
/// program ends.
///
/// As the output itself it never reports: what does not reach the disk is told by its commit().
class ScratchFile {
 public:
  /// The output must outlive this.
  explicit ScratchFile(OutputFile& output) : output_(output) {}
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  void write(std::string_view bytes);
  [[nodiscard]] std::uint64_t size() const { return on_disk_ + waiting_.size(); }
  /// Writes the bytes [begin, end) to the output. Precondition: begin <= end <= size().
  void copy_to_output(std::uint64_t begin, std::uint64_t end);

 private:
  void open();
  void spill();

  OutputFile& output_;
  std::string waiting_;  // bytes behind those on disk
  std::uint64_t on_disk_ = 0;
  int descriptor_ = -1;  // none until there is much
};

}  // namespace kerf::base
