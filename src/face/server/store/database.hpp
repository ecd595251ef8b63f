#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace kerf::server {

/// One SQL statement with its values. A database that fails throws DatabaseError: the few who use a
/// database catch it at their border.
class Statement {
 public:
  Statement(sqlite3* database, std::string_view sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  /// The next '?' of the statement.
  Statement& bind(std::int64_t value);
  Statement& bind(std::string_view text);
  Statement& bind_blob(std::string_view bytes);
  Statement& bind_null();

  /// To the next row of the result; false: there is none.
  bool step();
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] bool is_null(int column) const;

 private:
  void check(int result) const;

  sqlite3* database_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
};

struct DatabaseError {
  std::string message;
};

/// An SQLite file whose transactions survive a crash and a power loss.
class Database {
 public:
  /// Throws DatabaseError.
  explicit Database(const std::string& path);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Without values and without a result.
  void run(std::string_view sql) { Statement(database_, sql).step(); }
  /// Number of the format that its tables have; 0: nobody has said.
  [[nodiscard]] std::int64_t format();
  void set_format(std::int64_t format);
  [[nodiscard]] sqlite3* get() { return database_; }

 private:
  sqlite3* database_ = nullptr;
};

/// All or nothing of what is done during its life: what is not committed is undone.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) {
    database.run("BEGIN IMMEDIATE");
  }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool open_ = true;
};

}  // namespace kerf::server
