// SPDX-License-Identifier: MIT
// Definitions of ode.hpp.
#pragma once

#include <ode/ode.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <trophic/backend/body_hash.hpp>
#include <trophic/backend/ode.hpp>
#include <trophic/backend/ode/groups.hpp>
#include <trophic/backend/ode/robot.hpp>
#include <trophic/backend/start_pose.hpp>
#include <trophic/habitat/validate_robot.hpp>
#include <trophic/params/params.hpp>

namespace trophic::backend {

/// The engine of an Ode: its robots' state and the worlds in which they are stepped.
class Ode::Simulation final : public Engine<State> {
 public:
  Simulation(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics,
             const Params& params)
      : setup_{std::make_unique<ode::Setup>(ode::Setup{.arena = arena, .physics = physics, .params = params})} {
    trophic::validate(physics, "physics");
    trophic::validate(params, "ode");
    check_model(robot);
    if (starts.empty()) throw std::invalid_argument{"robots = 0: must be >= 1"};
    for (std::size_t i = 0; i < starts.size(); ++i) check_start_pose(i, starts[i], setup_->arena);
    bodies_ = std::make_unique<ode::Bodies>(robot, starts.size());
    for (const Pose& start : starts) ode::append_at_rest(robot, start, state_.links);
    state_.angles_rad.assign(starts.size() * robot.hinges.size(), 0.0);
    state_.targets_rad.assign(starts.size() * robot.hinges.size(), 0.0);
    state_.bodies.assign(starts.size(), body_hash(robot));
    state_.absent.assign(starts.size(), 0);
    groups_ = std::make_unique<ode::Groups>(*setup_);
  }

  void advance_to(double time_s) override {
    while (this->time_s() < time_s - slack_s) {
      next_ = state_;
      ++next_.steps;
      if (const auto failure = groups_->step(*bodies_, next_)) {
        throw Diverged{static_cast<double>(next_.steps) * setup_->physics.timestep_s, failure->robot, failure->what};
      }
      std::swap(state_, next_);
    }
  }

  void embody(std::size_t robot, const RobotModel& model, const Pose& pose) override {
    static_cast<void>(checked(robot));
    check_model(model);
    check_start_pose(robot, pose, setup_->arena);
    const auto replace = [](auto& all, std::size_t first, std::size_t count, const auto& own) {
      const auto place = all.begin() + static_cast<std::ptrdiff_t>(first);
      all.insert(all.erase(place, place + static_cast<std::ptrdiff_t>(count)), own.begin(), own.end());
    };
    std::vector<ode::LinkState> links;
    ode::append_at_rest(model, pose, links);
    const std::vector<double> angles_rad(model.hinges.size());
    replace(state_.links, bodies_->first_link(robot), bodies_->links(robot), links);
    replace(state_.angles_rad, bodies_->first_hinge(robot), bodies_->hinges(robot), angles_rad);
    replace(state_.targets_rad, bodies_->first_hinge(robot), bodies_->hinges(robot), angles_rad);
    state_.absent[robot] = 0;
    if (state_.bodies[robot] == body_hash(model) && bodies_->model(robot).name == model.name) return;
    state_.bodies[robot] = body_hash(model);
    bodies_->replace(robot, model);
    groups_->forget_scenes();
  }
  void take_away(std::size_t robot) override { state_.absent[checked(robot)] = 1; }
  [[nodiscard]] bool is_there(std::size_t robot) const override { return state_.absent[checked(robot)] == 0; }
  [[nodiscard]] const RobotModel& model(std::size_t robot) const override { return bodies_->model(checked(robot)); }

  [[nodiscard]] std::size_t robots() const override { return bodies_->size(); }
  [[nodiscard]] double time_s() const override { return static_cast<double>(state_.steps) * setup_->physics.timestep_s; }

  [[nodiscard]] Pose pose(std::size_t robot) const override {
    const RobotModel& own = bodies_->model(checked(robot));
    return ode::link_frame(state_.links[bodies_->first_link(robot)], own.links[0]);
  }

  [[nodiscard]] std::span<const double> joint_angles(std::size_t robot) const override {
    const std::size_t hinges = bodies_->model(checked(robot)).hinges.size();
    return std::span{state_.angles_rad}.subspan(bodies_->first_hinge(robot), hinges);
  }

  /// Throws std::invalid_argument unless there is one finite target per hinge.
  void set_joint_targets(std::size_t robot, std::span<const double> targets_rad) override {
    const auto& hinges = bodies_->model(checked(robot)).hinges;
    if (targets_rad.size() != hinges.size()) {
      throw std::invalid_argument{"targets_rad.size() = " + std::to_string(targets_rad.size()) + ": must be " +
                                  std::to_string(hinges.size())};
    }
    const auto own = std::span{state_.targets_rad}.subspan(bodies_->first_hinge(robot), hinges.size());
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      if (!std::isfinite(targets_rad[i])) {
        throw std::invalid_argument{"targets_rad[" + std::to_string(i) + "] = " + number_text(targets_rad[i]) +
                                    ": must be finite"};
      }
    }
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      const double limit_rad = hinges[i].servo.target_limit_rad;
      own[i] = std::clamp(targets_rad[i], -limit_rad, limit_rad);
    }
  }

  [[nodiscard]] State save() const override { return state_; }

  /// Throws std::invalid_argument for a state with different bodies or a different number of robots.
  void restore(const State& state) override {
    const auto check_size = [](std::string_view field, std::size_t size, std::size_t expected) {
      if (size != expected) {
        throw std::invalid_argument{"state." + std::string{field} + ".size() = " + std::to_string(size) + ": must be " +
                                    std::to_string(expected)};
      }
    };
    check_size("links", state.links.size(), state_.links.size());
    check_size("angles_rad", state.angles_rad.size(), state_.angles_rad.size());
    check_size("targets_rad", state.targets_rad.size(), state_.targets_rad.size());
    check_size("absent", state.absent.size(), state_.absent.size());
    require_same_bodies(state.bodies, state_.bodies);
    state_ = state;
  }

 private:
  /// Tolerance for rounding, below which no step is taken.
  static constexpr double slack_s = 1e-9;

  static void check_model(const RobotModel& robot) {
    trophic::validate(robot);
    for (const Hinge& hinge : robot.hinges) {
      if (hinge.range_rad > ode::Robot::largest_range_rad) {
        throw std::invalid_argument{"robot " + robot.name + ": hinge \"" + hinge.name +
                                    "\" range_rad = " + number_text(hinge.range_rad) +
                                    ": must be <= " + number_text(ode::Robot::largest_range_rad) + " for ODE"};
      }
    }
  }

  [[nodiscard]] std::size_t checked(std::size_t robot) const {
    if (robot >= robots()) {
      throw std::out_of_range{"robot " + std::to_string(robot) + ": must be < " + std::to_string(robots())};
    }
    return robot;
  }

  std::unique_ptr<ode::Setup> setup_;
  std::unique_ptr<ode::Bodies> bodies_;
  std::unique_ptr<ode::Groups> groups_;
  ode::State state_;
  ode::State next_;
};

TROPHIC_INLINE std::string Ode::version() {
  return dODE_VERSION;
}
TROPHIC_INLINE std::vector<std::string> Ode::remarks(const Physics& physics) {
  if (physics.integrator == Integrator::semi_implicit_euler) return {};
  return {"physics.integrator = " + std::string{enum_name(physics.integrator)} +
          " has no effect: ode has its own semi-implicit Euler method"};
}

TROPHIC_INLINE Ode::Ode(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics,
                        const Params& params)
    : WithEngine{std::make_unique<Simulation>(robot, arena, starts, physics, params)} {}

}  // namespace trophic::backend
