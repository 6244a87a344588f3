// SPDX-License-Identifier: MIT
// Invariants of every moment of every run of any length.
#pragma once

#include <trophic/observe/event.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/population/view.hpp>
#include <unordered_set>

namespace trophic::test {

/// Throws std::logic_error as soon as a run breaks one of these: as many individuals as bodies, each born once, after its parent
/// and before its death; never fewer of a hunted species than the rules' floor, once there were as many; bodies above the ground,
/// not thrown into the air, where numbers are finite.
class Invariants {
 public:
  /// `floor`: of the table's rule; 0 if it has none.
  explicit Invariants(std::size_t floor) : floor_{floor} {}

  void on_start(const observe::RunDescription&, const View& view) { had_floor_.resize(view.web.size(), 0); }

  void on_event(const observe::Event& event, const View&) {
    if (event.kind == observe::EventKind::birth) {
      require(event.individual.id == next_id_, "individual " + std::to_string(event.individual.id) + " is born out of turn");
      require(!event.individual.parent() || *event.individual.parent() < event.individual.id, "a child is older than its parent");
      ++next_id_;
      alive_.insert(event.individual.id);
    }
    if (event.kind == observe::EventKind::death) {
      require(alive_.erase(event.individual.id) == 1, "individual " + std::to_string(event.individual.id) + " dies twice");
      ++deaths_;
    }
  }

  void on_tick(const View& view) {
    require(view.tick == last_tick_ + 1, "tick " + std::to_string(view.tick) + " follows tick " + std::to_string(last_tick_));
    last_tick_ = view.tick;
    require(view.robots.size() == alive_.size() && view.poses.size() == alive_.size(), "not one individual a body");
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      const Individual& individual = view.robots[body];
      require(alive_.contains(individual.id), "who lives in body " + std::to_string(body) + " was never born");
      require(individual.species < view.web.size(), "a species that does not exist");
      require(!individual.adversary || (*individual.adversary < view.robots.size() && *individual.adversary != body),
              "an adversary that does not exist");
      const GroundPose& pose = view.poses[body];
      require(std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.heading_rad), "a body is nowhere");
    }
    for (Species species = 0; species < view.web.size(); ++species) {
      if (!view.web.is_hunted(species)) continue;
      const bool has_floor = view.count(species) >= floor_;
      require(has_floor || had_floor_[species] == 0, "species " + std::to_string(species) + " fell below its floor");
      had_floor_[species] = has_floor ? 1 : 0;
    }
  }

  [[nodiscard]] static double frame_hz() { return 1e-9; }  // as few as there are: one a tick
  void on_frame(const observe::Frame& frame) const {
    for (const Pose& root : frame.roots) {
      require(root.position_m.allFinite() && root.orientation.coeffs().allFinite(), "a body is nowhere");
      require(std::abs(root.orientation.norm() - 1.0) < 1e-6, "an orientation is none");
      require(root.position_m.z() > -frame.robot.bounding_radius_m, "a body fell through the ground");
      require(root.position_m.z() < highest_m(frame.arena) + 1.0, "a body flies");
    }
  }

  static constexpr std::string_view section = "invariants";  ///< of a checkpoint
  void persist(Archive& archive) {
    std::vector<IndividualId> alive{alive_.begin(), alive_.end()};
    archive(alive, next_id_, last_tick_, deaths_, had_floor_);
    alive_ = {alive.begin(), alive.end()};
  }

  [[nodiscard]] std::int64_t ticks() const { return last_tick_ + 1; }
  [[nodiscard]] std::uint64_t deaths() const { return deaths_; }

 private:
  [[nodiscard]] static double highest_m(const Arena& arena) {
    return arena.height_field ? *std::ranges::max_element(arena.height_field->height_m) : 0.0;
  }

  static void require(bool holds, const std::string& otherwise) {
    if (!holds) throw std::logic_error{otherwise};
  }

  std::size_t floor_;
  std::unordered_set<IndividualId> alive_;
  IndividualId next_id_ = 0;
  std::int64_t last_tick_ = -1;
  std::uint64_t deaths_ = 0;
  std::vector<std::uint8_t> had_floor_;
};

}  // namespace trophic::test
