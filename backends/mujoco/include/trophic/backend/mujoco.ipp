// SPDX-License-Identifier: MIT
// Definitions of mujoco.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <trophic/backend/body_hash.hpp>
#include <trophic/backend/mujoco.hpp>
#include <trophic/backend/mujoco/agreement.hpp>
#include <trophic/backend/mujoco/islands.hpp>
#include <trophic/backend/mujoco/lane_step.hpp>
#include <trophic/backend/mujoco/one_model.hpp>
#include <trophic/backend/mujoco/robot_states.hpp>
#include <trophic/backend/mujoco/save_mjcf.hpp>
#include <trophic/backend/start_pose.hpp>
#include <trophic/habitat/validate_robot.hpp>
#include <variant>

namespace trophic::backend {

/// The engine of a Mujoco: its robots, their states, and the models in which they are stepped.
class Mujoco::Simulation final : public Engine<State> {
 public:
  Simulation(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics,
             const Params& params)
      : bodies_(starts.size(), make_body(robot)),
        arena_{arena},
        physics_{checked(physics, params, starts.size())},
        box_depth_{params.box_depth},
        stepping_{params.stepping},
        steps_per_block_{static_cast<std::size_t>(std::ceil(block_s / physics.timestep_s))},
        stepper_{make_stepper(robot, starts.size(), params.threads)},
        states_{layout_of(0), starts.size(), arena.extent_m},
        next_{states_},
        targets_rad_{starts.size(), robot.hinges.size()},
        angles_rad_{targets_rad_} {
    for (std::size_t i = 0; i < starts.size(); ++i) {
      check_start_pose(i, starts[i], arena_);
      states_.set_root(i, starts[i]);
    }
  }

  void advance_to(double time_s) override {
    const double steps = std::ceil((time_s - slack_s) / physics_.timestep_s);
    if (!(steps > static_cast<double>(steps_))) return;
    const auto goal = static_cast<std::uint64_t>(steps);
    while (steps_ < goal) advance(std::min<std::size_t>(steps_per_block_, goal - steps_));
  }

  void set_joint_targets(std::size_t robot, std::span<const double> targets_rad) override {
    const std::vector<Hinge>& hinges = bodies_[checked(robot)]->model.hinges;
    if (targets_rad.size() != hinges.size()) {
      throw std::invalid_argument{"joint targets of robot " + std::to_string(robot) + ": " + std::to_string(targets_rad.size()) +
                                  " numbers: must be " + std::to_string(hinges.size())};
    }
    const std::span<double> own = targets_rad_[robot];
    for (std::size_t i = 0; i < hinges.size(); ++i) {
      const double limit_rad = hinges[i].servo.target_limit_rad;
      if (!std::isfinite(targets_rad[i])) {
        throw std::invalid_argument{"joint target " + std::to_string(i) + " of robot " + std::to_string(robot) + " = " +
                                    number_text(targets_rad[i]) + ": must be finite"};
      }
      own[i] = std::clamp(targets_rad[i], -limit_rad, limit_rad);
    }
  }

  void embody(std::size_t robot, const RobotModel& model, const Pose& pose) override {
    check_start_pose(checked(robot), pose, arena_);
    std::shared_ptr<const Body> body = make_body(model);
    const std::size_t kind = std::visit([&](auto& stepper) { return stepper.set_body(robot, model); }, stepper_);
    bodies_[robot] = std::move(body);
    states_.set_body(robot, kind, layout_of(robot));
    states_.set_there(robot, true);
    states_.set_root(robot, pose);
    next_ = states_;
    targets_rad_.reset(robot, model.hinges.size());
    angles_rad_.reset(robot, model.hinges.size());
  }

  void take_away(std::size_t robot) override {
    states_.set_there(checked(robot), false);
    next_ = states_;
  }
  [[nodiscard]] bool is_there(std::size_t robot) const override { return states_.is_there(checked(robot)); }

  [[nodiscard]] const RobotModel& model(std::size_t robot) const override { return bodies_[checked(robot)]->model; }
  [[nodiscard]] double engine_share() const {
    const auto* const islands = std::get_if<mujoco::Islands>(&stepper_);
    return islands != nullptr ? islands->engine_share() : 1.0;
  }
  [[nodiscard]] std::string speed_remark(bool asked) const {
    if (!by_kernel() || engine_share() <= 0.5) return asked ? profile() : "";
    return "backend.stepping = " + std::string{enum_name(stepping_)} + ": MuJoCo itself computed " +
           number_text(std::round(100.0 * engine_share())) +
           " % of the robots' steps, so the run is as slow as with islands; the README of the MuJoCo backend lists the steps "
           "that its kernel leaves to MuJoCo";
  }
  [[nodiscard]] std::size_t robots() const override { return states_.robots(); }
  [[nodiscard]] double time_s() const override { return static_cast<double>(steps_) * physics_.timestep_s; }
  [[nodiscard]] Pose pose(std::size_t robot) const override { return states_.root(checked(robot)); }
  [[nodiscard]] std::span<const double> joint_angles(std::size_t robot) const override {
    const std::vector<std::size_t>& index = layout_of(checked(robot)).angle_index;
    for (std::size_t i = 0; i < index.size(); ++i) angles_rad_[robot][i] = states_.positions(robot)[index[i]];
    return angles_rad_[robot];
  }

  [[nodiscard]] State save() const override {
    return {steps_, states_.values(), targets_rad_.values(), body_hashes(), states_.absent()};
  }

  void restore(const State& state) override {
    require_same_bodies(state.bodies, body_hashes());
    const auto check_size = [](const std::string& field, std::size_t size, std::size_t expected) {
      if (size == expected) return;
      throw std::invalid_argument{"state." + field + ".size() = " + std::to_string(size) + ": must be " +
                                  std::to_string(expected)};
    };
    check_size("robots", state.robots.size(), states_.values().size());
    check_size("targets_rad", state.targets_rad.size(), targets_rad_.values().size());
    steps_ = state.steps;
    states_.set_values(state.robots);
    states_.set_absent(state.absent);
    next_ = states_;
    targets_rad_.set_values(state.targets_rad);
  }

  void save_mjcf(const std::filesystem::path& path, std::span<const Colour> colours) const {
    std::vector<const RobotModel*> models;
    for (const auto& body : bodies_) models.push_back(&body->model);
    mujoco::save_mjcf(path, models, arena_, physics_, box_depth_, states_, targets_rad_, colours);
  }

 private:
  /// The period after which robots are grouped anew: the usual period of controllers.
  static constexpr double block_s = 1.0 / 60.0;
  /// Tolerance for rounding, below which no step is taken.
  static constexpr double slack_s = 1e-9;

  [[nodiscard]] std::size_t checked(std::size_t robot) const {
    if (robot >= robots()) {
      throw std::out_of_range{"robot " + std::to_string(robot) + ": must be < " + std::to_string(robots())};
    }
    return robot;
  }

  struct Body {
    RobotModel model;
    mujoco::Layout layout;
    std::uint64_t hash;
  };

  [[nodiscard]] static std::shared_ptr<const Body> make_body(const RobotModel& robot) {
    validate(robot);
    return std::make_shared<const Body>(Body{robot, mujoco::layout_of(robot, mujoco::Servos::combined), body_hash(robot)});
  }
  [[nodiscard]] std::vector<std::uint64_t> body_hashes() const {
    std::vector<std::uint64_t> hashes;
    for (const auto& body : bodies_) hashes.push_back(body->hash);
    return hashes;
  }
  [[nodiscard]] const mujoco::Layout& layout_of(std::size_t robot) const { return bodies_[robot]->layout; }

  [[nodiscard]] std::string profile() const {
    if (!by_kernel()) return "backend.stepping = " + std::string{enum_name(stepping_)} + " does not count steps";
    const auto counts = std::get<mujoco::Islands>(stepper_).counts();
    const auto all = std::max<std::uint64_t>(1, counts[0] + counts[1] + counts[2] + counts[3]);
    const auto share = [&](std::size_t k) { return number_text(static_cast<double>(1000 * counts.at(k) / all) / 10.0) + " % "; };
    return std::to_string(all) + " steps of " + (stepping_ == Stepping::screening ? "eight" : "four") +
           " robots or fewer: " + share(0) + "apart, " + share(1) + "a robot touches itself or a height field, " + share(2) +
           "two touch, " + share(3) + "more";
  }

  static const Physics& checked(const Physics& physics, const Params& params, std::size_t robots) {
    validate(physics, "physics");
    validate(params, "mujoco");
    Physics own = physics;
    static_cast<void>(params.prescribe(own, {.timestep_s = screening_timestep_s}));
    if (robots == 0) throw std::invalid_argument{"robots = 0: must be >= 1"};
    return physics;
  }

  using Stepper = std::variant<mujoco::Islands, mujoco::OneModel>;

  [[nodiscard]] bool by_kernel() const { return stepping_ == Stepping::fast || stepping_ == Stepping::screening; }

  [[nodiscard]] std::unique_ptr<mujoco::LaneStepper> make_lanes(std::size_t threads) const {
    if (mujoco::is_untried && by_kernel()) {
      static const double disagreement = mujoco::kernel_disagreement();
      mujoco::require_agreement(disagreement);
    }
    if (stepping_ == Stepping::fast) return std::make_unique<mujoco::Lanes>(box_depth_, threads);
    return stepping_ == Stepping::screening ? mujoco::lanes_in_single(box_depth_, threads) : nullptr;
  }

  [[nodiscard]] Stepper make_stepper(const RobotModel& robot, std::size_t robots, std::size_t threads) const {
    if (stepping_ == Stepping::one_model) {
      return Stepper{std::in_place_type<mujoco::OneModel>, robot, arena_, physics_, robots, box_depth_};
    }
    return Stepper{std::in_place_type<mujoco::Islands>, robot, arena_, physics_, threads, box_depth_, make_lanes(threads)};
  }

  void advance(std::size_t steps) {
    mujoco::GroupResult result =
        std::visit([&](auto& stepper) { return stepper.advance(states_, targets_rad_, steps, next_); }, stepper_);
    if (result.end != mujoco::GroupResult::End::done) {
      throw Diverged{static_cast<double>(steps_ + result.steps) * physics_.timestep_s, result.robot, result.what};
    }
    std::swap(states_, next_);
    steps_ += steps;
  }

  std::vector<std::shared_ptr<const Body>> bodies_;  ///< one per robot
  Arena arena_;
  Physics physics_;
  mujoco::BoxDepth box_depth_;
  Stepping stepping_;
  std::size_t steps_per_block_;
  Stepper stepper_;
  mujoco::RobotStates states_;
  mujoco::RobotStates next_;  ///< the target of a block of steps, until it is checked
  std::uint64_t steps_ = 0;
  mujoco::Rows targets_rad_;
  mutable mujoco::Rows angles_rad_;  ///< the requested angles, in the order of the hinges
};

#if TROPHIC_HEADER_ONLY || defined(TROPHIC_FEW_KERNELS)
inline std::unique_ptr<mujoco::LaneStepper> mujoco::lanes_in_single(BoxDepth, std::size_t) {
  throw std::invalid_argument{
      "backend.stepping = screening: this program has no kernel for it; build trophic with TROPHIC_ALL_KERNELS"};
}
#endif

TROPHIC_INLINE std::string Mujoco::version() {
  return mj_versionString();
}

TROPHIC_INLINE std::string Mujoco::Params::prescribe(Physics& physics, const Physics& table) const {
  if (stepping != Stepping::screening) return {};
  static_cast<void>(mujoco::lanes_in_single(box_depth, 1));  // throws in a program without it, before any work
  const std::string step = number_text(screening_timestep_s);
  const auto refuse_if = [](bool is_refused, const std::string& what, const std::string& must) {
    if (is_refused) throw std::invalid_argument{"physics." + what + " with backend.stepping = screening: must be " + must};
  };
  refuse_if(physics.integrator != Integrator::semi_implicit_euler, "integrator = rk4", "semi_implicit_euler");
  refuse_if(physics.timestep_s != table.timestep_s && physics.timestep_s != screening_timestep_s,
            "timestep_s = " + number_text(physics.timestep_s), step);
  physics.timestep_s = screening_timestep_s;
  return "backend.stepping = screening: uses single precision and steps of " + step + " s, but the table has " +
         number_text(table.timestep_s) + " s; this is for previews only: use backend.stepping = fast for results";
}

TROPHIC_INLINE Mujoco::Mujoco(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics,
                              const Params& params)
    : WithEngine{std::make_unique<Simulation>(robot, arena, starts, physics, params)} {}

TROPHIC_INLINE double Mujoco::engine_share() const {
  return static_cast<const Simulation&>(engine()).engine_share();
}
TROPHIC_INLINE std::string Mujoco::speed_remark(bool asked) const {
  return static_cast<const Simulation&>(engine()).speed_remark(asked);
}
TROPHIC_INLINE void Mujoco::save_mjcf(const std::filesystem::path& path, std::span<const Colour> colours) const {
  static_cast<const Simulation&>(engine()).save_mjcf(path, colours);
}

}  // namespace trophic::backend
