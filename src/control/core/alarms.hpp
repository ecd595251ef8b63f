#pragma once

#include <optional>
#include <string>
#include <utility>

#include "base/diagnostic.hpp"
#include "lang/vm/code_page.hpp"

namespace kerf::control {

/// Tells where the program stands: the place of what is executing, and the program's name.
class Whereabouts {
 public:
  virtual ~Whereabouts() = default;
  [[nodiscard]] virtual base::Place place() = 0;
  [[nodiscard]] virtual base::BlockId block() = 0;
  [[nodiscard]] virtual std::string program_name() const = 0;
  /// "called from line 5 of O0001", from the nearest caller to the main program; empty there.
  [[nodiscard]] virtual std::string callers() = 0;
};

/// The alarm of a machine. The first one counts: it stops the program.
class Alarms {
 public:
  explicit Alarms(Whereabouts& where) : where_(where) {}

  /// Raise an alarm at the executing block, at a text of its line, or at a remembered place. Always
  /// false, so that a check reads `return alarms.raise(…)`.
  bool raise(base::Code code, const std::string& detail = {}, const std::string& hint = {}) {
    return report(base::make_error(code, where_.place(), detail, hint));
  }
  bool raise(base::Code code, const vm::Span& text, const std::string& detail = {},
             const std::string& hint = {}) {
    base::Place place = where_.place();
    place.column = text.column;
    place.length = text.length;
    return report(base::make_error(code, place, detail, hint));
  }
  bool raise_at(base::Code code, const base::Place& place, const std::string& detail = {},
                const std::string& hint = {}) {
    return report(base::make_error(code, place, detail, hint));
  }
  /// Of a motion that waited: at its block.
  bool raise_at(base::Code code, const base::Place& place, const base::BlockId& block,
                const std::string& detail) {
    base::Diagnostic diagnostic = base::make_error(code, place, detail);
    diagnostic.block = block;
    return report(std::move(diagnostic));
  }
  bool report(base::Diagnostic diagnostic) {
    if (alarm_) return false;
    if (diagnostic.block.line == 0) diagnostic.block = where_.block();
    if (diagnostic.program.empty()) diagnostic.program = where_.program_name();
    const std::string callers = where_.callers();
    if (!callers.empty()) diagnostic.hint += (diagnostic.hint.empty() ? "" : "; ") + callers;
    alarm_ = std::move(diagnostic);
    return false;
  }

  /// The place of what is executing, for alarms that may come later.
  [[nodiscard]] base::Place place() { return where_.place(); }
  [[nodiscard]] const std::optional<base::Diagnostic>& alarm() const { return alarm_; }
  void clear() { alarm_.reset(); }

 private:
  Whereabouts& where_;
  std::optional<base::Diagnostic> alarm_;
};

}  // namespace kerf::control
