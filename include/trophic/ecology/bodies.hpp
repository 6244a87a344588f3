// SPDX-License-Identifier: MIT
// The robots of an ecology: their positions, their motion, and the bodies and gaits of newborns.
#pragma once

#include <algorithm>
#include <any>
#include <cmath>
#include <numbers>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/control/acts/effort.hpp>
#include <trophic/control/locomotion/locomotion.hpp>
#include <trophic/ecology/body_genes.hpp>
#include <trophic/ecology/checks.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/ecology/phenotypes.hpp>
#include <trophic/ecology/population.hpp>
#include <trophic/ecology/standing_poses.hpp>
#include <trophic/ecology/start.hpp>
#include <trophic/habitat/habitat.hpp>
#include <trophic/initialization/embodiment/contract.hpp>
#include <trophic/observe/audience.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/population/body_reading.hpp>
#include <trophic/rules/table.hpp>

namespace trophic {

/// The robots of a population in a backend. Each has the body and the gait of its individual's phenotype; if these
/// phenotypes_differ, `embody` puts a newborn's body in place and starts its gait.
template <class Rules>
class Bodies final : public BodyReading {
 public:
  /// `population` holds the founders; call embody_founders() next. All arguments must outlive the bodies.
  Bodies(const Experiment<Rules>& params, const BackendChoice& choice, const Habitat& habitat, const Policies<Rules>& rules,
         Population<Rules>& population)
      : rules_{rules},
        habitat_{habitat},
        population_{population},
        seed_{params.seed},
        poses_{places_of(params, rules, habitat, founders_in(population))},
        backend_{
            choice.build(habitat.robot, habitat.arena, standing_poses(poses_, habitat.robot, habitat.arena), params.physics)},
        locomotion_{habitat.robot,
                    habitat.gait,
                    rules.steering,
                    params.ecology.robots,
                    {.hz = params.ecology.control_hz,
                     .integration = params.ecology.cpg_integration,
                     .idle_steps = static_cast<std::int64_t>(params.ecology.idle_control_steps)}},
        times_{.steps = control_steps_per_tick(params.ecology),
               .tick_s = params.ecology.tick_s,
               .clock_scale = params.ecology.clock_scale} {
    if (phenotypes_differ) locomotion_.separate();
    if (paces_differ && !backend_->has_joints()) backend_->set_pace(0, 1.0);
    population_.stand_at(poses_);
  }

  [[nodiscard]] std::span<const GroundPose> poses() const { return poses_; }
  [[nodiscard]] const RobotModel& robot(BodyIndex body) const override {
    const auto phenotypes = population_.phenotypes();
    return phenotypes.empty() || !phenotypes[body].robot ? habitat_.robot : *phenotypes[body].robot;
  }
  [[nodiscard]] Pose root(BodyIndex body) const override { return backend_->pose(body); }
  [[nodiscard]] std::span<const double> joint_angles_rad(BodyIndex body) const override { return backend_->joint_angles(body); }
  [[nodiscard]] const AnyBackend& backend() const { return *backend_; }
  [[nodiscard]] Space space() const { return {.period_m = backend_->is_periodic() ? 2.0 * habitat_.arena.half_side_m : 0.0}; }

  /// Passes observers the frame at the start of the run if they want it.
  void show_start(observe::Audience& audience, double clock_s) const {
    if (audience.wants_frame(times_, 0)) show(audience, poses_after(0), clock_s);
  }

  /// Restarts the gait of a body.
  void restart(BodyIndex body) { locomotion_.reset(body); }

  /// Gives a body the phenotype of its individual. Founders are embodied in order; `standing` is the number of those before it.
  void embody(BodyIndex body, std::size_t standing) {
    if (bodies_differ) {
      const Pose pose = rules_.embodiment.set_down(poses_[body], robot(body), habitat_.arena, boxes_near(body, standing));
      backend_->embody(body, robot(body), pose);
      poses_[body] = on_ground(body);
      population_.stand_at(poses_);
    }
    if (phenotypes_differ) walk_by(body);
  }
  /// Embodies the founders. Bodies without an individual get their shape, as in a resumed run, and are removed from the world.
  void embody_founders() {
    for (BodyIndex body = 0; body < poses_.size(); ++body) {
      const bool lives = population_[body].lives();
      if (phenotypes_differ && lives) embody(body, body);
      if (phenotypes_differ && !lives) take_shape(body);
      if (!lives) take_away(body);
    }
  }

  /// Removes a body without an individual from the world.
  void take_away(BodyIndex body) { backend_->take_away(body); }
  /// Adds the body of an individual that was born without a death to the world, at rest. Call `stand` after the last one in a
  /// tick.
  void set_down(BodyIndex body, const GroundPose& place) {
    poses_[body] = place;
    set_down_.push_back(body);
    population_.leave_tree();
    if (bodies_differ) return embody(body, population_.individuals().size());
    backend_->place(body, standing_poses(std::array{place}, robot(body), habitat_.arena).front());
    if (phenotypes_differ) {
      walk_by(body);
    } else {
      restart(body);
    }
  }
  /// Lets searches use a tree again.
  void stand() {
    if (!set_down_.empty()) population_.stand_at(poses_);
    set_down_.clear();
  }

  /// Returns a place for a birth at which no circles of robots overlap: on rings around `parent`, or anywhere without a parent.
  /// Empty if none was found.
  [[nodiscard]] std::optional<GroundPose> free_place(std::optional<BodyIndex> parent, IndividualId newborn) const {
    Rng rng{seed_, Stream::birth_place, newborn};
    const double radius_m = habitat_.robot.bounding_radius_m;
    const double reach_m = habitat_.arena.half_side_m - (space().has_edges() ? radius_m : 0.0);
    const double first_rad = rng.uniform(-std::numbers::pi, std::numbers::pi);
    for (int attempt = 0; attempt < places_tried; ++attempt) {
      GroundPose place{.heading_rad = rng.uniform(-std::numbers::pi, std::numbers::pi)};
      if (parent) {
        const double angle_rad = first_rad + 2.0 * std::numbers::pi * (attempt % places_on_ring) / places_on_ring;
        const double from_m = (2.0 + 0.5 * (attempt / places_on_ring)) * radius_m * (1.0 + 1e-9);
        place.x_m = poses_[*parent].x_m + from_m * std::cos(angle_rad);
        place.y_m = poses_[*parent].y_m + from_m * std::sin(angle_rad);
      } else {
        place.x_m = rng.uniform(-reach_m, reach_m);
        place.y_m = rng.uniform(-reach_m, reach_m);
      }
      place = {space().shortest(place.x_m), space().shortest(place.y_m), place.heading_rad};
      if (std::abs(place.x_m) <= reach_m && std::abs(place.y_m) <= reach_m && is_free(place, 2.0 * radius_m)) return place;
    }
    return std::nullopt;
  }

  /// Moves all bodies through the tick that begins now. Returns false and leaves everything unchanged if an observer cancelled
  /// it. If the table lets a body that diverges end its individual, `end(body)` is called and the tick starts again. If a body
  /// keeps diverging after replacements, its neighbours, which it may touch, end as well.
  template <class End>
  [[nodiscard]] bool move(observe::Audience& audience, const View& view, const End& end) {
    const bool ends_individuals =
        bodies_differ && initialization::ask::divergence(rules_.embodiment) == initialization::Divergence::ends_individual;
    for (std::vector<BodyIndex> ended; true;) {
      const auto before = ends_individuals && ended.size() < most_ended ? std::optional{motion()} : std::nullopt;
      try {
        if (!advance(audience, view)) return false;
        break;
      } catch (const Diverged& diverged) {
        if (!before) throw;
        restore(*before);
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

  /// Call this after the population's. Bodies and gaits are expressed again.
  void persist(Archive& archive) {
    archive(poses_);
    if (archive.reads()) {
      detail::check_saved_poses(poses_, population_.individuals().size());
      for (BodyIndex body = 0; phenotypes_differ && body < poses_.size(); ++body) take_shape(body);
    }
    auto rhythms = locomotion_.save();
    archive(rhythms, *backend_);
    if (!archive.reads()) return;
    locomotion_.restore(rhythms);
    population_.stand_at(poses_);
  }

 private:
  static constexpr bool phenotypes_differ = Phenotypes<Rules>::differ;
  static constexpr bool paces_differ =
      !is_neutral<Rules, RuleSlot::pace> || PolicyIn<Rules, RuleSlot::acts>::template contains<control::acts::Effort>;
  static constexpr bool bodies_differ = BodyGenes<Rules>::differ;
  static constexpr int places_on_ring = 16;
  static constexpr int places_tried = 64;             ///< for each birth
  static constexpr std::size_t most_ended = 1000;     ///< individuals that may end in a tick before the run ends
  static constexpr std::ptrdiff_t most_replaced = 5;  ///< replacements of one body in a tick before its neighbours are replaced

  using Locomotion = locomotion::Locomotion<typename Rules::Steering>;

  [[nodiscard]] static std::size_t founders_in(const Population<Rules>& population) {
    return static_cast<std::size_t>(std::ranges::count_if(population.individuals(), &Individual::lives));
  }

  /// Whether all individuals are at least this far away, and obstacles at least half as far.
  [[nodiscard]] bool is_free(const GroundPose& place, double distance_m) const {
    if (!is_clear(habitat_.arena, place, 0.5 * distance_m)) return false;
    bool is_free = true;
    const auto keep_clear_of = [&](BodyIndex body) {
      if (population_[body].lives() && space().distance_m(place, poses_[body]) < distance_m) is_free = false;
    };
    population_.last_tree().for_each_near(place, distance_m, keep_clear_of, space());
    for (const BodyIndex body : set_down_) keep_clear_of(body);
    return is_free;
  }

  /// The state of all motion.
  struct Motion {
    std::any bodies;
    typename Locomotion::State rhythms;
  };
  [[nodiscard]] Motion motion() const { return {backend_->save(), locomotion_.save()}; }
  void restore(const Motion& motion) {
    backend_->restore(motion.bodies);
    locomotion_.restore(motion.rhythms);
  }

  /// The poses after each of some control steps in a tick.
  struct Poses {
    std::int64_t step = 0;
    std::vector<Pose> roots = {};
    std::vector<double> joint_angles_rad = {};
    std::vector<std::size_t> first_angle = {};  ///< one per robot
  };
  [[nodiscard]] Poses poses_after(std::int64_t step) const {
    Poses now{.step = step};
    for (BodyIndex body = 0; body < backend_->robots(); ++body) {
      now.roots.push_back(backend_->pose(body));
      now.first_angle.push_back(now.joint_angles_rad.size());
      const std::span<const double> own = backend_->joint_angles(body);
      now.joint_angles_rad.insert(now.joint_angles_rad.end(), own.begin(), own.end());
    }
    return now;
  }

  /// Passes observers a frame of the tick that begins at `clock_s`.
  void show(observe::Audience& audience, const Poses& poses, double clock_s) const {
    const double part = static_cast<double>(poses.step) / static_cast<double>(times_.steps);
    audience.frame(observe::Frame{.time_s = clock_s + part * times_.tick_s,
                                  .times = times_,
                                  .roots = poses.roots,
                                  .joint_angles_rad = poses.joint_angles_rad,
                                  .robot = habitat_.robot,
                                  .arena = habitat_.arena,
                                  .phenotypes = population_.phenotypes(),
                                  .first_angle = poses.first_angle},
                   poses.step);
  }

  /// Returns the body nearest to this one, itself if possible, that occurs fewer than `most_replaced` times in `ended`.
  [[nodiscard]] BodyIndex cause_of(BodyIndex body, std::span<const BodyIndex> ended) const {
    BodyIndex nearest = body;
    for (BodyIndex other = 0; other < poses_.size(); ++other) {
      if (std::ranges::count(ended, other) >= most_replaced || !population_[other].lives()) continue;
      if (other == body) return body;
      if (nearest == body || distance_m(poses_[body], poses_[other]) < distance_m(poses_[body], poses_[nearest])) nearest = other;
    }
    return nearest;
  }

  /// Moves the bodies through a whole tick, and passes observers the frames that they want: at the end of the tick if it may be
  /// cancelled or diverge. A backend's steps do not depend on pauses. If an observer cancels the tick, the bodies return to their
  /// previous state, and the result is false.
  [[nodiscard]] bool advance(observe::Audience& audience, const View& view) {
    if (paces_differ) locomotion_.set_paces(paces(view));
    std::vector<double> target_angles_rad;
    for (const Individual& individual : population_.individuals()) target_angles_rad.push_back(individual.target_angle_rad);
    const auto before = backend_->has_joints() && audience.may_cancel() ? std::optional{motion()} : std::nullopt;
    const auto is_cancelled = [&] { return before && audience.cancels_tick(); };
    std::vector<Poses> frames;
    for (std::int64_t step = 0; step < times_.steps;) {
      const std::int64_t next = audience.next_frame(times_, step);
      if (!locomotion_.advance(*backend_, next - step, target_angles_rad, is_cancelled)) {
        restore(*before);
        return false;
      }
      step = next;
      if (!audience.wants_frame(times_, step)) continue;
      frames.push_back(poses_after(step));
      if (backend_->has_joints()) continue;
      show(audience, frames.back(), view.time_s);
      frames.clear();
    }
    for (const Poses& frame : frames) show(audience, frame, view.time_s);
    return true;
  }

  /// The pace of each robot. Throws RuleError for one that is not finite or < 0.
  [[nodiscard]] std::vector<double> paces(const View& view) const {
    std::vector<double> paces(poses_.size(), 1.0);
    for (BodyIndex body = 0; body < poses_.size(); ++body) {
      if (!population_[body].lives()) continue;
      const double pace = for_species(rules_.pace, population_[body].species).pace(body, view);
      if (!(pace >= 0.0 && std::isfinite(pace)))
        throw RuleError{"pace", "pace = " + number_text(pace) + ": must be finite and >= 0"};
      paces[body] = pace * view.act<control::acts::Effort>(body);
    }
    return paces;
  }

  [[nodiscard]] GroundPose on_ground(BodyIndex body) const {
    const Pose root = backend_->pose(body);
    const double heading_rad = rules_.heading.heading_rad(root, robot(body).forward_rad);
    return {.x_m = root.position_m.x(), .y_m = root.position_m.y(), .heading_rad = heading_rad};
  }

  /// The boxes of the robots that a body could touch where it is or might be put. Only the first `standing` bodies are in the
  /// world.
  [[nodiscard]] std::vector<PlacedBox> boxes_near(BodyIndex body, std::size_t standing) const {
    std::vector<PlacedBox> near;
    for (BodyIndex other = 0; other < standing; ++other) {
      if (other == body || !population_[other].lives()) continue;
      const RobotModel& model = robot(other);
      const Pose root = backend_->pose(other);
      const GroundPose there{.x_m = root.position_m.x(), .y_m = root.position_m.y()};
      const double most_m = 3.0 * robot(body).bounding_radius_m + model.bounding_radius_m;
      if (distance_m(poses_[body], there) > most_m) continue;
      const auto boxes = placed_boxes(model, root, backend_->joint_angles(other));
      near.insert(near.end(), boxes.begin(), boxes.end());
    }
    return near;
  }

  void walk_by(BodyIndex body) { locomotion_.walk_by(body, robot(body), *population_.phenotypes()[body].gait); }

  /// Gives the backend the body at the robot's pose, and the gait.
  void take_shape(BodyIndex body) {
    if (bodies_differ) backend_->embody(body, robot(body), backend_->pose(body));
    walk_by(body);
  }

  const Policies<Rules>& rules_;
  const Habitat& habitat_;
  Population<Rules>& population_;
  std::uint64_t seed_;
  std::vector<GroundPose> poses_;
  std::unique_ptr<AnyBackend> backend_;
  Locomotion locomotion_;
  observe::FrameTimes times_;
  std::vector<GroundPose> poses_before_;
  std::vector<BodyIndex> set_down_;  ///< since the last tree
};

}  // namespace trophic
