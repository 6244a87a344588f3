// SPDX-License-Identifier: MIT
// Definitions of sight.hpp.
#include <tools/live/sight.hpp>

#include <algorithm>
#include <limits>
#include <span>
#include <trophic/io/agent_log.hpp>
#include <trophic/io/event_log.hpp>
#include <trophic/io/recording_head.hpp>
#include <utility>

namespace trophic::live {

void Sight::begin(const command::LiveRun& run) {
  facts_ = std::make_shared<RunFacts>();
  facts_->run = run;
  sight_ = std::make_shared<TickSight>();
  is_full_ = true;
  individuals_.clear();
  bodies_.clear();
  seen_.clear();
}

void Sight::on_start(const observe::RunDescription& run, const View& view) {
  facts_->description = run;
  facts_->robots = view.robots.size();
  for (Species species = 0; species < view.web.size(); ++species) facts_->species.push_back(view.web.name(species));
  steering_.begin(view.tick_s, run);
}

void Sight::on_change(const observe::RunDescription& run, const View&) {
  steering_.describe(run);
  server_.tell_state();
}

void Sight::on_frame(const observe::Frame& frame) {
  if (!facts_->robot) {
    facts_->robot = frame.robot;
    facts_->arena = frame.arena;
    facts_->times = frame.times;
    for (std::size_t robot = 0; robot < frame.roots.size(); ++robot) {
      facts_->joints = std::max(facts_->joints, frame.joint_angles(robot).size());
    }
    server_.begin(facts_message(*facts_));
    steering_.set_visible();
  }
  if (!frame.phenotypes.empty()) see_bodies(frame);
  TickSight::Moment moment{.time_s = frame.time_s, .roots = {frame.roots.begin(), frame.roots.end()}, .angles_rad = {}};
  for (std::size_t robot = 0; robot < frame.roots.size(); ++robot) {
    moment.joints = std::max(moment.joints, frame.joint_angles(robot).size());
  }
  for (std::size_t robot = 0; robot < frame.roots.size(); ++robot) {
    const std::span<const double> angles_rad = frame.joint_angles(robot);
    moment.angles_rad.insert(moment.angles_rad.end(), angles_rad.begin(), angles_rad.end());
    moment.angles_rad.resize((robot + 1) * moment.joints);
  }
  auto& places_m = seen_.emplace_back(frame.time_s, std::vector<Eigen::Vector3d>{}).second;
  for (const Pose& root : moment.roots) places_m.push_back(root.position_m);
  while (seen_.front().first < frame.time_s - command::replay::Scene::before_s) seen_.pop_front();
  sight_->frames.push_back(std::move(moment));
}

void Sight::see_bodies(const observe::Frame& frame) {
  individuals_.resize(frame.roots.size(), std::numeric_limits<std::uint64_t>::max());
  for (BodyIndex robot = 0; robot < frame.roots.size(); ++robot) {
    if (std::exchange(individuals_[robot], frame.phenotypes[robot].individual) == frame.phenotypes[robot].individual) continue;
    const std::string hash = hash_text(json_text(io::recording::json_of(frame.model(robot))));
    const auto [body, is_new] = bodies_.try_emplace(hash, bodies_.size());
    if (is_new) sight_->set_down.bodies.push_back(std::make_shared<RobotModel>(frame.model(robot)));
    sight_->set_down.time_s = frame.time_s;
    sight_->set_down.of_robots.emplace_back(robot, body->second);
  }
}

namespace {

command::replay::Partner partner(const Individual& one, std::size_t body, const View& view) {
  return {.id = one.id,
          .body = body,
          .species = view.web.name(one.species),
          .origin = std::string{enum_name(one.origin)},
          .born_s = one.born_s};
}

}  // namespace

void Sight::on_event(const observe::Event& event, const View& view) {
  const Individual& self = event.individual;
  sight_->events.push_back(io::event_row(event, view));
  if (event.kind != observe::EventKind::capture) return;
  const auto victim = std::ranges::find(view.robots, *event.other, &Individual::id);
  const auto body = static_cast<std::size_t>(victim - view.robots.begin());
  auto& scene = sight_->scenes.emplace_back(
      command::replay::scene_of(view.time_s, partner(self, event.body, view), partner(*victim, body, view)));
  const std::array tracks{track_of(event.body, scene.begins_s, view), track_of(body, scene.begins_s, view)};
  command::replay::frame(scene, tracks, view.arena);
}

command::replay::Track Sight::track_of(std::size_t body, double from_s, const View& view) const {
  const GroundPose& now = view.poses[body];
  command::replay::Track track{.places_m = {{now.x_m, now.y_m, 0.0}}, .radius_m = view.robot_radius_m};
  for (const auto& [time_s, places_m] : seen_) {
    if (time_s > from_s && body < places_m.size()) track.places_m.push_back(places_m[body]);
  }
  return track;
}

void Sight::on_decision(const observe::DecisionRecord& record, const View& view) {
  sight_->outputs.resize(view.robots.size());
  sight_->outputs[record.body].assign(record.outputs.begin(), record.outputs.end());
}

void Sight::on_tick(const View& view) {
  sight_->time_s = view.time_s;
  sight_->tick = view.tick;
  if (is_full_) {
    sight_->rows.reserve(view.robots.size());
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      sight_->rows.push_back(io::agent_row(view, body));
      sight_->are_spare.push_back(!view.robots[body].lives());
    }
    sight_->stock_J.resize(view.energy.size());
    for (const Individual& one : view.robots) {
      if (view.energy.empty()) break;
      sight_->energy_J.push_back(one.lives() ? one.energy_J : 0.0);
      if (one.lives()) sight_->stock_J[one.species] += one.energy_J;
    }
    for (std::size_t food = 0; food < view.foods.size(); ++food) {
      const std::span<const double> cells_J = view.foods[food].food_J();
      sight_->foods_J.emplace_back(view.food_names.empty() ? "food" : view.food_names[food],
                                   std::vector<double>{cells_J.begin(), cells_J.end()});
    }
  }
  server_.show(std::exchange(sight_, std::make_shared<TickSight>()), facts_);
  const double now_s = watch_.elapsed_s();
  if (is_full_) last_full_s_ = now_s;
  sight_->is_last = view.time_s + 1.5 * view.tick_s > facts_->run.until_s;
  is_full_ = sight_->is_last || steering_.is_paced() || now_s - last_full_s_ >= least_gap_s;
}

}  // namespace trophic::live
