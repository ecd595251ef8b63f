#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "base/result.hpp"
#include "face/server/hub/part.hpp"
#include "job/edit_scene.hpp"

namespace kerf::server {

/// What a scene is made of.
struct SceneOrder {
  PartSource source;
  std::string set_up;  ///< TOML; empty: nobody has set the program up
  std::string folder;  ///< of the library
  std::stop_token unwanted;
};

/// Runs a program and recognises what it machines, as `kerf features` does. Takes as long.
class SceneMaking {
 public:
  static constexpr double kMostSeconds = 600;  ///< of running, as a preview has
  /// A row takes about a hundred bytes: a program that moves more is told up to there.
  static constexpr std::uint64_t kMostMotions = 3'000'000;
  static constexpr std::uint64_t kMostText = 64U << 20U;

  explicit SceneMaking(SceneOrder order) : order_(std::move(order)) {}

  /// Called when the program has run, before anything is recognised, with members of the answer of
  /// `insight`.
  using Ran = std::function<void(std::string members)>;
  /// Waits for the disk. Failure: a sentence.
  [[nodiscard]] base::Outcome<std::shared_ptr<job::EditScene>> make(const Ran& ran);

 private:
  [[nodiscard]] base::Outcome<job::StockJob> stock_job() const;

  SceneOrder order_;
};

}  // namespace kerf::server
