// SPDX-License-Identifier: MIT
// The robots of an ecology: where they stand, how they move, and the bodies and gaits of newborns.
#pragma once

#include <algorithm>
#include <any>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <trophic/backend/any_backend.hpp>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/backend/contract.hpp>
#include <trophic/control/locomotion/locomotion.hpp>
#include <trophic/ecology/checks.hpp>
#include <trophic/ecology/embody.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/frames.hpp>
#include <trophic/ecology/population.hpp>
#include <trophic/ecology/standing_poses.hpp>
#include <trophic/ecology/start.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/initialization/embodiment/contract.hpp>
#include <trophic/observe/audience.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/rules/table.hpp>
#include <vector>

namespace trophic {

/// The robots of a population in a backend. Each has the body and the gait of its individual's phenotype; if these differ,
/// `embody` sets a newborn's body down and starts its gait.
template <class Rules>
class Bodies {
 public:
  /// `population` holds the founders. All arguments outlive the bodies.
  Bodies(const Experiment<Rules>& params, const BackendChoice& choice, const Habitat& habitat, const Policies<Rules>& rules,
         Population<Rules>& population)
      : rules_{rules},
        habitat_{habitat},
        population_{population},
        poses_{places_of(params, rules, habitat)},
        backend_{choice.build(habitat.robot, habitat.arena, standing_poses(poses_, habitat.robot), params.physics)},
        locomotion_{habitat.robot,
                    habitat.gait,
                    rules.steering,
                    params.ecology.robots,
                    params.ecology.control_hz,
                    params.ecology.cpg_integration,
                    static_cast<std::int64_t>(params.ecology.idle_control_steps)} {
    if constexpr (differ) locomotion_.separate();
    population_.stand_at(poses_);
  }

  [[nodiscard]] std::span<const GroundPose> poses() const { return poses_; }
  [[nodiscard]] const AnyBackend& backend() const { return backend_; }
  [[nodiscard]] KeptFrame frame() const { return KeptFrame::of(backend_, 0); }

  /// Restarts the gait of a body.
  void restart(BodyIndex body) { locomotion_.reset(body); }

  /// Gives a body the phenotype of its individual. Founders are embodied in order, each among those before it.
  void embody([[maybe_unused]] BodyIndex body, [[maybe_unused]] std::size_t standing) {
    if constexpr (has_bodies) {
      const RobotModel& robot = robot_in(body, population_.phenotypes(), habitat_);
      const auto others =
          boxes_near(poses_[body], robot.bounding_radius_m, body, standing, backend_, population_.phenotypes(), habitat_);
      const Pose pose = rules_.embodiment.set_down(poses_[body], robot, habitat_.arena, others);
      backend_.embody(body, robot, pose);
      poses_[body] = on_ground(body);
      population_.stand_at(poses_);
    }
    if constexpr (differ) walk_by(body);
  }
  void embody_founders() {
    for (BodyIndex body = 0; differ && body < poses_.size(); ++body) embody(body, body);
  }

  /// Moves all bodies through the tick that begins at `clock_s`. Returns false, with everything as before, if an observer
  /// cancelled it. If the table lets a body that diverges end its individual, `end(body)` is called and the tick begins anew. If
  /// a body diverges again and again although it was replaced, those next to it end, which it may touch.
  template <class End>
  [[nodiscard]] bool move(observe::Audience& audience, const observe::FrameTimes& times, double clock_s, const End& end) {
    for (std::vector<BodyIndex> ended; true;) {
      std::optional<Before> before;
      if (ends_individuals() && ended.size() < most_ended) before.emplace(Before{backend_.save(), locomotion_.save()});
      try {
        if (!advance(audience, times, clock_s)) return false;
        break;
      } catch (const Diverged& diverged) {
        if (!before) throw;
        backend_.restore(before->bodies);
        locomotion_.restore(before->rhythms);
        ended.push_back(cause_of(diverged.robot(), ended));
        end(ended.back());
      }
    }
    poses_before_ = poses_;
    for (BodyIndex body = 0; body < poses_.size(); ++body) poses_[body] = on_ground(body);
    population_.stand_at(poses_);
    return true;
  }
  [[nodiscard]] std::span<const GroundPose> poses_before() const { return poses_before_; }

  /// After the population's. Bodies and gaits are expressed again.
  void persist(Archive& archive) {
    archive(poses_);
    if (archive.reads()) {
      detail::check_saved_poses(poses_, population_.individuals().size());
      for (BodyIndex body = 0; differ && body < poses_.size(); ++body) take_shape(body);
    }
    auto rhythms = locomotion_.save();
    archive(rhythms, backend_);
    if (!archive.reads()) return;
    locomotion_.restore(rhythms);
    population_.stand_at(poses_);
  }

 private:
  static constexpr bool differ = Population<Rules>::differ;
  static constexpr bool has_bodies = GenomeParts<Rules>::has_bodies;
  static constexpr std::size_t most_ended = 1000;     ///< individuals in a tick; then the run ends
  static constexpr std::ptrdiff_t most_replaced = 5;  ///< times that one body is replaced in a tick before those next to it

  using Locomotion = locomotion::Locomotion<typename Rules::Steering>;
  struct Before {
    std::any bodies;
    typename Locomotion::State rhythms;
  };

  [[nodiscard]] bool ends_individuals() const {
    if constexpr (has_bodies && requires { rules_.embodiment.divergence(); }) {
      return rules_.embodiment.divergence() == initialization::Divergence::ends_individual;
    }
    return false;
  }

  /// The body nearest to this one, itself if possible, that is less than `most_replaced` times among `ended`.
  [[nodiscard]] BodyIndex cause_of(BodyIndex body, std::span<const BodyIndex> ended) const {
    BodyIndex nearest = body;
    for (BodyIndex other = 0; other < poses_.size(); ++other) {
      if (std::ranges::count(ended, other) >= most_replaced) continue;
      if (other == body) return body;
      if (nearest == body || distance_m(poses_[body], poses_[other]) < distance_m(poses_[body], poses_[nearest])) nearest = other;
    }
    return nearest;
  }

  [[nodiscard]] bool advance(observe::Audience& audience, const observe::FrameTimes& times, double clock_s) {
    target_angles_rad_.clear();
    for (const Individual& individual : population_.individuals()) target_angles_rad_.push_back(individual.target_angle_rad);
    return advance_or_return(audience, locomotion_, backend_, target_angles_rad_, habitat_, population_.phenotypes(), times,
                             clock_s);
  }

  [[nodiscard]] GroundPose on_ground(BodyIndex body) const {
    const Pose root = backend_.pose(body);
    const double forward_rad = robot_in(body, population_.phenotypes(), habitat_).forward_rad;
    return {.x_m = root.position_m.x(), .y_m = root.position_m.y(), .heading_rad = rules_.heading.heading_rad(root, forward_rad)};
  }

  void walk_by(BodyIndex body) {
    locomotion_.walk_by(body, robot_in(body, population_.phenotypes(), habitat_), *population_.phenotypes()[body].gait);
  }

  /// Gives the backend the body, in any pose, and the gait.
  void take_shape(BodyIndex body) {
    const RobotModel& robot = robot_in(body, population_.phenotypes(), habitat_);
    if constexpr (has_bodies) {
      backend_.embody(body, robot,
                      {.position_m = {0.0, 0.0, robot.rest_height_m}, .orientation = Eigen::Quaterniond::Identity()});
    }
    walk_by(body);
  }

  const Policies<Rules>& rules_;
  const Habitat& habitat_;
  Population<Rules>& population_;
  std::vector<GroundPose> poses_;
  AnyBackend backend_;
  Locomotion locomotion_;
  std::vector<double> target_angles_rad_;
  std::vector<GroundPose> poses_before_;
};

}  // namespace trophic
