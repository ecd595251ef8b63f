#pragma once

#include <toml++/toml.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "process/keys.hpp"
#include "process/recipe_file.hpp"

namespace kerf::process {

/// What a key has no place for: JOB_KEY with the nearest name, or with the processes that take it.
[[nodiscard]] base::Diagnostic unknown_key(KeyTable table, std::string_view name, Process process,
                                           const base::Place& place);
[[nodiscard]] base::Diagnostic wrong_value(const JobKey& key, const toml::node& node,
                                           const base::Place& place);
/// Whether `key` is there and, of an operation, whether its process takes it.
[[nodiscard]] bool is_taken(const JobKey* key, Process process);

/// Reads the tables of a job file into a recipe, and keeps in mind where each key stands.
class RecipeReader {
 public:
  RecipeReader(const std::string& text, base::FileId file);

  void read(const toml::table& file, Recipe& recipe);
  /// Of a file of materials.
  void read_materials(const toml::table& file, std::vector<Material>& materials);
  void tell(base::Diagnostic diagnostic) { found_.push_back(std::move(diagnostic)); }
  [[nodiscard]] base::Place place_of(const toml::source_region& source) const;
  /// Of a key that read() has met, else of the table that it would be in.
  [[nodiscard]] base::Place place_of(const std::string& path) const;
  /// In the order of their lines.
  [[nodiscard]] Diagnostics findings();

 private:
  void read_root(const toml::key& name, const toml::node& node, Recipe& recipe);
  void read_material(const toml::node& node, Material& material);
  void read_text(const toml::node& node, TextWords& text);
  void read_lines(const toml::node& node, std::vector<TextLine>& lines);
  void read_operations(const toml::node& node, std::vector<Operation>& operations);
  void read_operation(const toml::node& node, Operation& operation, const std::string& path);
  void read_table(const toml::node& node, KeyTable table, const KeyOwner& owner,
                  const std::string& path, Process process = Process::engrave);
  void read_key(const toml::key& name, const toml::node& node, KeyTable table,
                const KeyOwner& owner, const std::string& path, Process process);
  /// The tables of [[name]], or none and a finding.
  [[nodiscard]] std::vector<const toml::node*> tables_in(const toml::node& node,
                                                         std::string_view title, std::size_t most);
  void wrong(const toml::node& node, const std::string& sentence);

  base::FileId file_;
  std::vector<std::uint64_t> line_starts_{0};
  std::map<std::string, base::Place> places_;
  Diagnostics found_;
};

}  // namespace kerf::process
