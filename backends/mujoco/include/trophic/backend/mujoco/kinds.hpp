// SPDX-License-Identifier: MIT
// The bodies of robots: robots with equal bodies are of the same kind.
#pragma once

#include <algorithm>
#include <memory>
#include <trophic/backend/mujoco/compiled_model.hpp>
#include <trophic/backend/mujoco/kernel/body.hpp>
#include <trophic/habitat/robot_model.hpp>

namespace trophic::backend::mujoco {

/// Whether two robots have the same dynamics; their names and gaits may differ.
[[nodiscard]] inline bool same_body(const RobotModel& a, const RobotModel& b) {
  const auto same_box = [](const Box& x, const Box& y) {
    return x.half_extents_m == y.half_extents_m && x.centre_m == y.centre_m && x.orientation.coeffs() == y.orientation.coeffs();
  };
  const auto same_link = [&](const Link& x, const Link& y) {
    return x.parent == y.parent && x.offset_m == y.offset_m && x.rotation.coeffs() == y.rotation.coeffs() &&
           x.mass_kg == y.mass_kg && x.centre_of_mass_m == y.centre_of_mass_m && x.inertia_kgm2 == y.inertia_kgm2 &&
           std::ranges::equal(x.boxes, y.boxes, same_box);
  };
  const auto same_hinge = [](const Hinge& x, const Hinge& y) {
    return x.axis == y.axis && x.range_rad == y.range_rad && x.servo.position_gain == y.servo.position_gain &&
           x.servo.velocity_gain == y.servo.velocity_gain && x.servo.target_limit_rad == y.servo.target_limit_rad;
  };
  return a.friction == b.friction && a.bounding_radius_m == b.bounding_radius_m &&
         std::ranges::equal(a.links, b.links, same_link) && std::ranges::equal(a.hinges, b.hinges, same_hinge);
}

/// A body that robots have or had.
struct Kind {
  RobotModel robot;
  std::shared_ptr<const kernel::KernelModel> constants;  ///< empty: MuJoCo steps its robots
  std::size_t shape = 0;                                 ///< the number of its shape, see `kernel::same_shape`
  std::uint64_t last_used = 0;
};

/// The kinds of bodies, by index. The index of a dropped kind or shape is reused.
class Kinds {
 public:
  [[nodiscard]] const Kind& operator[](std::size_t kind) const { return *kinds_[kind]; }
  [[nodiscard]] std::size_t count() const {
    return kinds_.size() - static_cast<std::size_t>(std::count(kinds_.begin(), kinds_.end(), nullptr));
  }
  void use(std::size_t kind, std::uint64_t now) { kinds_[kind]->last_used = now; }

  /// The index of a robot's kind; `make` makes a new one.
  template <class Make>
  [[nodiscard]] std::size_t find(const RobotModel& robot, std::uint64_t now, const Make& make) {
    auto known = std::ranges::find_if(kinds_, [&](const auto& kind) { return kind && same_body(kind->robot, robot); });
    if (known == kinds_.end()) {
      std::unique_ptr<Kind> made = make(robot);
      if (made->constants) made->shape = find_shape(*made->constants);
      known = std::find(kinds_.begin(), kinds_.end(), nullptr);
      if (known == kinds_.end()) known = kinds_.insert(known, nullptr);
      *known = std::move(made);
    }
    (*known)->last_used = now;
    return static_cast<std::size_t>(known - kinds_.begin());
  }

  /// Drops the kinds that were last used before `time`.
  void drop_before(std::uint64_t time) {
    for (auto& kind : kinds_) {
      if (kind && kind->last_used < time) kind.reset();
    }
  }
  [[nodiscard]] bool is_known(std::size_t kind) const { return kinds_[kind] != nullptr; }

 private:
  /// The number of the shape of a known kind, or the least that is not in use.
  [[nodiscard]] std::size_t find_shape(const kernel::KernelModel& body) const {
    std::vector<bool> used(kinds_.size() + 1);
    for (const auto& kind : kinds_) {
      if (!kind || !kind->constants) continue;
      if (kernel::same_shape(*kind->constants, body)) return kind->shape;
      used[kind->shape] = true;
    }
    return static_cast<std::size_t>(std::ranges::find(used, false) - used.begin());
  }

  std::vector<std::unique_ptr<Kind>> kinds_;
};

}  // namespace trophic::backend::mujoco
