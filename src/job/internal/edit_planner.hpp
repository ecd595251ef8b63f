#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "features/edit/contour_edit.hpp"
#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"
#include "features/path/blank.hpp"
#include "features/rewrite/planned_row.hpp"
#include "features/tree/tree.hpp"

namespace kerf::job {

/// A layer whose contour an edit changes, as it shall come back.
struct WantedLayer {
  std::size_t feature = 0;
  std::size_t layer = 0;
  features::LayerContours contours{};
  double z = 0;
};

/// A turned feature as it shall come back; contour (z, radius), open.
struct WantedTurned {
  std::size_t feature = 0;
  std::optional<contour::Contour> contour{};  ///< none: its depth alone is another
};

/// What edits make of the rows of a program.
struct EditPlan {
  features::RowPlan rows{};
  /// Layers of edited features that are cut anew, moved or deepened; all else stays.
  std::vector<WantedLayer> wanted{};
  std::vector<std::pair<std::size_t, std::size_t>> gone{};  ///< feature and layer
  std::vector<std::size_t> edited_holes{};
  std::vector<WantedTurned> turned{};
  std::vector<std::size_t> arguments{};  ///< edits of the file that change an argument
  bool changes_more = false;             ///< blocks of several features, or what a call cuts
  std::vector<features::EditFault> warnings{};
};

/// Makes a plan of edits: applies them in their order, lets the other layers follow, and cuts anew
/// what has changed (features-contract §5 to §8).
class EditPlanner {
 public:
  EditPlanner(const features::Recording& recording, const features::Tree& tree,
              bool allows_collision)
      : recording_(recording), tree_(tree), allows_collision_(allows_collision) {}

  [[nodiscard]] features::Editing<EditPlan> plan(const std::vector<features::Edit>& edits);

 private:
  struct FeatureEdit {
    std::map<std::size_t, features::ContourEdit> layers{};
    std::map<std::size_t, features::LayerRule> rules{};
    std::size_t edit = 0;  // the last one that names it
  };
  using Done = features::Editing<void>;

  [[nodiscard]] Done apply(const features::Edit& edit, std::size_t place);
  [[nodiscard]] Done change_contour(const features::Edit& edit, std::size_t feature);
  [[nodiscard]] Done change_layer(const features::Edit& edit, std::size_t feature,
                                  std::size_t layer);
  [[nodiscard]] Done move(const features::MoveFeature& by, std::size_t feature);
  [[nodiscard]] Done set_depth(const features::SetDepth& depth, std::size_t feature);
  [[nodiscard]] Done set_hole_depth(double z, std::size_t hole);
  [[nodiscard]] Done remove(std::size_t feature);
  [[nodiscard]] Done remove_hole(std::size_t hole);
  [[nodiscard]] Done move_hole(contour::Vec2 to, std::size_t hole);
  [[nodiscard]] Done add_hole(contour::Vec2 at, std::size_t pattern);
  [[nodiscard]] Done change_order(const features::ChangeOrder& order, const std::string& target);
  [[nodiscard]] Done finish(std::size_t feature, FeatureEdit& edited);
  [[nodiscard]] Done cut_anew(std::size_t feature, std::size_t layer,
                              const features::LayerContours& contours);
  void write_out(features::Span lines);
  void free_what_shares(std::size_t feature);
  [[nodiscard]] Done follow_vertices(std::size_t feature, std::size_t layer,
                                     const features::LayerContours& contours);
  [[nodiscard]] Done edit_turned(const features::Edit& edit, std::size_t feature);
  [[nodiscard]] Done turn_anew(std::size_t feature, const contour::Contour& contour);
  [[nodiscard]] Done check_origin(const features::Edit& edit, const features::Origin& origin,
                                  features::Editable editable);
  [[nodiscard]] Done check_collision(std::size_t feature, std::size_t layer,
                                     const contour::Region& before, const contour::Region& now);

  [[nodiscard]] std::optional<std::size_t> feature_of(const std::string& target) const;
  [[nodiscard]] std::optional<std::size_t> hole_of(const std::string& target) const;
  [[nodiscard]] std::optional<std::size_t> pattern_of(const std::string& target) const;
  [[nodiscard]] tl::unexpected<features::EditFault> refuse(base::Code code, std::string sentence,
                                                           std::string hint = "") const;
  void add(features::Stretch stretch) { plan_.rows.push_back(std::move(stretch)); }

  const features::Recording& recording_;
  const features::Tree& tree_;
  bool allows_collision_;
  std::map<std::size_t, FeatureEdit> edited_{};
  std::vector<features::Span> loops_{};  // lines of those that are written out
  std::size_t edit_ = 0;                 // that is being applied
  EditPlan plan_{};
};

}  // namespace kerf::job
