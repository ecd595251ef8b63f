#pragma once

#include <toml++/toml.h>

#include <span>
#include <string>
#include <string_view>

#include "machine/definition/internal/machine_keys.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::machine {

/// Turns the tables of one machine file into a definition. Each failure (input) names the line.
class MachineReader {
 public:
  /// Both must outlive the reader.
  MachineReader(const toml::table& file, const std::string& source)
      : file_(file), source_(source) {}

  [[nodiscard]] base::Outcome<MachineDefinition> read();

 private:
  using Outcome = base::Outcome<void>;

  [[nodiscard]] tl::unexpected<base::Failure> wrong(const toml::node* node,
                                                    const std::string& what) const;
  Outcome read_head();
  Outcome read_linkage();
  Outcome read_axes();
  Outcome read_axis(const toml::table& table);
  Outcome read_name(const toml::table& table, DrivenAxis& axis) const;
  Outcome read_axis_item(const std::string& key, const toml::node& node, DrivenAxis& axis) const;
  Outcome read_codes();
  Outcome read_tables();
  Outcome read_item(std::string_view table, const std::string& key, const toml::node& node);
  Outcome read_control();
  Outcome read_tools();
  Outcome read_parameter(const std::string& key, const toml::node& node);
  static void halve_places(DrivenAxis& axis);
  Outcome read_flag(const toml::node& node, const std::string& key, bool& flag) const;
  Outcome read_travel(const toml::node& node, DrivenAxis& axis) const;
  Outcome read_numbers(const toml::node& node, const std::string& key,
                       std::span<double> into) const;
  template <typename Owner>
  Outcome read_value(const Key<Owner>& key, const toml::node& node, Owner& owner) const;
  Outcome read_gas(const toml::node& node);
  Outcome read_point(const PointKey& key, const std::string& name, const toml::node& node);
  Outcome finish();

  const toml::table& file_;
  const std::string& source_;
  MachineDefinition machine_;
};

}  // namespace kerf::machine
