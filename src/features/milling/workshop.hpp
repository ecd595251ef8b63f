#pragma once

#include <map>
#include <vector>

#include "features/milling/draft.hpp"
#include "features/milling/growing_boxes.hpp"
#include "features/milling/hole_book.hpp"
#include "features/milling/idle_pecks.hpp"
#include "features/milling/material.hpp"
#include "features/milling/stroke.hpp"
#include "features/path/allowance.hpp"
#include "features/tree/tree.hpp"

namespace kerf::features {

/// Follows the operations of a mill in their order, takes from the material what they cut, and puts
/// levels together to features, plunges to holes.
class Workshop {
 public:
  /// `blank` in machine coordinates. The recording and the allowance must outlive this.
  Workshop(const Recording& recording, const Blank& blank, Allowance& allowance);

  /// What the allowance does not suffice for is not recognised.
  void follow(std::size_t number, const Operation& operation);

  [[nodiscard]] const Material& material(std::size_t setup) const { return materials_[setup]; }
  /// In the order of their first rows.
  [[nodiscard]] std::vector<Draft> drafts();
  [[nodiscard]] HoleBook& holes() { return holes_; }
  [[nodiscard]] std::vector<Unrecognised>& unrecognised() { return unrecognised_; }
  /// Of each operation what it fed through air, mm.
  [[nodiscard]] double air_mm(std::size_t operation) const { return air_mm_[operation]; }

 private:
  struct Event;

  [[nodiscard]] const stock::Tool& tool_of(const Operation& operation) const;
  void follow_strokes(std::size_t number, const Operation& operation, Strokes strokes);
  void take(std::size_t number, const Operation& operation, const Event& event);
  void leave(const Event& event);
  void leave(const Level& level);
  void keep(const ShapedLevel& shaped);
  void take(std::size_t number, const Operation& operation, const PlungeRun& plunge);
  void leave_idle_pecks();
  void take(std::size_t number, const Operation& operation, const HelixRun& helix);
  void take(const Operation& operation, const FreeRun& run);
  void take(const Operation& operation, Level& level);
  [[nodiscard]] bool is_helical_hole(const ShapedLevel& shaped) const;
  void add_hole(std::size_t number, const Operation& operation, const HelixRun& helix,
                std::vector<Span> rows);
  [[nodiscard]] Draft* layer_above(const ShapedLevel& shaped);
  [[nodiscard]] bool join(ShapedLevel& shaped);
  void join(Draft& draft, Layer& layer, ShapedLevel& shaped);
  void put(ShapedLevel shaped, Material& material, bool is_mill);
  static void add_layer(Draft& draft, ShapedLevel shaped);
  [[nodiscard]] static bool belongs(const Layer& layer, const ShapedLevel& shaped);
  Draft& begin_feature(ShapedLevel shaped);
  void follow_threads(std::size_t number, const Operation& operation);
  void add_thread(std::size_t number, const Operation& operation, const HelixRun& helix,
                  double diameter);
  void leave(Span rows, Unrecognised::Why why);
  void add_surface(std::size_t number, const Operation& operation, std::vector<Span> rows,
                   Span visit);
  void count_air(std::size_t number, Span rows);

  const Recording& recording_;
  Allowance& allowance_;
  std::vector<Material> materials_;  // by set-up
  std::vector<Draft> drafts_;
  GrowingBoxes boxes_;  // of the drafts
  HoleBook holes_;
  std::vector<Unrecognised> unrecognised_;
  std::vector<double> air_mm_;
  IdlePecks idle_;
};

}  // namespace kerf::features
