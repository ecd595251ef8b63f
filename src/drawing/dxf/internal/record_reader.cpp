#include "drawing/dxf/internal/record_reader.hpp"

namespace kerf::drawing::dxf {
namespace {

constexpr int kBracket = 102;
constexpr int kEmbedded = 101;
constexpr int kFirstOfPrograms = 1000;

}  // namespace

// The first record of the file: what is in front of it are comments.
bool RecordReader::begin(Record& record) {
  RawGroup group;
  while (kind_.empty()) {
    const Outcome outcome = groups_.next(group);
    if (outcome == Outcome::end) return false;
    if (outcome == Outcome::broken) {
      record.begin("", groups_.line());
      record.set_fault(groups_.line(), groups_.fault());
      if (groups_.find_next_word(group) == Outcome::end) return false;
    } else if (group.code != 0) {
      continue;
    }
    kind_ = without_blanks(group.value);
    kind_line_ = group.line - 1;
    if (outcome == Outcome::broken) return true;
  }
  return true;
}

void RecordReader::take(const RawGroup& group, Record& record) {
  if (group.code == kBracket) {
    attached_ += group.value.starts_with('{') ? 1 : -1;
    if (attached_ < 0) attached_ = 0;
  } else if (group.code == kEmbedded) {
    is_embedded_ = true;
  } else if (attached_ == 0 && !is_embedded_ && group.code < kFirstOfPrograms) {
    record.add(group.code, group.line, group.value);
  }
}

bool RecordReader::next(Record& record) {
  if (kind_.empty()) {
    record.begin("", 0);
    if (!begin(record)) return false;
    if (record.fault().line > 0) return true;
  }
  record.begin(kind_, kind_line_);
  if (kind_ == "EOF") return true;
  attached_ = 0;
  is_embedded_ = false;
  for (RawGroup group;;) {
    Outcome outcome = groups_.next(group);
    if (outcome == Outcome::broken) {
      record.set_fault(groups_.line(), groups_.fault());
      outcome = groups_.find_next_word(group);
    }
    if (outcome == Outcome::end) return false;
    if (group.code == 0) {
      kind_ = without_blanks(group.value);
      kind_line_ = group.line - 1;
      return true;
    }
    take(group, record);
  }
}

}  // namespace kerf::drawing::dxf
