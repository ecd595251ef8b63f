#include "output/features/internal/feature_members.hpp"
#include "output/features/internal/json_values.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

std::string affects_json(const features::Argument& argument) {
  if (!argument.affects) return "null";
  std::vector<std::string> words;
  for (const std::string& word : *argument.affects) words.push_back(quoted(word));
  return json_array(words);
}

std::string argument_json(const features::Argument& argument) {
  return JsonObject()
      .text("letter", argument.letter)
      .raw("variable", argument.variable == 0 ? "null" : rounded(argument.variable))
      .raw("value", rounded_or_null(argument.value))
      .text("text", argument.text)
      .raw("literal", argument.literal ? "true" : "false")
      .raw("column", rounded(argument.column))
      .raw("affects", affects_json(argument))
      .done();
}

}  // namespace

std::string call_json(const FeatureFacts& facts, std::size_t place) {
  const features::Call& call = facts.tree->calls[place];
  std::vector<std::string> arguments;
  for (const features::Argument& argument : call.words.arguments)
    arguments.push_back(argument_json(argument));
  std::vector<std::string> made;
  for (const std::size_t feature : call.features) made.push_back(id_of("F", feature));
  for (const std::size_t hole : call.holes) made.push_back(id_of("H", hole));
  JsonObject object;
  object.raw("id", id_of("C", place)).raw("line", rounded(call.line));
  object.raw("column", rounded(call.column)).text("code", call.words.code);
  object.text("program", call.words.program).raw("arguments", json_array(arguments));
  return object.raw("features", json_array(made)).done();
}

}  // namespace kerf::output
