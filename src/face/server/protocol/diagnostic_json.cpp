#include "face/server/protocol/diagnostic_json.hpp"

#include <filesystem>

#include "output/writing/diagnostic_text.hpp"

namespace kerf::server {

std::string file_label(const std::string& path) {
  return output::printable(std::filesystem::path(path).filename().string());
}

Json diagnostic_json(const base::Diagnostic& diagnostic, const base::SourceSet& sources) {
  Json json;
  json["severity"] = output::severity_name(diagnostic.severity);
  json["code"] = diagnostic.number;
  json["message"] = output::printable(diagnostic.message);
  json["file"] = file_label(output::file_name(diagnostic, sources));
  json["line"] = diagnostic.place.line;
  json["column"] = diagnostic.place.column;
  json["length"] = diagnostic.place.length;
  json["program"] = output::printable(diagnostic.program);
  const base::CodeText& text = base::text_of(diagnostic.code);
  json["cause"] = text.cause;
  json["remedy"] =
      diagnostic.hint.empty() ? std::string(text.remedy) : output::printable(diagnostic.hint);
  return json;
}

}  // namespace kerf::server
