// SPDX-License-Identifier: MIT
// Robots that are stepped together: teams of four robots of one shape, and contacts between robots of any of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <trophic/backend/mujoco/kernel/field_contact.hpp>
#include <trophic/backend/mujoco/kernel/lane_model.hpp>
#include <trophic/backend/mujoco/kernel/symmetric_system.hpp>
#include <trophic/backend/mujoco/kernel/workspace.hpp>
#include <vector>

namespace trophic::backend::kernel {

/// Up to four robots whose bodies have one shape, one per lane.
struct Team {
  LaneModel model;
  LaneState state;
  Workspace work;
  unsigned lanes = 0;  ///< bit i: a robot is in lane i
  /// Robots that the step could compute so far, and after it: those that took it. The others keep their state, and are MuJoCo's
  /// to step.
  unsigned going = 0;
  unsigned coupled = 0;   ///< robots whose links touch other links or a height field in this stage
  unsigned unsolved = 0;  ///< those of them whose knot is not settled
  unsigned solved = 0;    ///< and those whose knot has just settled
  unsigned changed = 0;   ///< robots of which other rows of planes or limits push than before
  bool is_stale = false;  ///< whether its trees must be eliminated anew

  /// The states of this stage.
  [[nodiscard]] LaneState& current() { return model.shape().runge_kutta ? work.stage : state; }
  [[nodiscard]] const LaneState& current() const { return model.shape().runge_kutta ? work.stage : state; }
  [[nodiscard]] bool is_going(std::size_t lane) const { return (going & (1u << lane)) != 0; }
};

/// The place of a robot in a crew.
struct Seat {
  std::size_t team;
  std::size_t lane;
  friend bool operator==(const Seat&, const Seat&) = default;
  /// All seats of a crew in one sequence.
  [[nodiscard]] std::size_t slot() const { return team * lane_count + lane; }
};

/// One contact of two links, of one robot or of two.
struct LinkContact {
  std::array<Seat, 2> seat;
  std::array<std::size_t, 2> link;
  std::array<std::array<double, 3>, 2> point_m;  ///< from the origin of each robot's root
  std::array<std::array<double, 3>, 3> frame;    ///< normal from the first link to the second, and two tangents
  double depth_m;                                ///< signed distance, negative
};

/// A contact between links, or with the height field: rows y_n +- mu y_t1, y_n +- mu y_t2 of y = J x + offset.
struct KnotContact {
  std::size_t first = 0;  ///< of the coordinates in x that move it, which ascend
  std::size_t coordinates = 0;
  std::size_t jacobian = 0;  ///< where its J begins
  double weight = 0.0;       ///< D of each row
  double mu = 0.0;
  std::array<double, 3> offset{};
  std::array<bool, 4> active{};

  [[nodiscard]] std::array<double, 4> pushing_weights() const {
    return {active[0] ? weight : 0.0, active[1] ? weight : 0.0, active[2] ? weight : 0.0, active[3] ? weight : 0.0};
  }
};

/// Sets of robots that share a fate, by slot; they grow by being joined.
class Ties {
 public:
  void reset(std::size_t slots) {
    root_.resize(slots);
    std::iota(root_.begin(), root_.end(), std::size_t{0});
  }
  /// The first slot of the set of `slot`.
  [[nodiscard]] std::size_t first(std::size_t slot) const {
    while (root_[slot] != slot) slot = root_[slot];
    return slot;
  }
  void join(const Seat& a, const Seat& b) {
    const std::size_t i = first(a.slot());
    const std::size_t j = first(b.slot());
    root_[i < j ? j : i] = i < j ? i : j;
  }

 private:
  std::vector<std::size_t> root_;
};

/// Robots tied to each other by contacts between links, or one whose own links touch each other or a height field: the memory of
/// their search.
struct KnotWork {
  std::vector<Seat> seats;  ///< of its robots, in the order of the crew's `order`
  std::vector<const LinkContact*> link_contacts;
  std::vector<KnotContact> contacts;
  std::vector<std::size_t> coordinates;
  std::vector<double> jacobians;           ///< J of each contact: normal and tangents, as long as columns of `system`
  std::vector<std::size_t> hinge_indices;  ///< index in x of each link's hinge, robot by robot; none: `eliminated`
  std::vector<std::size_t> first_hinges;   ///< where those of a robot begin
  std::size_t first_root = 0;              ///< index in x of the first root's angular acceleration
  std::vector<double> x;
  SymmetricSystem system;
  SymmetricSystem trees;  ///< A and b before contacts add to them
  std::vector<double> trees_x;
  bool trees_known = false;  ///< whether `trees` are those of the rows of planes and limits that push now
  bool settled = false;

  static constexpr std::size_t eliminated = static_cast<std::size_t>(-1);

  [[nodiscard]] std::span<const std::size_t> coordinates_of(const KnotContact& contact) const {
    return {coordinates.data() + contact.first, contact.coordinates};
  }
  [[nodiscard]] std::array<const double*, 3> rows(const KnotContact& contact) const {
    const double* const first = jacobians.data() + contact.jacobian;
    return {first, first + system.column_size(), first + 2 * system.column_size()};
  }
};

/// Robots that one thread steps together, and its scratch memory. Any robots may be in it; those that may touch each other must
/// be.
struct Crew {
  std::vector<std::unique_ptr<Team>> teams;
  std::size_t team_count = 0;                   ///< teams in use; the others only keep their memory
  std::vector<std::array<Seat, 2>> neighbours;  ///< robots that may touch, the earlier one of each pair first
  std::vector<Seat> order;                      ///< all robots; a robot's motion depends on this order, not on its seat
  std::vector<LinkContact> link_contacts;
  Ties ties;                         ///< robots that MuJoCo must step together, if it must step one of them
  Ties knot_ties;                    ///< robots tied by contacts in this stage
  std::vector<std::size_t> knot_of;  ///< of each slot
  std::vector<std::size_t> rank_of;  ///< of each slot among the seats of its knot
  std::vector<KnotWork> knots;
  std::size_t knot_count = 0;
  std::vector<std::uint8_t> last_gap;  ///< which axis last separated two boxes of two robots; a guess, as many share an entry
  BoxCollider collider;
  std::optional<FieldCollider> field_collider;

  explicit Crew(mujoco::BoxDepth box_depth) : last_gap(gaps), collider{box_depth} {}

  static constexpr std::size_t gaps = 1u << 13;

  [[nodiscard]] Team& team(const Seat& seat) { return *teams[seat.team]; }
  [[nodiscard]] const Team& team(const Seat& seat) const { return *teams[seat.team]; }

  /// Empties all seats.
  void clear() {
    team_count = 0;
    neighbours.clear();
    order.clear();
  }

  /// A further team, without robots. `bodies`: of its lanes, of one shape; lanes beyond them get the first.
  Team& add_team(std::span<const std::shared_ptr<const KernelModel>> bodies) {
    if (team_count == teams.size()) teams.push_back(std::make_unique<Team>());
    Team& team = *teams[team_count++];
    team.model.set_bodies(bodies);
    const KernelModel& model = team.model.shape();
    team.state.fit(model);
    team.work.fit(model);
    team.work.forget_rows();
    team.lanes = 0;
    if (model.field && !field_collider) field_collider.emplace(*model.field);
    return team;
  }
};

}  // namespace trophic::backend::kernel
