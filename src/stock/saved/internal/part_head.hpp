#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "stock/saved/part_file.hpp"

namespace kerf::stock::saved {

/// The JSON of a file, of which every value that is asked for must be there and sound (WrongPart).
class PartHead {
 public:
  explicit PartHead(const std::string& json);

  [[nodiscard]] std::string text(const char* key) const;
  [[nodiscard]] bool flag(const char* key) const;
  /// Within low and high.
  [[nodiscard]] double number(const char* key, double low, double high) const;
  [[nodiscard]] int count(const char* key, double most) const;
  /// `size` numbers of cells along an axis, each at least 1.
  [[nodiscard]] std::vector<int> cells(std::size_t size) const;
  /// Twice `axes` coordinates: low, high.
  [[nodiscard]] std::vector<double> box(std::size_t axes) const;
  [[nodiscard]] PartLabel label() const;

 private:
  [[nodiscard]] const nlohmann::json& at(const char* key) const;
  [[nodiscard]] const nlohmann::json& list(const char* key, std::size_t size) const;

  nlohmann::json json_;
};

}  // namespace kerf::stock::saved
