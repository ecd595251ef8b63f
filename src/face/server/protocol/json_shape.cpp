#include "face/server/protocol/json_shape.hpp"

namespace kerf::server {
namespace {

using namespace json_shape;

// Behind the quote that ends the string that begins at `at`.
std::size_t behind_string(std::string_view json, std::size_t at) {
  for (++at; at < json.size() && json[at] != '"'; ++at) {
    if (json[at] == '\\') ++at;
  }
  return at + 1;
}

}  // namespace

std::optional<std::string> objection_to_shape(std::string_view json) {
  int depth = 0;
  std::size_t values = 1, word = 0;
  for (std::size_t at = 0; at < json.size();) {
    const char c = json[at];
    word = std::string_view("[]{},:\" \t\r\n").find(c) == std::string_view::npos ? word + 1 : 0;
    if (word > kMostWordBytes)
      return "a number of a command has at most " + std::to_string(kMostWordBytes) + " characters";
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > kMostDepth)
      return "brackets of a command stand at most " + std::to_string(kMostDepth) +
             " deep in each other";
    if (c == ',' || c == '[' || c == '{') ++values;
    if (values > kMostValues)
      return "a command has at most " + std::to_string(kMostValues) + " values";
    at = c == '"' ? behind_string(json, at) : at + 1;
  }
  return std::nullopt;
}

}  // namespace kerf::server
