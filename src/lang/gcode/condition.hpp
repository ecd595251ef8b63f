#pragma once

#include <memory>
#include <string>

#include "base/result.hpp"
#include "lang/gcode/name_table.hpp"
#include "lang/gcode/page.hpp"

namespace kerf::gcode {

/// Compiles a comparison, in brackets or not ("#1 GT 5", "[#1GT5]AND[#2EQ0]"), for vm::Evaluation.
/// Otherwise what is wrong with it.
[[nodiscard]] base::Result<std::unique_ptr<GcodePage>> compile_condition(const std::string& text,
                                                                         NameTable& names);

}  // namespace kerf::gcode
