#include "face/server/hub/internal/features.hpp"

#include <algorithm>
#include <utility>

#include "face/server/hub/guarded.hpp"
#include "face/server/hub/internal/scene_making.hpp"
#include "job/edit_preview.hpp"
#include "job/facts_of_features.hpp"
#include "output/features/feature_json.hpp"
#include "output/features/insight.hpp"

namespace kerf::server {
namespace {

using base::Outcome;
using features::Method;

Method method_named(const std::string& name) {
  if (name == "swept") return Method::swept;
  return name == "literal" ? Method::literal : Method::both;
}

job::PreviewUntil until_named(const std::string& name) {
  if (name == "contour") return job::PreviewUntil::contour;
  return name == "verified" ? job::PreviewUntil::verified : job::PreviewUntil::paths;
}

std::string revision_member(std::uint32_t revision) {
  return ",\"revision\":" + std::to_string(revision);
}

/// Members of the answer; loops take most of it, and people least look at them.
std::string features_members(job::EditScene& scene, Method method, std::uint32_t revision) {
  job::FeaturesResult& result = scene.features();
  features::Tree other;
  output::FeatureFacts facts = job::facts_of(result);
  facts.method = method;
  if (method != Method::both) {
    other = job::recognised(result, method);
    facts.tree = &other;
  }
  std::string text = output::features_json(facts);
  std::string more = revision_member(revision);
  if (text.size() + more.size() + 256 > limits::kAnswerBytes) {
    facts.tells_loops = false;
    text = output::features_json(facts);
    more += ",\"truncated\":[\"loops\"]";
  }
  text.pop_back();  // the line end
  return "\"features\":" + text + more;
}

/// Which one a call did not find, as the control's sentence names it; null: the call names none.
Json missing_program(const std::string& message) {
  constexpr std::string_view kNames = "there is no program ";
  const std::size_t at = message.find(kNames);
  return at == std::string::npos ? Json(nullptr) : Json(message.substr(at + kNames.size()));
}

/// Calls of programs that nobody has, and all else that the preview run has found.
std::string findings_members(const Json& findings) {
  const std::string_view missing_code = base::text_of(base::Code::program_not_found).number;
  Json missing = Json::array();
  Json others = Json::array();
  for (const Json& each : findings) {
    if (each["code"] == missing_code)
      missing.push_back({{"program", missing_program(each["message"])},
                         {"message", each["message"]},
                         {"line", each["line"]}});
    else
      others.push_back({{"line", each["line"]},
                        {"column", each["column"]},
                        {"code", each["code"]},
                        {"message", each["message"]}});
  }
  return "\"missing\":" + missing.dump() + ",\"not_understood\":" + others.dump();
}

/// Of a scene that is made, or could not be made.
Outcome<Features::Scene> answer_of(const Features::Scene& scene) {
  if (!*scene->made) return tl::unexpected(scene->made->error());
  return scene;
}

}  // namespace

// Scenes

void Features::renew(MachineRecord& machine) {
  thread_.here();
  ++machine.feature_revision;
  std::vector<FeatureScene::Waiting> waiting;
  if (machine.scene) waiting = std::move(machine.scene->waiting);
  drop(machine);
  for (Client* const watcher : machine.watchers) {
    watcher->send(
        {{"event", "features"}, {"machine", machine.name}, {"revision", machine.feature_revision}});
  }
  if (waiting.empty()) return;
  if (machine.part_source) return make(machine, std::move(waiting));
  for (const FeatureScene::Waiting& each : waiting)
    each(tl::unexpected(base::refuse(base::Refusal::no_program)));
}

// What it holds is let go of elsewhere: that takes time.
void Features::drop(MachineRecord& machine) {
  if (!machine.scene) return;
  machine.cancel_scene();
  around_.worker.post([scene = std::exchange(machine.scene, nullptr)] {});
}

void Features::cancel() const {
  for (const auto& [name, machine] : around_.machines.records()) machine->cancel_scene();
  for (const auto& [client, trial] : trials_) trial->stop.request_stop();
}

void Features::tick() {
  for (const auto& [name, machine] : around_.machines.records()) {
    if (!machine->scene || !machine->watchers.empty()) continue;
    const auto waiting = std::exchange(machine->scene->waiting, {});
    drop(*machine);
    for (const FeatureScene::Waiting& each : waiting)
      each(tl::unexpected(base::refuse(base::Refusal::features_left, {name})));
  }
  tell_insights();
}

// The one that was not used for longest goes.
void Features::make_room() {
  std::size_t count = 0;
  MachineRecord* oldest = nullptr;
  for (const auto& [name, machine] : around_.machines.records()) {
    if (!machine->scene || !machine->scene->waiting.empty()) continue;
    ++count;
    if (oldest == nullptr || machine->scene->used < oldest->scene->used) oldest = machine.get();
  }
  if (count >= kMostScenes) drop(*oldest);
}

void Features::with_scene(MachineRecord& machine, FeatureScene::Waiting go_on) {
  thread_.here();
  if (!machine.part_source) return go_on(tl::unexpected(base::refuse(base::Refusal::no_program)));
  if (!machine.scene) {
    make_room();
    return make(machine, {std::move(go_on)});
  }
  machine.scene->used = ++uses_;
  if (machine.scene->made) return go_on(answer_of(machine.scene));
  machine.scene->waiting.push_back(std::move(go_on));
}

void Features::make(MachineRecord& machine, std::vector<FeatureScene::Waiting> waiting) {
  const auto scene = std::make_shared<FeatureScene>();
  scene->revision = machine.feature_revision;
  scene->waiting = std::move(waiting);
  scene->used = ++uses_;
  machine.scene = scene;
  SceneOrder order{*machine.part_source, {}, around_.library.folder(), scene->unwanted.get_token()};
  const auto run = [this, name = machine.name, scene](const SceneOrder& ready) {
    const auto tell_ran = [&](std::string insight) {
      around_.answers.to_sockets([this, name, scene, insight = std::move(insight)]() mutable {
        ran(name, scene, std::move(insight));
      });
    };
    FeatureScene::Made done = guarded([&] { return SceneMaking(ready).make(tell_ran); });
    around_.answers.to_sockets([this, name, scene, done = std::move(done)]() mutable {
      made(name, scene, std::move(done));
    });
  };
  around_.disk.post([this, name = machine.name, scene, run, order = std::move(order)]() mutable {
    auto toml = guarded([&] { return around_.library.set_up(order.source.program); });
    if (!toml) {
      return around_.answers.to_sockets(
          [this, name, scene, why = toml.error()] { made(name, scene, tl::unexpected(why)); });
    }
    order.set_up = std::move(*toml);
    around_.worker.post({.work = [run, order = std::move(order)] { run(order); },
                         .unwanted = scene->unwanted.get_token(),
                         .owner = scene.get()});
  });
}

void Features::ran(const std::string& name, const Scene& scene, std::string insight) {
  thread_.here();
  MachineRecord* const machine = around_.machines.find(name);
  if (machine == nullptr || machine->scene != scene) return;
  scene->insight = std::move(insight);
  tell_insights();
}

// Whoever waits for a scene that does not hold any more waits for another one.
void Features::made(const std::string& name, const Scene& scene, FeatureScene::Made done) {
  thread_.here();
  MachineRecord* const machine = around_.machines.find(name);
  if (machine == nullptr || machine->scene != scene) return;
  if (!done) done.error().message = around_.answers.without_folder(done.error().message);
  scene->made = std::move(done);
  for (const FeatureScene::Waiting& each : std::exchange(scene->waiting, {}))
    each(answer_of(scene));
  tell_insights();
}

// Commands

void Features::features(const Request& request) {
  with_scene(*request.machine, [this, request](const Outcome<Scene>& scene) {
    if (!scene) return request.reply.no(scene.error());
    tell(request, *scene);
  });
}

void Features::tell(const Request& request, const Scene& scene) {
  const auto work = [this, request, scene] {
    const Method method = method_named(request.arguments().text("method"));
    const auto members = guarded([&]() -> Outcome<std::string> {
      return features_members(***scene->made, method, scene->revision);
    });
    if (!members) return around_.answers.answer(request.reply, tl::unexpected(members.error()));
    send(request.reply, *members);
  };
  around_.worker.post({.work = work, .unwanted = request.unwanted(), .owner = scene.get()});
}

void Features::send(const Reply& reply, const std::string& members) const {
  around_.answers.to_sockets([reply, text = reply.text_with(around_.answers.without_folder(
                                         members))]() mutable { reply.send(std::move(text)); });
}

// Behind the run and the preview run, whose findings it tells.
void Features::insight(const Request& request) {
  thread_.here();
  insights_.push_back(request);
  tell_insights();
}

void Features::tell_insights() {
  std::erase_if(insights_, [&](const Request& request) { return tell_insight(request); });
}

/// False: not yet.
bool Features::tell_insight(const Request& request) {
  MachineRecord* const machine = request.client->watched();
  const Reply& reply = request.reply;
  const auto refuse = [&](const base::Failure& why) { return reply.no(why), true; };
  if (machine == nullptr || machine != request.machine)
    return refuse(base::refuse(base::Refusal::features_left, {""}));
  if (!machine->part_source) return refuse(base::refuse(base::Refusal::no_program));
  if (!machine->scene) {
    make_room();
    make(*machine, {});
  }
  const Scene scene = machine->scene;
  if (scene->made && !*scene->made) return refuse(scene->made->error());
  if (!scene->insight || !machine->path || !machine->path->done) return false;
  std::string members = *scene->insight + "," + findings_members(machine->path->findings) +
                        revision_member(scene->revision) + ",";
  if (!scene->made) {
    send(reply, members + output::feature_insight_members({}));
    return true;
  }
  const auto work = [this, reply, scene, members = std::move(members)] {
    send(reply,
         members + output::feature_insight_members(job::facts_of((**scene->made)->features())));
  };
  around_.worker.post({.work = work, .unwanted = request.unwanted(), .owner = scene.get()});
  return true;
}

void Features::preview(const Request& request) {
  const Client* const client = request.client.get();
  const auto trial = std::make_shared<Trial>(Trial{request.reply});
  if (const auto before = std::exchange(trials_[client], trial)) {
    before->stop.request_stop();
    before->reply.no(base::Refusal::preview_replaced);
  }
  with_scene(*request.machine, [this, request, trial](const Outcome<Scene>& scene) {
    if (trial->stop.stop_requested()) return;
    if (scene) return try_edits(request, trial, *scene);
    tried(request.client.get(), trial, request.reply.text_of(tl::unexpected(scene.error())));
  });
}

void Features::try_edits(const Request& request, const std::shared_ptr<Trial>& trial,
                         const Scene& scene) {
  const auto work = [this, request, trial, scene] {
    // Whoever leaves wants it no more than who asks for another one.
    const std::stop_callback leaving(request.unwanted(), [&] { trial->stop.request_stop(); });
    const Arguments asked = request.arguments();
    const auto preview = guarded([&] {
      return job::preview_edits(***scene->made, asked.text("edits"),
                                until_named(asked.text("until")), trial->stop.get_token());
    });
    std::string answer =
        preview ? request.reply.text_with(around_.answers.without_folder(
                      output::edit_preview_members(*preview) + revision_member(scene->revision)))
                : request.reply.text_of(tl::unexpected(preview.error()));
    around_.answers.to_sockets(
        [this, client = request.client, trial, answer = std::move(answer)]() mutable {
          tried(client.get(), trial, std::move(answer));
        });
  };
  around_.worker.post({.work = work, .unwanted = trial->stop.get_token(), .owner = scene.get()});
}

// One that another has taken the place of is answered already.
void Features::tried(const Client* client, const std::shared_ptr<Trial>& trial,
                     std::string answer) {
  const auto found = trials_.find(client);
  if (found == trials_.end() || found->second != trial) return;
  trials_.erase(found);
  trial->reply.send(std::move(answer));
}

}  // namespace kerf::server
