#include "expectations.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace kerf::test {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    const std::string part = trimmed(text.substr(begin, end - begin));
    if (!part.empty()) parts.push_back(part);
    begin = end + 1;
  }
  return parts;
}

bool take(std::string& text, const std::string& prefix) {
  if (text.rfind(prefix, 0) != 0) return false;
  text = trimmed(text.substr(prefix.size()));
  return true;
}

std::optional<double> number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// "#100=1" and "x=1"
bool names_variable(const std::string& text) {
  const std::string name = trimmed(text.substr(0, text.find('=')));
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return name.size() < text.size() &&
         (name.starts_with("#") ||
          (!name.empty() && std::all_of(name.begin(), name.end(), is_letter)));
}

std::vector<std::string> moves(const std::string& text) {
  return text == "none" ? std::vector<std::string>{} : split(text, ';');
}

class Reader {
 public:
  Expectations read(const std::string& text);

 private:
  void comment(std::string body, std::uint32_t line);
  void expect(std::string body, std::uint32_t line);
  void finally(std::string body);
  void alarm(std::string body, std::uint32_t line);
  void variables(const std::string& body, std::vector<WantedVariable>& into);
  void positions(const std::string& body, std::vector<WantedPosition>& into);
  void warning(std::string body, std::uint32_t line);
  void counts(const std::string& body);
  void mistake(const std::string& body) { result_.mistakes.push_back(body); }

  Expectations result_;
};

// Lines are counted as the control counts them: LF, CR…CR LF, or a CR alone.
Expectations Reader::read(const std::string& text) {
  std::uint32_t line = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool line_feed = text[i] == '\n';
    const bool lone_return =
        text[i] == '\r' && (i + 1 == text.size() || (text[i + 1] != '\n' && text[i + 1] != '\r'));
    if (line_feed || lone_return) ++line;
    if (text[i] != '(') continue;
    const std::size_t close = text.find_first_of(")\r\n", i);
    if (close == std::string::npos || text[close] != ')') continue;
    i = text.rfind('(', close);  // a bracket that the program leaves open is no comment
    comment(trimmed(text.substr(i + 1, close - i - 1)), line);
    i = close;
  }
  return result_;
}

void Reader::comment(std::string body, std::uint32_t line) {
  if (take(body, "run with:")) {
    result_.options = split(body, ' ');
  } else if (take(body, "with input:")) {
    result_.input = split(body, ',');
  } else if (take(body, "expect ")) {
    ++result_.count;
    expect(body, line);
  } else if (take(body, "finally ")) {
    ++result_.count;
    finally(body);
  }
}

void Reader::expect(std::string body, std::uint32_t line) {
  if (take(body, "moves:")) {
    result_.moves_of_line[line] = moves(body);
  } else if (take(body, "alarm ")) {
    alarm(body, line);
  } else if (take(body, "assumed:")) {
    result_.assumed_in_line[line] = body;
  } else if (take(body, "warning ")) {
    warning(body, line);
  } else if (names_variable(body)) {
    variables(body, result_.variables_after_line[line]);
  } else {
    mistake(body);
  }
}

void Reader::finally(std::string body) {
  if (take(body, "machine ")) {
    positions(body, result_.machine);
  } else if (take(body, "work ")) {
    positions(body, result_.work);
  } else if (take(body, "status ")) {
    result_.status = body;
  } else if (take(body, "prints ")) {
    result_.prints.push_back(body);
  } else if (take(body, "moves:")) {
    result_.moves = moves(body);
  } else if (body == "assumed: none") {
    result_.nothing_assumed = true;
  } else if (take(body, "records:")) {
    result_.records = split(body, ';');
  } else if (take(body, "alarm ")) {
    alarm(body, 0);
  } else if (take(body, "counts ")) {
    counts(body);
  } else if (take(body, "lines of ")) {
    result_.lines_mm = number(body);
  } else if (take(body, "printed ")) {
    result_.printed = body;
  } else if (names_variable(body)) {
    variables(body, result_.variables);
  } else {
    mistake(body);
  }
}

// NUMBER [at TEXT]
void Reader::warning(std::string body, std::uint32_t line) {
  WantedWarning wanted{body.substr(0, body.find(' ')), line, {}};
  body = trimmed(body.substr(wanted.number.size()));
  if (take(body, "at ")) {
    wanted.at = body;
  } else if (!body.empty()) {
    mistake(body);
  }
  result_.warnings.push_back(wanted);
}

// KIND N, …
void Reader::counts(const std::string& body) {
  for (const std::string& part : split(body, ',')) {
    const std::size_t blank = part.find(' ');
    const auto count = number(blank == std::string::npos ? "" : part.substr(blank + 1));
    if (!count) return mistake(part);
    result_.counts[part.substr(0, blank)] = static_cast<std::size_t>(*count);
  }
}

// NUMBER [line N] [column N] [at TEXT] [says TEXT]
void Reader::alarm(std::string body, std::uint32_t line) {
  WantedAlarm wanted;
  wanted.line = line;
  wanted.number = body.substr(0, body.find(' '));
  body = trimmed(body.substr(wanted.number.size()));
  if (take(body, "line ")) {
    const std::string digits = body.substr(0, body.find(' '));
    wanted.line = static_cast<std::uint32_t>(number(digits).value_or(0));
    body = trimmed(body.substr(digits.size()));
  }
  if (take(body, "column ")) {
    const std::string digits = body.substr(0, body.find(' '));
    wanted.column = static_cast<std::uint32_t>(number(digits).value_or(0));
    body = trimmed(body.substr(digits.size()));
  }
  if (take(body, "at ")) {
    wanted.at = body;
  } else if (take(body, "says ")) {
    wanted.says = body;
  } else if (!body.empty()) {
    mistake(body);
  }
  result_.alarm = wanted;
}

void Reader::variables(const std::string& body, std::vector<WantedVariable>& into) {
  for (const std::string& part : split(body, ',')) {
    const std::size_t equals = part.find('=');
    const std::string value = equals == std::string::npos ? "" : part.substr(equals + 1);
    const auto parsed = number(value);
    if (names_variable(part) && (parsed || value == "null")) {
      into.push_back({part.substr(0, equals), parsed});
    } else {
      mistake(part);
    }
  }
}

void Reader::positions(const std::string& body, std::vector<WantedPosition>& into) {
  for (const std::string& part : split(body, ' ')) {
    const auto value = number(part.substr(1));
    if (value) {
      into.push_back({part[0], *value});
    } else {
      mistake(part);
    }
  }
}

}  // namespace

Expectations read_expectations(const std::string& text) { return Reader().read(text); }

bool is_program(const std::filesystem::path& path) {
  return path.extension() == ".nc" || path.extension() == ".tch" || path.extension() == ".bas";
}

std::function<std::optional<std::string>()> reader_of(std::vector<std::string> lines) {
  return [lines = std::move(lines), next = std::size_t{0}]() mutable {
    return next < lines.size() ? std::optional(lines[next++]) : std::nullopt;
  };
}

}  // namespace kerf::test
