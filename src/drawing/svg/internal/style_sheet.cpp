#include "drawing/svg/internal/style_sheet.hpp"

#include <algorithm>
#include <optional>

#include "drawing/svg/internal/scanner.hpp"

namespace kerf::drawing::svg {
namespace {

// No drawing program writes more; each element is held against all of them.
constexpr std::size_t kMostCompounds = 32;
constexpr std::size_t kMostSelectors = 20'000;
constexpr std::uint32_t kMostDeclarations = 1000;
constexpr std::size_t kMostClassBytes = 4096;

std::string without_comments(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = std::min(text.find("/*", at), text.size());
    result.append(text.substr(at, begin - at));
    const std::size_t end = text.find("*/", std::min(begin + 2, text.size()));
    at = end == std::string_view::npos ? text.size() : end + 2;
  }
  return result;
}

/// Up to the first of `marks` that stands in no quotes and no brackets.
std::size_t end_of(std::string_view text, std::size_t at, std::string_view marks) {
  int depth = 0;
  char quote = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (depth == 0 && marks.find(c) != std::string_view::npos) {
      return at;
    } else if (c == '(' || c == '{') {
      ++depth;
    } else if ((c == ')' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return text.size();
}

std::optional<Declaration> declaration_of(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  Declaration declaration{key_of(trimmed(text.substr(0, colon))), trimmed(text.substr(colon + 1))};
  if (!is_property(declaration.property)) return std::nullopt;
  const std::size_t mark = declaration.value.rfind('!');
  if (mark == std::string_view::npos) return declaration;
  declaration.is_important = trimmed(declaration.value.substr(mark + 1)) == "important";
  declaration.value = trimmed(declaration.value.substr(0, mark));
  return declaration;
}

template <typename Take>
void each_class(std::string_view classes, Take&& take) {
  classes = classes.substr(0, kMostClassBytes);
  while (!(classes = trimmed(classes)).empty()) {
    const auto end = std::find_if(classes.begin(), classes.end(), is_blank);
    const auto length = static_cast<std::size_t>(end - classes.begin());
    take(classes.substr(0, length));
    classes.remove_prefix(length);
  }
}

bool has_class(std::string_view classes, std::string_view wanted) {
  bool is_there = false;
  each_class(classes, [&](std::string_view name) { is_there = is_there || name == wanted; });
  return is_there;
}

}  // namespace

void append_declarations(std::string_view block, std::vector<Declaration>& declarations) {
  for (std::size_t at = 0; at < block.size();) {
    const std::size_t end = end_of(block, at, ";");
    if (const auto one = declaration_of(block.substr(at, end - at))) declarations.push_back(*one);
    at = end + 1;
  }
}

/// Reads rules into a sheet.
class StyleSheet::Reader {
 public:
  Reader(StyleSheet& sheet, Canvas& canvas) : sheet_(sheet), canvas_(canvas), text_(sheet.text_) {}

  void read() {
    while (skip_between_rules(), at_ < text_.size() && !canvas_.is_over()) {
      if (text_[at_] == '@')
        skip_at_rule();
      else
        read_rule();
    }
  }

 private:
  void skip_between_rules() {
    const auto is_between = [&] {
      return is_blank(text_[at_]) || text_[at_] == '}' || text_[at_] == ';';
    };
    while (at_ < text_.size()) {
      if (is_between())
        ++at_;
      else if (text_.substr(at_, 4) == "<!--")
        at_ += 4;
      else if (text_.substr(at_, 3) == "-->")
        at_ += 3;
      else
        return;
    }
  }

  void skip_at_rule() {
    Scanner in(text_.substr(at_ + 1));
    canvas_.ignore("@" + std::string(in.word().substr(0, 40)), 0,
                   "a rule of a style sheet that begins with @");
    at_ = end_of(text_, at_, ";{");
    if (at_ < text_.size() && text_[at_] == '{') at_ = end_of(text_, at_ + 1, "}");
    at_ = std::min(at_ + 1, text_.size());
  }

  void read_rule() {
    const std::size_t brace = end_of(text_, at_, "{");
    const std::string_view selectors = text_.substr(at_, brace - at_);
    const std::size_t body = std::min(brace + 1, text_.size());
    const std::size_t end = end_of(text_, body, "}");
    const auto first = static_cast<std::uint32_t>(sheet_.declarations_.size());
    append_declarations(text_.substr(body, end - body), sheet_.declarations_);
    const auto all = static_cast<std::uint32_t>(sheet_.declarations_.size()) - first;
    const std::uint32_t count = std::min(all, kMostDeclarations);
    at_ = std::min(end + 1, text_.size());
    if (count > 0) read_selectors(selectors, first, count);
  }

  void read_selectors(std::string_view list, std::uint32_t first, std::uint32_t count) {
    for (std::size_t at = 0; at < list.size();) {
      const std::size_t end = end_of(list, at, ",");
      auto selector = selector_of(list.substr(at, end - at));
      if (selector && sheet_.selectors_.size() < kMostSelectors) {
        selector->first = first;
        selector->count = count;
        sheet_.selectors_.push_back(std::move(*selector));
        sheet_.file(static_cast<std::uint32_t>(sheet_.selectors_.size() - 1));
      } else {
        canvas_.ignore("selector", 0, "a selector of more than types, classes and names");
      }
      at = end + 1;
    }
  }

  static std::optional<Selector> selector_of(std::string_view text) {
    Selector selector;
    Scanner in(trimmed(text));
    bool is_child = false;
    while (!in.is_done()) {
      auto compound = compound_of(in, selector.weight);
      if (!compound || selector.compounds.size() == kMostCompounds) return std::nullopt;
      compound->is_child = is_child;
      selector.compounds.push_back(std::move(*compound));
      in.skip_blanks();
      is_child = in.take('>');
      in.skip_blanks();
    }
    if (selector.compounds.empty() || is_child) return std::nullopt;
    return selector;
  }

  /// Weights: 65536 a name, 256 a class, 1 a type.
  static std::optional<Compound> compound_of(Scanner& in, std::uint32_t& weight) {
    Compound compound;
    const std::size_t from = in.at();
    if (const std::string_view type = in.word(); !type.empty()) {
      compound.has_type = true;
      compound.type = tag_of(type);
      weight += 1;
    } else {
      (void)in.take('*');
    }
    while (in.peek() == '.' || in.peek() == '#') {
      const bool is_class = in.peek() == '.';
      in.advance();
      const std::string_view name = in.word();
      if (name.empty()) return std::nullopt;
      (is_class ? compound.classes : compound.ids).push_back(name);
      weight += is_class ? 0x100 : 0x10000;
    }
    if (in.at() == from) return std::nullopt;
    const bool has_ended = in.is_done() || is_blank(in.peek()) || in.peek() == '>';
    return has_ended ? std::optional(std::move(compound)) : std::nullopt;
  }

  StyleSheet& sheet_;
  Canvas& canvas_;
  std::string_view text_;
  std::size_t at_ = 0;
};

StyleSheet::StyleSheet(std::string_view text, Canvas& canvas) : text_(without_comments(text)) {
  Reader(*this, canvas).read();
}

void StyleSheet::file(std::uint32_t number) {
  const Compound& last = selectors_[number].compounds.back();
  if (!last.ids.empty())
    by_id_[last.ids.front()].push_back(number);
  else if (!last.classes.empty())
    by_class_[last.classes.front()].push_back(number);
  else
    others_.push_back(number);
}

bool StyleSheet::is_one(const Tree& tree, ElementId id, const Compound& compound) {
  if (compound.has_type && tree[id].tag != compound.type) return false;
  for (const std::string_view name : compound.ids)
    if (tree.text(id, Key::id) != name) return false;
  for (const std::string_view name : compound.classes)
    if (!has_class(tree.text(id, Key::class_), name)) return false;
  return true;
}

/// From the root down it is known how many compounds have been met, so no way is tried twice.
bool StyleSheet::matches(const Tree& tree, ElementId id, const Selector& selector) {
  const std::vector<Compound>& compounds = selector.compounds;
  if (!is_one(tree, id, compounds.back())) return false;
  if (compounds.size() == 1) return true;
  std::vector<ElementId> way;
  for (ElementId at = id; at != kNoElement; at = tree[at].parent) way.push_back(at);
  std::uint64_t here = 0;   // bit i: the element just looked at is the one for compound i
  std::uint64_t above = 0;  // bit i: an element above was
  for (auto at = way.rbegin(); at != way.rend(); ++at) {
    std::uint64_t next = 0;
    for (std::size_t i = 0; i < compounds.size(); ++i) {
      const std::uint64_t before = compounds[i].is_child ? here : above;
      const bool may_be = i == 0 || (before >> (i - 1) & 1U) != 0;
      if (may_be && is_one(tree, *at, compounds[i])) next |= std::uint64_t{1} << i;
    }
    here = next;
    above |= next;
  }
  return (here >> (compounds.size() - 1) & 1U) != 0;
}

void StyleSheet::append_candidates(const Tree& tree, ElementId id,
                                   std::vector<std::uint32_t>& numbers) const {
  const auto append = [&](const auto& filed, std::string_view name) {
    const auto entry = filed.find(name);
    if (entry != filed.end())
      numbers.insert(numbers.end(), entry->second.begin(), entry->second.end());
  };
  if (const auto name = tree.attribute(id, Key::id)) append(by_id_, *name);
  each_class(tree.text(id, Key::class_), [&](std::string_view name) { append(by_class_, name); });
  numbers.insert(numbers.end(), others_.begin(), others_.end());
}

void StyleSheet::append_matching(const Tree& tree, ElementId id,
                                 std::vector<Declaration>& declarations) const {
  std::vector<std::uint32_t> numbers;
  append_candidates(tree, id, numbers);
  const auto is_out = [&](std::uint32_t number) { return !matches(tree, id, selectors_[number]); };
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), is_out), numbers.end());
  std::sort(numbers.begin(), numbers.end(), [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t weight_a = selectors_[a].weight;
    const std::uint32_t weight_b = selectors_[b].weight;
    return weight_a != weight_b ? weight_a < weight_b : a < b;
  });
  for (const std::uint32_t number : numbers) {
    const auto first = declarations_.begin() + selectors_[number].first;
    declarations.insert(declarations.end(), first, first + selectors_[number].count);
  }
}

}  // namespace kerf::drawing::svg
