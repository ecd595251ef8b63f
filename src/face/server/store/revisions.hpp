#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "face/server/store/database.hpp"

namespace kerf::server {

/// A state in which a program was once saved.
struct Revision {
  std::int64_t number = 0;   ///< from 1, in the order of saving
  std::int64_t time_ms = 0;  ///< since 1970, UTC
  std::uint64_t bytes = 0;
  bool kept = true;  ///< its text is still there
};

/// The revisions of programs in a database: number, time and text.
///
/// A text above kMostText is not kept, only told. Of a program the newest kMostOfProgram are kept;
/// of all together kMostBytes of text, the oldest go first. The newest of a program always stays.
/// Everything throws DatabaseError.
class Revisions {
 public:
  static constexpr std::uint64_t kMostText = 8U << 20U;
  static constexpr std::int64_t kMostOfProgram = 200;
  static constexpr std::int64_t kMostBytes = std::int64_t{1} << 30U;

  /// Of the tables, as PRAGMA user_version has it. A Kerf that knows a later one brings a file of
  /// an earlier one to it, in one transaction; one that does not know it refuses the file.
  static constexpr std::int64_t kFormat = 1;

  explicit Revisions(const std::string& path);

  /// What is changed between here and commit() is changed together.
  [[nodiscard]] Transaction begin() { return Transaction(database_); }

  // Within a transaction:

  Revision add(const std::string& program, std::string_view text, std::uint64_t bytes,
               std::int64_t time_ms);
  /// Behind those that `to` has already.
  void rename(const std::string& from, const std::string& to);
  void take_back(const std::string& program, std::int64_t number);

  [[nodiscard]] std::vector<Revision> of(const std::string& program);
  /// Nothing: there is no such revision, or its text was not kept.
  [[nodiscard]] std::optional<std::string> text(const std::string& program, std::int64_t number);
  [[nodiscard]] std::optional<Revision> newest(const std::string& program);

 private:
  [[nodiscard]] bool has_tables();
  void make_tables();
  void prune(const std::string& program);

  Database database_;
};

}  // namespace kerf::server
