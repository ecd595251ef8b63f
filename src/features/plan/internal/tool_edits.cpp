#include "features/plan/internal/tool_edits.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kerf::features {
namespace {

using base::Code;

/// A feature or a hole: which operations cut it, and which tool somebody wishes.
struct Member {
  std::string name{};
  std::vector<std::size_t> operations{};
  std::optional<std::uint32_t> tool{};
  std::size_t edit = 0;
};

/// `parts`: its cuts or steps, each of an operation.
template <typename Part, typename Wish>
Member member_of(char kind, std::size_t place, const std::vector<Part>& parts,
                 const std::map<std::size_t, Wish>& wishes) {
  Member member{.name = kind + std::to_string(place + 1)};
  for (const Part& part : parts) member.operations.push_back(part.operation);
  const auto wish = wishes.find(place);
  if (wish == wishes.end() || wish->second.goes) return member;
  member.tool = wish->second.tool;
  member.edit = wish->second.edit;
  return member;
}

std::vector<Member> members_of(const Tree& tree, const EditWishes& wishes) {
  std::vector<Member> members;
  for (std::size_t i = 0; i < tree.features.size(); ++i)
    members.push_back(member_of('F', i, tree.features[i].cuts, wishes.features));
  for (std::size_t i = 0; i < tree.holes.size(); ++i)
    members.push_back(member_of('H', i, tree.holes[i].steps, wishes.holes));
  return members;
}

bool is_cut_by(const Member& member, std::size_t operation) {
  const auto& all = member.operations;
  return std::find(all.begin(), all.end(), operation) != all.end();
}

class ToolChanger {
 public:
  ToolChanger(EditScene& scene, const EditWishes& wishes)
      : scene_(scene), members_(members_of(scene.tree, wishes)) {}

  [[nodiscard]] Done change() {
    for (const Member& member : members_) {
      if (!member.tool) continue;
      scene_.edit = member.edit;
      if (auto done = change(member); !done) return done;
    }
    return {};
  }

 private:
  [[nodiscard]] Done change(const Member& member) {
    const std::string tool = "T" + std::to_string(*member.tool);
    if (scene_.recording.diameter_of(*member.tool) <= 0)
      return scene_.refuse(Code::edit_tool_unknown, "NO TOOL " + std::to_string(*member.tool),
                           "--tools describes the tools that an edit may name");
    if (member.operations.size() != 1) {
      return scene_.refuse(Code::edit_not_editable,
                           member.name + " IS CUT BY SEVERAL OPERATIONS: WHICH OF THEM GETS " +
                               tool + " NOBODY SAYS");
    }
    const std::size_t operation = member.operations.front();
    const Operation& its = scene_.tree.operations[operation].operation;
    std::string others;
    for (const Member& other : members_) {
      if (is_cut_by(other, operation) && other.tool != member.tool)
        others += (others.empty() ? "" : ", ") + other.name;
    }
    if (!others.empty()) {
      return scene_.refuse(Code::edit_tool_shared,
                           "T" + std::to_string(its.tool) + " ALSO CUTS " + others,
                           "name the others in edits of their own, with the same tool");
    }
    if (!changed_.insert(operation).second || its.tool == *member.tool) return {};
    scene_.plan.tools.push_back({its.tool, *member.tool, its.rows});
    scene_.plan.warnings.push_back({Code::edit_speeds_stay,
                                    "S AND F ARE STILL THOSE OF T" + std::to_string(its.tool), "",
                                    scene_.edit});
    return {};
  }

  EditScene& scene_;
  std::vector<Member> members_;
  std::set<std::size_t> changed_{};
};

}  // namespace

Done change_tools(EditScene& scene, const EditWishes& wishes) {
  return ToolChanger(scene, wishes).change();
}

void tell_unused_tools(EditScene& scene) {
  std::map<std::uint32_t, int> left;
  const EditPlan& plan = scene.plan;
  const auto tool_now = [&](std::uint32_t tool, std::size_t operation) {
    const Span rows = scene.tree.operations[operation].operation.rows;
    for (const ToolChange& change : plan.tools) {
      if (change.rows == rows) tool = change.is;
    }
    return tool;
  };
  for (std::size_t f = 0; f < scene.tree.features.size(); ++f) {
    const Feature& its = scene.tree.features[f];
    left[its.tool];
    int& count = left[tool_now(its.tool, its.cuts.front().operation)];
    for (std::size_t layer = 0; layer < its.layers.size(); ++layer) {
      const auto gone = std::pair(f, layer);
      count += static_cast<int>(std::count(plan.gone.begin(), plan.gone.end(), gone) == 0);
    }
    count += static_cast<int>(its.layers.empty());
  }
  for (std::size_t h = 0; h < scene.tree.holes.size(); ++h) {
    const bool stays = std::count(plan.gone_holes.begin(), plan.gone_holes.end(), h) == 0;
    for (const HoleStep& step : scene.tree.holes[h].steps) {
      left[step.tool];
      left[tool_now(step.tool, step.operation)] += static_cast<int>(stays);
    }
  }
  for (const auto& [tool, count] : left) {
    if (count > 0 || plan.changes_more) continue;
    scene.plan.warnings.push_back({base::Code::edit_tool_unused,
                                   "T" + std::to_string(tool) + " CUTS NOTHING ANY MORE", "",
                                   scene.edit});
  }
}

}  // namespace kerf::features
