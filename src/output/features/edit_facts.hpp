#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostic_code.hpp"

namespace kerf::output {

/// What an edit of features has done to a program, as its report tells it.
struct EditFacts {
  struct Change {
    std::string file;
    std::uint32_t first = 0;  ///< of the old text, from 1
    std::vector<std::string> old_lines;
    std::vector<std::string> new_lines;
  };
  struct Blocks {
    std::uint32_t kept = 0;
    std::uint32_t patched = 0;
    std::uint32_t inserted = 0;
    std::uint32_t removed = 0;
  };
  struct Regenerated {
    std::string feature;
    std::vector<std::size_t> layers;
  };
  struct Renamed {
    std::string was;
    std::size_t was_layer = 0;
    std::string is;
    std::size_t is_layer = 0;
  };
  struct Verified {
    bool recognised = false;
    bool others_unchanged = false;
    double contour_error_mm = 0;
    double difference_mm3 = 0;
    double outside_mm3 = 0;
    double corner_rest_mm2 = 0;
    std::vector<std::string> new_findings{};
    std::string findings_skipped{};  ///< why they were not compared; empty: they were
    double time_before_s = 0;
    double time_after_s = 0;
  };
  struct Warning {
    std::size_t edit = 0;  ///< its place in the edits file, from 0
    base::Code code{};
    std::string sentence;
  };
  /// A file beside the program that the edit changes.
  struct Library {
    std::string file;
    std::uint32_t crc32 = 0;
  };

  std::size_t edits = 0;
  std::vector<Change> changes{};
  std::uint64_t bytes_changed = 0;
  Blocks blocks{};
  std::vector<Regenerated> regenerated{};
  std::vector<Renamed> ids{};
  Verified verified{};
  std::vector<Warning> warnings{};
  std::uint32_t crc32 = 0;  ///< of the program as the edit leaves it
  std::vector<Library> libraries{};
};

}  // namespace kerf::output
