// SPDX-License-Identifier: MIT
// One step of all robots: those that cannot touch are stepped in separate worlds, on several threads.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <trophic/backend/clusters.hpp>
#include <trophic/backend/contract.hpp>
#include <trophic/backend/ode/bodies.hpp>
#include <trophic/backend/ode/engine.hpp>
#include <trophic/backend/ode/params.hpp>
#include <trophic/backend/ode/scene.hpp>
#include <trophic/backend/ode/state.hpp>
#include <trophic/support/thread_pool.hpp>

namespace trophic::backend::ode {

/// The constructor arguments of a backend.
struct Setup {
  Arena arena;
  Physics physics;
  Params params;
};

/// A robot for which a step failed.
struct Failure {
  std::size_t robot = 0;
  std::string what;
};

/// Groups are formed again at each step from the positions of robots: connected sets of overlapping bounding spheres, seen from
/// above. Groups and their order therefore depend on the state alone, not on the number of threads or the division of time into
/// calls.
class Groups {
 public:
  explicit Groups(const Setup& setup) : setup_{setup}, pool_{setup.params.threads}, scenes_(setup.params.threads) {}

  /// Steps `state` of these robots. Returns the failure of the first robot, if any; `state` is then invalid.
  [[nodiscard]] std::optional<Failure> step(const Bodies& bodies, State& state) {
    discs_.clear();
    for (std::size_t robot = 0; robot < bodies.size(); ++robot) {
      const auto& at_m = state.links[bodies.first_link(robot)].position_m;
      const double radius_m = bodies.kind(robot)->reach_m + drift_m;
      discs_.push_back({.x_m = at_m[0], .y_m = at_m[1], .radius_m = state.absent[robot] == 0 ? radius_m : -1.0});
    }
    const std::vector<std::vector<std::size_t>> groups = connected_sets(discs_);
    std::vector<std::optional<Failure>> failures(groups.size());
    pool_.run(groups.size(),
              [&](std::size_t i, std::size_t thread) { failures[i] = step_group(groups[i], thread, bodies, state); });
    std::optional<Failure> first;
    for (std::optional<Failure>& failure : failures) {
      if (failure && (!first || failure->robot < first->robot)) first = std::move(failure);
    }
    return first;
  }

  /// Drops the scenes with bodies that no robot has any longer.
  void forget_scenes() {
    const EngineGuard guard;
    for (Scenes& scenes : scenes_) scenes.clear();
  }

 private:
  /// Scenes by the kinds of their robots, in the order of the robots.
  using Scenes = std::map<std::vector<KindPtr>, std::unique_ptr<Scene>>;

  /// A scene takes a few kilobytes per robot and is quickly made, but a crowd of many kinds needs many.
  static constexpr std::size_t most_scenes = 256;
  /// Larger than the separation of hinges under load.
  static constexpr double drift_m = 0.005;
  /// No time step resolves faster motion.
  static constexpr double most_m_s = 1e3;
  static constexpr double most_rad_s = 1e4;

  [[nodiscard]] std::optional<Failure> step_group(std::span<const std::size_t> members, std::size_t thread, const Bodies& bodies,
                                                  State& state) {
    const EngineGuard guard;
    std::vector<KindPtr> kinds;
    for (const std::size_t robot : members) kinds.push_back(bodies.kind(robot));
    if (scenes_[thread].size() > most_scenes) scenes_[thread].clear();
    std::unique_ptr<Scene>& scene = scenes_[thread][kinds];
    try {
      if (!scene) scene = std::make_unique<Scene>(std::move(kinds), setup_.arena, setup_.physics, setup_.params);
      scene->step(members, bodies, state);
    } catch (const EngineError& error) {
      static_cast<void>(scene.release());  // ODE cannot destroy a world in which it was interrupted
      const std::string others =
          members.size() == 1 ? "" : ", in the world of this robot and " + std::to_string(members.size() - 1) + " others";
      return Failure{.robot = members[0], .what = error.what() + others};
    }
    for (const std::size_t robot : members) {
      for (std::size_t link = 0; link < bodies.links(robot); ++link) {
        const std::string_view what =
            trouble(state.links[bodies.first_link(robot) + link], bodies.kind(robot)->reach_m + drift_m);
        if (!what.empty()) return Failure{robot, "link \"" + bodies.model(robot).links[link].name + "\" " + std::string{what}};
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string_view trouble(const LinkState& link, double reach_m) const {
    const auto within = [](const auto& values, double most) {
      return std::ranges::all_of(values, [most](double value) { return std::abs(value) <= most; });
    };
    if (!within(link.rotation, 1.1)) return "has no finite rotation";
    if (!within(link.velocity_m_s, most_m_s)) return "is faster than 1 km/s";
    if (!within(link.spin_rad_s, most_rad_s)) return "spins faster than 1e4 rad/s";
    if (!within(link.position_m, setup_.arena.extent_m + reach_m)) return "is beyond the arena's extent";
    return {};
  }

  const Setup& setup_;
  ThreadPool pool_;
  std::vector<Scenes> scenes_;  ///< one per thread
  std::vector<Disc> discs_;
};

}  // namespace trophic::backend::ode
