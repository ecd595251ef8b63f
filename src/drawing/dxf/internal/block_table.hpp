#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "drawing/dxf/internal/code_page.hpp"
#include "drawing/dxf/internal/record.hpp"

namespace kerf::drawing::dxf {

/// What an INSERT draws.
struct Block {
  struct Entry {
    Record record;
    bool is_circular = false;  ///< an INSERT by which the block would hold itself
  };
  Vec2 base;                  ///< what comes to where it is inserted
  bool is_elsewhere = false;  ///< its entities are in another file
  std::vector<Entry> entries;
  double weight = 0;  ///< how many entities it draws, those of its blocks included
};

/// Rows and columns of an INSERT, each at least 1.
struct Grid {
  double columns = 1;
  double rows = 1;
};
[[nodiscard]] Grid grid_of(const Record& insert);

/// The blocks of a file by their names, in which small and capital letters are the same.
class BlockTable {
 public:
  explicit BlockTable(CodePage& words) : words_(words) {}

  /// A group BLOCK; what is added is of it. Of two with the same name the first one stays.
  void begin(const Record& block);
  void add(const Record& record);
  /// All have been read: finds what each weighs, and which would hold themselves.
  void weigh();

  /// Null: there is none of this name, which is as the file has it.
  [[nodiscard]] const Block* find(std::string_view raw) { return entry(raw); }

 private:
  struct Visit;
  Block* entry(std::string_view raw);
  Block* child_of(const Record& record);
  void weigh(Block& block);

  CodePage& words_;
  std::unordered_map<std::string, Block> blocks_;
  std::vector<Block*> in_order_;
  std::unordered_map<const Block*, int> states_;  // while they are weighed
  Block* open_ = nullptr;
};

}  // namespace kerf::drawing::dxf
