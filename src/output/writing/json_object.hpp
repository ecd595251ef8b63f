#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/decimal.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::output {

/// Text as a JSON string.
inline std::string quoted(const std::string& text) {
  return nlohmann::json(printable(text)).dump();
}

/// Values, each as JSON, as an array of them.
inline std::string json_array(const std::vector<std::string>& items) {
  std::string list = "[";
  for (const std::string& item : items) list += (list.size() > 1 ? "," : "") + item;
  return list + "]";
}

/// Builds a JSON object with our own number format: the fewest digits that read back.
class JsonObject {
 public:
  JsonObject& text(const char* key, const std::string& value) { return raw(key, quoted(value)); }
  JsonObject& number(const std::string& key, double value) {
    return raw(key, base::number_text(value));
  }
  JsonObject& raw(const std::string& key, const std::string& value) {
    out_ += out_.empty() ? "{" : ",";
    out_ += "\"" + key + "\":" + value;
    return *this;
  }
  [[nodiscard]] std::string done() const { return out_.empty() ? "{}" : out_ + "}"; }

 private:
  std::string out_;
};

}  // namespace kerf::output
