#include "lang/teach/recorder.hpp"

#include "lang/teach/record_parser.hpp"
#include "lang/teach/record_writer.hpp"

namespace kerf::teach {
namespace {

// What the reader would say of the record's own line. Of a mistake in it the text is gone.
std::optional<Mistake> objection_to_values(const Record& record) {
  std::string line;
  append_record(line, record);
  auto read = parse_record(Words(line));
  if (!read) {
    read.error().text = {};
    return std::move(read.error());
  }
  if (*read == record) return std::nullopt;
  return Mistake{base::Code::teach_range,
                 "the name of a point is one word, without blanks, commas and semicolons",
                 {}};
}

}  // namespace

Recorder::Recorder(const Period& period, const std::optional<Radii>& radii)
    : records_{Version{}, Units{}, period} {
  if (radii) records_.emplace_back(*radii);
  head_ = records_.size();
  admit_all();
}

// They have been admitted before.
void Recorder::admit_all() {
  sequence_ = {};
  for (const Record& record : records_) static_cast<void>(sequence_.admit(record));
}

std::optional<Mistake> Recorder::teach(const Record& record) {
  if (auto mistake = objection_to_values(record)) return mistake;
  Sequence behind = sequence_;
  if (auto mistake = behind.admit(record)) return mistake;
  sequence_ = behind;
  records_.push_back(record);
  return std::nullopt;
}

bool Recorder::take_back() {
  if (records_.size() == head_) return false;
  records_.pop_back();
  admit_all();
  return true;
}

std::string Recorder::text() const {
  std::string text;
  for (const Record& record : records_) append_line(text, &record, nullptr);
  return text;
}

}  // namespace kerf::teach
