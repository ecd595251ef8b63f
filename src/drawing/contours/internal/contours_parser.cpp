#include "drawing/contours/internal/contours_parser.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/text_window.hpp"

namespace kerf::drawing {
namespace {

/// The bytes of a file one after the other, and where the last one stands.
class Bytes {
 public:
  explicit Bytes(const base::SourceFile& file) : file_(file) {
    fill();
    at_ = size_ - base::without_byte_order_mark({block_.data(), size_}).size();
    if (at_ == size_) fill();
  }

  [[nodiscard]] bool at_end() const { return size_ == 0; }
  [[nodiscard]] char current() const { return block_[at_]; }
  void advance() {
    ++column_;
    if (block_[at_] == '\n') {
      ++line_;
      column_ = 1;
    }
    if (++at_ == size_) fill();
  }
  [[nodiscard]] base::Place place() const { return {base::kNoFile, line_, column_}; }

 private:
  void fill() {
    size_ = file_.read(offset_, block_);
    offset_ += size_;
    at_ = 0;
  }

  const base::SourceFile& file_;
  std::array<char, 1 << 15> block_{};
  std::size_t size_ = 0;
  std::size_t at_ = 0;
  std::uint64_t offset_ = 0;
  std::uint32_t line_ = 1;
  std::uint32_t column_ = 1;
};

/// As the parser wants its input: two of them, of which the second has no bytes.
class ByteIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  explicit ByteIterator(Bytes* bytes) : bytes_(bytes) {}
  char operator*() const { return bytes_->current(); }
  ByteIterator& operator++() {
    bytes_->advance();
    return *this;
  }
  ByteIterator operator++(int) {
    bytes_->advance();
    return *this;
  }
  friend bool operator==(const ByteIterator& a, const ByteIterator& b) {
    return a.ends() == b.ends();
  }
  friend bool operator!=(const ByteIterator& a, const ByteIterator& b) { return !(a == b); }

 private:
  [[nodiscard]] bool ends() const { return bytes_ == nullptr || bytes_->at_end(); }
  Bytes* bytes_;
};

std::optional<Colour> colour_in(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::uint32_t value = 0;
  for (const char c : text.substr(1)) {
    const auto digit = std::string_view("0123456789abcdef")
                           .find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
    if (digit == std::string_view::npos) return std::nullopt;
    value = 16 * value + static_cast<std::uint32_t>(digit);
  }
  return Colour{value};
}

/// Takes what the parser finds. Each function returns whether it goes on.
class Taker : public nlohmann::json_sax<nlohmann::json> {
 public:
  Taker(const Bytes& bytes, ContoursFile& file) : bytes_(bytes), file_(file) {}

  bool null() override { return take_other("null"); }
  bool boolean(bool value) override;
  bool number_integer(number_integer_t value) override {
    return take_number(static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return take_number(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t& /*text*/) override {
    return take_number(value);
  }
  bool string(string_t& text) override;
  bool binary(binary_t& /*bytes*/) override { return true; }
  bool start_object(std::size_t /*members*/) override;
  bool end_object() override;
  bool key(string_t& name) override {
    key_ = name;
    return true;
  }
  bool start_array(std::size_t /*items*/) override;
  bool end_array() override;
  bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                   const nlohmann::json::exception& /*error*/) override {
    return refuse("there is no JSON from here on");
  }

 private:
  /// What the innermost bracket is of; `passed` of something that is passed over.
  enum class In : std::uint8_t { file, layers, layer, contours, contour, points, point, passed };

  bool refuse(const std::string& what) {
    if (!file_.fault) file_.fault = {bytes_.place(), what};
    return false;
  }
  bool take_other(std::string_view what);
  bool take_number(double value);
  [[nodiscard]] bool is_in(In what) const { return !in_.empty() && in_.back() == what; }
  [[nodiscard]] bool is_member(In of, std::string_view name) const {
    return is_in(of) && key_ == name;
  }
  void leave() {
    in_.pop_back();
    key_.clear();
  }
  bool finish_point();
  bool finish_contour();
  ContoursFile::Layer& layer() { return file_.layers.back(); }

  const Bytes& bytes_;
  ContoursFile& file_;
  std::vector<In> in_;
  std::string key_;
  contour::Contour contour_;
  std::uint32_t line_ = 0;
  std::array<double, 3> point_{};
  std::size_t numbers_ = 0;
};

/// A value where a certain other one should be, or one that nobody asks for.
bool Taker::take_other(std::string_view what) {
  if (in_.empty()) return refuse("an object is expected");
  if (is_in(In::layers) || is_in(In::contours))
    return refuse(fmt::format("an object is expected, and here is {}", what));
  if (is_in(In::points)) return refuse(fmt::format("[x, y, bulge] is expected, not {}", what));
  if (is_in(In::point)) return refuse(fmt::format("a number is expected, not {}", what));
  const bool is_known = is_member(In::file, "layers") || is_member(In::layer, "contours") ||
                        is_member(In::contour, "points") || is_member(In::contour, "closed") ||
                        is_member(In::file, "unit") || is_member(In::layer, "name") ||
                        is_member(In::layer, "colour");
  if (is_known) return refuse(fmt::format("'{}' cannot be {}", key_, what));
  return true;
}

bool Taker::boolean(bool value) {
  if (!is_member(In::contour, "closed")) return take_other("true or false");
  contour_.is_closed = value;
  return true;
}

bool Taker::take_number(double value) {
  if (!is_in(In::point)) return take_other("a number");
  if (numbers_ == point_.size()) return refuse("a point has x, y and a bulge, and no more");
  point_[numbers_++] = value;
  return true;
}

bool Taker::string(string_t& text) {
  if (is_member(In::file, "unit")) {
    file_.unit = text;
  } else if (is_member(In::layer, "name")) {
    layer().layer.name = text;
  } else if (is_member(In::layer, "colour")) {
    const auto colour = colour_in(text);
    if (!colour) return refuse("a colour is #rrggbb");
    layer().layer.colour = *colour;
  } else {
    return take_other("a word");
  }
  return true;
}

bool Taker::start_object(std::size_t /*members*/) {
  if (in_.empty()) {
    in_.push_back(In::file);
  } else if (is_in(In::layers)) {
    in_.push_back(In::layer);
    file_.layers.emplace_back();
  } else if (is_in(In::contours)) {
    in_.push_back(In::contour);
    contour_ = {{}, false};
    line_ = bytes_.place().line;
  } else {
    if (!is_in(In::passed) && !take_other("an object")) return false;
    in_.push_back(In::passed);
  }
  key_.clear();
  return true;
}

bool Taker::end_object() {
  const bool is_contour = is_in(In::contour);
  leave();
  return !is_contour || finish_contour();
}

bool Taker::start_array(std::size_t /*items*/) {
  if (is_member(In::file, "layers")) {
    in_.push_back(In::layers);
  } else if (is_member(In::layer, "contours")) {
    in_.push_back(In::contours);
  } else if (is_member(In::contour, "points")) {
    in_.push_back(In::points);
  } else if (is_in(In::points)) {
    in_.push_back(In::point);
    point_ = {};
    numbers_ = 0;
  } else {
    if (!is_in(In::passed) && !take_other("a list")) return false;
    in_.push_back(In::passed);
  }
  return true;
}

bool Taker::end_array() {
  const bool is_point = is_in(In::point);
  leave();
  return !is_point || finish_point();
}

bool Taker::finish_point() {
  if (numbers_ < 2) return refuse("a point has at least x and y");
  contour_.vertices.push_back({{point_[0], point_[1]}, point_[2]});
  return true;
}

bool Taker::finish_contour() {
  if (contour_.vertices.empty()) return refuse("a contour has no points");
  layer().layer.contours.push_back(std::move(contour_));
  layer().lines.push_back(line_);
  return true;
}

}  // namespace

ContoursFile parse_contours(const base::SourceFile& file) {
  ContoursFile result;
  Bytes bytes(file);
  Taker taker(bytes, result);
  nlohmann::json::sax_parse(ByteIterator(&bytes), ByteIterator(nullptr), &taker);
  return result;
}

}  // namespace kerf::drawing
