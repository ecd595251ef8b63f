#pragma once

#include "drawing/dxf/internal/group_reader.hpp"
#include "drawing/dxf/internal/record.hpp"

namespace kerf::drawing::dxf {

/// Hands out what stands between groups 0. Behind a group that is none, the next record is that of
/// the next group 0.
class RecordReader {
 public:
  RecordReader(const base::SourceFile& file, base::FileId id) : groups_(file, id) {}

  /// False: the file ends, and `record` may not be whole; its kind is empty where nothing was
  /// begun. EOF is the last record.
  bool next(Record& record);
  /// Lines that were read.
  [[nodiscard]] std::uint32_t line() const { return groups_.line(); }

 private:
  using Outcome = GroupReader::Outcome;
  bool begin(Record& record);
  void take(const RawGroup& group, Record& record);

  GroupReader groups_;
  std::string kind_;  // of the next record; empty: its group 0 has not come
  std::uint32_t kind_line_ = 0;
  int attached_ = 0;          // brackets that are open: { of group 102
  bool is_embedded_ = false;  // behind group 101: of an object inside of the entity
};

}  // namespace kerf::drawing::dxf
