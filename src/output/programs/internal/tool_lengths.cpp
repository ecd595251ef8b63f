#include "output/programs/internal/tool_lengths.hpp"

#include "output/programs/internal/block_text.hpp"

namespace kerf::output {

double* ToolLengths::note(std::uint32_t number) {
  if (number == 0 || (lengths_.size() >= kMost && !lengths_.contains(number))) return nullptr;
  return &lengths_[number];
}

void ToolLengths::use_offset(std::uint32_t offset, double mm) {
  if (double* const length = note(offset)) *length = mm;
}

std::string ToolLengths::table(const PostFlavour& flavour) const {
  if (flavour.lengths != PostFlavour::Lengths::of_table) return {};
  std::string text = flavour.is_framed ? "%\n" : "";
  for (const auto& [number, mm] : lengths_) {
    const std::string name = std::to_string(number);
    const std::string length = post_number(post_rounded(mm));
    text += flavour.is_framed ? "G10 L10 P" + name + " R" + length + "\n"
                              : "T" + name + " P" + name + " Z" + length + "\n";
  }
  return text + (flavour.is_framed ? "%\n" : "");
}

}  // namespace kerf::output
