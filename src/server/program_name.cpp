#include "server/program_name.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/refusal.hpp"
#include "output/diagnostic_text.hpp"

namespace kerf::server {
namespace {

constexpr std::size_t kLongestProgram = 100;
constexpr std::size_t kLongestMachine = 32;
constexpr std::string_view kForbidden = "/\\:*?\"<>|";

using base::Refusal;

tl::unexpected<base::Failure> wrong(const std::string& message) {
  return tl::unexpected(base::Failure{base::Failure::Kind::usage, message});
}
tl::unexpected<base::Failure> wrong(Refusal refusal, std::vector<std::string> values = {}) {
  return tl::unexpected(base::refuse(refusal, std::move(values)));
}

bool at_an_end(const std::string& name, char c) { return name.front() == c || name.back() == c; }

}  // namespace

base::Outcome<void> check_program_name(const std::string& name) {
  if (name.empty()) return wrong(Refusal::program_name_missing);
  if (name.size() > kLongestProgram)
    return wrong(Refusal::program_name_long, {std::to_string(name.size())});
  const std::string shown = output::printable(name);
  if (shown != name) return wrong("the name " + shown + " has characters that are no text");
  const std::size_t bad = name.find_first_of(kForbidden);
  if (bad != std::string::npos)
    return wrong(Refusal::program_name_character, {shown, std::string(1, name[bad])});
  if (at_an_end(name, '.') || at_an_end(name, ' '))
    return wrong(Refusal::program_name_ends, {shown});
  return {};
}

base::Outcome<void> check_machine_name(const std::string& name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  if (name.empty() || name.size() > kLongestMachine || !std::all_of(name.begin(), name.end(), fits))
    return wrong(Refusal::machine_name);
  return {};
}

}  // namespace kerf::server
