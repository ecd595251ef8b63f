#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "output/programs/post_flavour.hpp"

namespace kerf::output {

/// The tools and lengths that a posted program asks its control for. Of bounded size.
class ToolLengths {
 public:
  void use_tool(std::uint32_t tool) { note(tool); }
  void use_offset(std::uint32_t offset, double mm);
  /// As a file of the flavour's control; empty: it has none.
  [[nodiscard]] std::string table(const PostFlavour& flavour) const;

 private:
  static constexpr std::size_t kMost = 1000;

  double* note(std::uint32_t number);

  std::map<std::uint32_t, double> lengths_;  // of tools without one 0
};

}  // namespace kerf::output
