#pragma once

#include <toml++/toml.h>

#include <array>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "control/core/machine_codes.hpp"
#include "motion/spindle_name.hpp"

namespace kerf::machine {

/// Reads the tables [[spindle]], [m_codes] and [g_codes] of a machine file. Each failure (input)
/// names the line.
class MachineCodesReader {
 public:
  /// All must outlive the reader.
  MachineCodesReader(const toml::table& file, const std::string& source,
                     control::MachineCodes& codes,
                     std::array<double, motion::kSpindles>& spindle_kw)
      : file_(file), source_(source), codes_(codes), spindle_kw_(spindle_kw) {}

  [[nodiscard]] base::Outcome<void> read();

 private:
  using Outcome = base::Outcome<void>;

  Outcome read_spindles();
  Outcome read_spindle(const toml::table& table, std::string_view usual_name);
  Outcome read_item(const std::string& key, const toml::node& node,
                    control::SpindleSettings& spindle);
  Outcome read_m_codes();
  Outcome read_function(std::string_view key, const toml::node& node);
  Outcome read_g_codes();
  [[nodiscard]] tl::unexpected<base::Failure> wrong(const toml::node& node,
                                                    const std::string& what) const;

  const toml::table& file_;
  const std::string& source_;
  control::MachineCodes& codes_;
  std::array<double, motion::kSpindles>& spindle_kw_;
};

/// `--machine-set g_codes.G121=G12.1`: the code has this meaning. Why not, or nothing.
[[nodiscard]] std::string change_g_code(control::MachineCodes& codes, std::string_view code,
                                        std::string_view meant);

/// `--machine-set m_codes.KEY=NUMBER,NUMBER…`: the codes of this key are these. Why not, or
/// nothing.
[[nodiscard]] std::string change_m_codes(control::MachineCodes& codes, std::string_view key,
                                         std::string_view text);

}  // namespace kerf::machine
