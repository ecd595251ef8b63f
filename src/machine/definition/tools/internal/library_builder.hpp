#pragma once

#include <optional>
#include <string>

#include "machine/definition/tools/tool_import.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::machine {

inline constexpr double kMmPerInch = 25.4;
inline constexpr std::size_t kMostImportedTools = 100000;

/// Collects the tools of a library, and what was not understood of them.
class LibraryBuilder {
 public:
  /// Takes a tool that has a shape, or a length. What its heights contradict is forgotten and told;
  /// a tool without a shape is told.
  void add(stock::Tool tool);
  void remark(int number, std::string text);
  [[nodiscard]] bool is_full() const { return library_.tools.size() >= kMostImportedTools; }
  [[nodiscard]] ToolLibrary take() { return std::move(library_); }

 private:
  bool forget_contradiction(stock::Tool& tool, const std::string& objection);

  ToolLibrary library_;
  std::vector<int> numbers_;  ///< sorted
};

void set_type(stock::Tool& tool, std::string_view type);

/// Sets a measure where there is a value that its row takes and, but for the common ones, the kind
/// of the tool has such a key.
void set_where_fit(stock::Tool& tool, stock::Measure measure, std::optional<double> value);

/// Readers of the formats. Failure (input): the whole file is of no use.
[[nodiscard]] base::Outcome<ToolLibrary> read_linuxcnc(const std::string& text, ToolsUnit unit);
[[nodiscard]] base::Outcome<ToolLibrary> read_fusion(const std::string& text,
                                                     const std::string& path);
[[nodiscard]] base::Outcome<ToolLibrary> read_freecad(const std::string& text,
                                                      const std::string& path);

[[nodiscard]] tl::unexpected<base::Failure> unreadable(const std::string& path,
                                                       const std::string& why);

}  // namespace kerf::machine
