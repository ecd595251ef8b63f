#pragma once

#include <string_view>

#include "base/output_file.hpp"
#include "drive/pattern/codec.hpp"
#include "drive/pattern/split.hpp"

namespace kerf::drive {

/// Writes records as bytes and counts what they move. Nothing is allocated per record.
class PatternWriter {
 public:
  /// The file must outlive the writer.
  PatternWriter(ByteOrder order, base::OutputFile& file) : order_(order), file_(file) {}

  void write(const PatternRecord& record) {
    const RecordBytes bytes = encode(record, order_);
    file_.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

 private:
  ByteOrder order_;
  base::OutputFile& file_;
};

}  // namespace kerf::drive
