// SPDX-License-Identifier: MIT
// A type-erased backend, for the ecology and its locomotion.
#pragma once

#include <any>
#include <trophic/backend/contract.hpp>
#include <trophic/support/colour.hpp>

namespace trophic {

/// The bodies of one run in a backend of any type. Each function follows the contract of backends. An ecology calls them about 60
/// times per second and robot, so the cost of virtual calls is negligible.
class AnyBackend {
 public:
  AnyBackend(const AnyBackend&) = delete;
  AnyBackend& operator=(const AnyBackend&) = delete;
  virtual ~AnyBackend() = default;

  virtual void advance_to(double time_s) = 0;
  [[nodiscard]] virtual std::size_t robots() const = 0;
  [[nodiscard]] virtual double time_s() const = 0;
  [[nodiscard]] virtual Pose pose(std::size_t robot) const = 0;
  [[nodiscard]] virtual std::span<const double> joint_angles(std::size_t robot) const = 0;

  /// Whether robots are driven by joint targets; otherwise by the target angle alone.
  [[nodiscard]] virtual bool has_joints() const = 0;
  /// Throws std::logic_error if the backend has no joints.
  virtual void set_joint_targets(std::size_t robot, std::span<const double> targets_rad) = 0;
  /// Throws std::logic_error if the backend has joints.
  virtual void set_target_angle(std::size_t robot, double target_angle_rad) = 0;
  /// Throws std::invalid_argument if the backend has joints or no paces.
  virtual void set_pace(std::size_t robot, double pace) = 0;

  /// Throws std::logic_error if the backend cannot exchange bodies (Embodying).
  virtual void embody(std::size_t robot, const RobotModel& model, const Pose& pose) = 0;

  /// Whether robots that leave the arena re-enter it on the other side (the backend's `is_periodic`).
  [[nodiscard]] virtual bool is_periodic() const = 0;
  /// Both throw std::logic_error if robots cannot be removed and added (Placing).
  virtual void take_away(std::size_t robot) = 0;
  virtual void place(std::size_t robot, const Pose& pose) = 0;
  /// True for all robots of a backend without Placing.
  [[nodiscard]] virtual bool is_there(std::size_t robot) const = 0;

  /// Returns a sentence if the backend was much slower than it promises, or a profile of its steps if `asked` (the backend's
  /// speed_remark).
  [[nodiscard]] virtual std::string speed_remark(bool asked = false) const = 0;
  /// The share of steps that the engine itself computed (the backend's engine_share()); 0 without such a function.
  [[nodiscard]] virtual double engine_share() const = 0;
  /// Writes the engine's model with robots in these colours (the backend's save_mjcf). Returns false for an engine without such a
  /// file.
  [[nodiscard]] virtual bool save_mjcf(const std::string& path, std::span<const Colour> colours) const = 0;

  /// The backend's State, for `restore` of the same AnyBackend.
  [[nodiscard]] virtual std::any save() const = 0;
  virtual void restore(const std::any& state) = 0;
  /// Writes the backend's State to an archive, or reads and restores it.
  virtual void persist(Archive& archive) = 0;

  /// The backend itself; null if it is not a B.
  template <Backend B>
  [[nodiscard]] const B* as() const;

 protected:
  AnyBackend() = default;
};

/// The bodies of one run in a backend of type B.
template <Backend B>
class BackendOf final : public AnyBackend {
  static_assert(JointDriven<B> || SteeringDriven<B>,
                "a backend needs void set_joint_targets(std::size_t robot, std::span<const double> targets_rad) or "
                "void set_target_angle(std::size_t robot, double target_angle_rad); see trophic/backend/contract.hpp");

 public:
  /// Throws as B's constructor does.
  BackendOf(const RobotModel& robot, const Arena& arena, std::span<const Pose> starts, const Physics& physics,
            const typename B::Params& params)
      : backend(robot, arena, starts, physics, params) {}

  void advance_to(double time_s) override { backend.advance_to(time_s); }
  [[nodiscard]] std::size_t robots() const override { return backend.robots(); }
  [[nodiscard]] double time_s() const override { return backend.time_s(); }
  [[nodiscard]] Pose pose(std::size_t robot) const override { return backend.pose(robot); }
  [[nodiscard]] std::span<const double> joint_angles(std::size_t robot) const override { return backend.joint_angles(robot); }
  [[nodiscard]] bool has_joints() const override { return JointDriven<B>; }
  void set_joint_targets([[maybe_unused]] std::size_t robot, [[maybe_unused]] std::span<const double> targets_rad) override {
    if constexpr (JointDriven<B>) {
      backend.set_joint_targets(robot, targets_rad);
    } else {
      throw std::logic_error{"backend " + std::string{B::name} + ": has no joints whose targets can be set"};
    }
  }
  void set_target_angle([[maybe_unused]] std::size_t robot, [[maybe_unused]] double target_angle_rad) override {
    if constexpr (SteeringDriven<B> && !JointDriven<B>) {
      backend.set_target_angle(robot, target_angle_rad);
    } else {
      throw std::logic_error{"backend " + std::string{B::name} + ": is driven by joint targets, not by a target angle"};
    }
  }
  void set_pace([[maybe_unused]] std::size_t robot, [[maybe_unused]] double pace) override {
    if constexpr (requires { backend.set_pace(robot, pace); }) {
      backend.set_pace(robot, pace);
    } else {
      throw std::invalid_argument{"rules.pace, rules.acts: backend " + std::string{B::name} + " has one pace for all: it needs " +
                                  "void set_pace(std::size_t robot, double pace)"};
    }
  }
  void embody([[maybe_unused]] std::size_t robot, [[maybe_unused]] const RobotModel& model,
              [[maybe_unused]] const Pose& pose) override {
    if constexpr (Embodying<B>) {
      backend.embody(robot, model, pose);
    } else {
      throw std::logic_error{"backend " + std::string{B::name} + ": cannot exchange bodies"};
    }
  }
  [[nodiscard]] bool is_periodic() const override {
    if constexpr (requires { B::is_periodic; }) return B::is_periodic;
    return false;
  }
  void take_away([[maybe_unused]] std::size_t robot) override {
    if constexpr (Placing<B>) {
      backend.take_away(robot);
    } else {
      throw std::logic_error{"backend " + std::string{B::name} + ": cannot remove robots"};
    }
  }
  void place([[maybe_unused]] std::size_t robot, [[maybe_unused]] const Pose& pose) override {
    if constexpr (Placing<B>) {
      backend.place(robot, pose);
    } else {
      throw std::logic_error{"backend " + std::string{B::name} + ": cannot place robots"};
    }
  }
  [[nodiscard]] bool is_there([[maybe_unused]] std::size_t robot) const override {
    if constexpr (Placing<B>) return backend.is_there(robot);
    return true;
  }
  [[nodiscard]] std::string speed_remark(bool asked) const override {
    if constexpr (requires { backend.speed_remark(asked); }) return backend.speed_remark(asked);
    std::string slow;
    if constexpr (requires { backend.speed_remark(); }) slow = backend.speed_remark();
    return asked && slow.empty() ? "backend " + std::string{B::name} + " does not count steps" : slow;
  }
  [[nodiscard]] double engine_share() const override {
    if constexpr (requires { backend.engine_share(); }) return backend.engine_share();
    return 0.0;
  }
  [[nodiscard]] bool save_mjcf([[maybe_unused]] const std::string& path,
                               [[maybe_unused]] std::span<const Colour> colours) const override {
    if constexpr (requires { backend.save_mjcf(path, colours); }) {
      backend.save_mjcf(path, colours);
      return true;
    }
    return false;
  }
  [[nodiscard]] std::any save() const override { return backend.save(); }
  void restore(const std::any& state) override { backend.restore(std::any_cast<const typename B::State&>(state)); }
  void persist(Archive& archive) override {
    typename B::State state = backend.save();
    archive(state);
    if (archive.reads()) backend.restore(state);
  }

  B backend;
};

template <Backend B>
const B* AnyBackend::as() const {
  const auto* own = dynamic_cast<const BackendOf<B>*>(this);
  return own == nullptr ? nullptr : &own->backend;
}

}  // namespace trophic
