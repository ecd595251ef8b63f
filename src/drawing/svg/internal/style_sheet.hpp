#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "drawing/canvas.hpp"
#include "drawing/svg/internal/tree.hpp"

namespace kerf::drawing::svg {

struct Declaration {
  Key property{};
  std::string_view value;
  bool is_important = false;
};

/// Appends those of a block, or of an attribute `style`, that mean something here.
void append_declarations(std::string_view block, std::vector<Declaration>& declarations);

/// The rules of all style sheets of a file: selectors of type, .class, #id and *, combined (a.b#c),
/// listed (a, b) and nested (a b, a > b). Others, and rules that begin with @, are counted as
/// ignored.
class StyleSheet {
 public:
  StyleSheet(std::string_view text, Canvas& canvas);

  [[nodiscard]] bool is_empty() const { return selectors_.empty(); }
  /// Appends what holds for an element, what weighs less first.
  void append_matching(const Tree& tree, ElementId id,
                       std::vector<Declaration>& declarations) const;

 private:
  /// What one element must be.
  struct Compound {
    bool has_type = false;
    Tag type{};
    std::vector<std::string_view> classes;
    std::vector<std::string_view> ids;
    bool is_child = false;  ///< of the element for the compound before; else anywhere inside of it
  };
  struct Selector {
    std::vector<Compound> compounds;
    std::uint32_t weight = 0;
    std::uint32_t first = 0;  ///< of declarations_
    std::uint32_t count = 0;
  };
  class Reader;

  static bool is_one(const Tree& tree, ElementId id, const Compound& compound);
  [[nodiscard]] static bool matches(const Tree& tree, ElementId id, const Selector& selector);
  void file(std::uint32_t number);
  void append_candidates(const Tree& tree, ElementId id, std::vector<std::uint32_t>& numbers) const;

  std::string text_;  // without comments
  std::vector<Declaration> declarations_;
  std::vector<Selector> selectors_;
  // By what the last compound asks for: only these are tried.
  std::unordered_map<std::string_view, std::vector<std::uint32_t>> by_id_;
  std::unordered_map<std::string_view, std::vector<std::uint32_t>> by_class_;
  std::vector<std::uint32_t> others_;
};

}  // namespace kerf::drawing::svg
