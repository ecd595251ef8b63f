#include "face/server/store/revisions.hpp"

namespace kerf::server {

// A file of format 0 was made before formats were counted, and is of the first one.
Revisions::Revisions(const std::string& path) : database_(path) {
  const std::int64_t format = database_.format();
  if (format < 0 || format > kFormat)
    throw DatabaseError{path + ": it has format " + std::to_string(format) +
                        ", and this Kerf knows " + std::to_string(kFormat) + " as the newest"};
  if (format == 0) make_tables();
  if (!has_tables()) throw DatabaseError{path + ": its table `revisions` is not one of Kerf's"};
}

bool Revisions::has_tables() {
  Statement info(database_.get(), "PRAGMA table_info(revisions)");
  std::string columns;
  while (info.step()) columns += info.text(1) + " ";
  return columns == "program number time_ms bytes kept text ";
}

void Revisions::make_tables() {
  Transaction transaction(database_);
  database_.run(
      "CREATE TABLE IF NOT EXISTS revisions (program TEXT NOT NULL, number INTEGER NOT NULL, "
      "time_ms INTEGER NOT NULL, bytes INTEGER NOT NULL, kept INTEGER NOT NULL, text BLOB, "
      "PRIMARY KEY (program, number))");
  if (!has_tables()) return;
  database_.set_format(kFormat);
  transaction.commit();
}

Revision Revisions::add(const std::string& program, std::string_view text, std::uint64_t bytes,
                        std::int64_t time_ms) {
  const auto before = newest(program);
  const Revision made{before ? before->number + 1 : 1, time_ms, bytes, bytes <= kMostText};
  Statement insert(database_.get(), "INSERT INTO revisions VALUES (?, ?, ?, ?, ?, ?)");
  insert.bind(program).bind(made.number).bind(time_ms).bind(static_cast<std::int64_t>(bytes));
  insert.bind(std::int64_t{made.kept});
  made.kept ? insert.bind_blob(text) : insert.bind_null();
  insert.step();
  prune(program);
  return made;
}

void Revisions::take_back(const std::string& program, std::int64_t number) {
  Statement(database_.get(), "DELETE FROM revisions WHERE program = ? AND number = ?")
      .bind(program)
      .bind(number)
      .step();
}

void Revisions::prune(const std::string& program) {
  Statement(database_.get(),
            "DELETE FROM revisions WHERE program = ?1 AND number <= (SELECT max(number) FROM "
            "revisions WHERE program = ?1) - ?2")
      .bind(program)
      .bind(kMostOfProgram)
      .step();
  Statement sum(database_.get(), "SELECT sum(bytes) FROM revisions WHERE kept");
  sum.step();
  std::int64_t excess = sum.integer(0) - kMostBytes;
  while (excess > 0) {
    Statement oldest(database_.get(),
                     "SELECT program, number, bytes FROM revisions AS r WHERE kept AND number < "
                     "(SELECT max(number) FROM revisions WHERE program = r.program) "
                     "ORDER BY time_ms LIMIT 1");
    if (!oldest.step()) return;
    const std::string of = oldest.text(0);
    excess -= oldest.integer(2);
    Statement(database_.get(), "DELETE FROM revisions WHERE program = ? AND number = ?")
        .bind(of)
        .bind(oldest.integer(1))
        .step();
  }
}

std::vector<Revision> Revisions::of(const std::string& program) {
  Statement select(database_.get(),
                   "SELECT number, time_ms, bytes, kept FROM revisions WHERE program = ? "
                   "ORDER BY number DESC");
  select.bind(program);
  std::vector<Revision> found;
  while (select.step())
    found.push_back({select.integer(0), select.integer(1),
                     static_cast<std::uint64_t>(select.integer(2)), select.integer(3) != 0});
  return found;
}

std::optional<std::string> Revisions::text(const std::string& program, std::int64_t number) {
  Statement select(database_.get(),
                   "SELECT text FROM revisions WHERE program = ? AND number = ? AND kept");
  select.bind(program).bind(number);
  if (!select.step()) return std::nullopt;
  return select.text(0);
}

std::optional<Revision> Revisions::newest(const std::string& program) {
  Statement select(database_.get(),
                   "SELECT number, time_ms, bytes, kept FROM revisions WHERE program = ? "
                   "ORDER BY number DESC LIMIT 1");
  select.bind(program);
  if (!select.step()) return std::nullopt;
  return Revision{select.integer(0), select.integer(1),
                  static_cast<std::uint64_t>(select.integer(2)), select.integer(3) != 0};
}

void Revisions::rename(const std::string& from, const std::string& to) {
  const auto last = newest(to);
  Statement(database_.get(),
            "UPDATE revisions SET program = ?, number = number + ? WHERE program = ?")
      .bind(to)
      .bind(last ? last->number : 0)
      .bind(from)
      .step();
}

}  // namespace kerf::server
