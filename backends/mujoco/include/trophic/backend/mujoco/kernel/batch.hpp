// SPDX-License-Identifier: MIT
// Robots that are stepped together: packs of robots with the same shape, and contacts between robots of all packs.
#pragma once

#include <algorithm>
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
#include <utility>
#include <vector>

namespace trophic::backend::kernel::TROPHIC_LANES {

/// Robots whose bodies have the same shape, at most one per lane.
struct Pack {
  LaneModel model;
  LaneState state;
  Workspace work;
  unsigned lanes = 0;  ///< bit i: a robot is in lane i
  /// Robots that the kernel could compute so far and, after the step, those that it stepped. The others keep their state and must
  /// be stepped by MuJoCo.
  unsigned valid = 0;
  unsigned coupled = 0;   ///< robots whose links touch other links or a height field in this stage
  unsigned unsolved = 0;  ///< those of them whose island has not converged
  unsigned solved = 0;    ///< and those whose island has just converged
  unsigned changed = 0;   ///< robots whose active rows of planes or limits changed
  bool is_stale = false;  ///< whether its trees must be eliminated again

  /// The states of this stage.
  [[nodiscard]] LaneState& current() { return model.shape().runge_kutta ? work.stage : state; }
  [[nodiscard]] const LaneState& current() const { return model.shape().runge_kutta ? work.stage : state; }
  [[nodiscard]] bool is_valid(std::size_t lane) const { return (valid & (1u << lane)) != 0; }
};

/// The place of a robot in a batch.
struct LaneIndex {
  std::size_t pack;
  std::size_t lane;
  friend bool operator==(const LaneIndex&, const LaneIndex&) = default;
  /// All lanes of a batch in one sequence.
  [[nodiscard]] std::size_t slot() const { return pack * lane_count + lane; }
};

/// Box `box` of a link of the robot in one lane.
struct BoxOf {
  std::size_t box;
  std::size_t link;
  LaneIndex at;
};

/// Two boxes whose spheres overlap, the second's robot `apart_m` from the first's.
struct NearBoxes {
  std::array<BoxOf, 2> of;
  Point3 apart_m;
  double moved_m;  ///< sum of the `moved_m` of their links
  double* gap_m;   ///< their number in RobotGaps; none for boxes of one robot
};

/// What is known of the distances between two robots: two links, or two boxes, cannot touch while the sum of the `moved_m` of
/// their links is below their number here.
struct RobotGaps {
  std::vector<double> links;  ///< empty at first
  std::vector<double> boxes;
};

/// One contact of two links, of one robot or of two.
struct LinkContact {
  std::array<LaneIndex, 2> at;
  std::array<std::size_t, 2> link;
  Point3 point_m;               ///< relative to the origin of the first robot's root
  Point3 apart_m;               ///< and relative to that of the second's
  std::array<Point3, 3> frame;  ///< normal from the first link to the second, and two tangents
  double depth_m;               ///< signed distance, negative
};

/// The motion of a link in world axes, or a force; the fourth lane is 0.
struct Motion {
  Four angular;
  Four linear;

  TROPHIC_LANES_INLINE friend Motion operator+(const Motion& a, const Motion& b) {
    return {a.angular + b.angular, a.linear + b.linear};
  }
  TROPHIC_LANES_INLINE friend Motion operator*(const Motion& a, double scale) { return {a.angular * scale, a.linear * scale}; }
};

/// Two links that touch, or a link that touches the height field; then the link is the second.
struct TouchingLinks {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::array<LaneIndex, 2> at{};
  std::array<std::size_t, 2> link{};
  Four apart_m{};  ///< from the origin of the first robot's root to that of the second's
  bool on_field = false;
  double mu = 0.0;
  double inverse_weight_per_kg = 0.0;
  std::size_t contacts = 0;
  std::size_t first = none;  ///< four of them, with the index of the next four
  std::size_t last = none;

  /// Whether both are links of one robot.
  [[nodiscard]] bool loops() const { return at[0] == at[1] && !on_field; }
};

/// Four contacts of two links, a lane each: rows y_n +- mu y_t1, y_n +- mu y_t2 of y = B motion + offset.
struct IslandContacts {
  std::size_t next = TouchingLinks::none;  ///< further contacts of these links
  std::size_t count = 0;                   ///< lanes in use; the others' weight means nothing, as their rows are never active
  Real depth_m{};
  Real rows[3][6]{};  ///< B: normal and tangents seen from the origin of the first link's root
  Real weight{};      ///< D of each row
  Vec3 offset{};
  Mask active[4]{};

  /// B motion of row `k`.
  [[nodiscard]] TROPHIC_LANES_INLINE Real along(int k, const Motion& motion) const {
    const Real(&b)[6] = rows[k];
    return b[0] * motion.angular[0] + b[1] * motion.angular[1] + b[2] * motion.angular[2] + b[3] * motion.linear[0] +
           b[4] * motion.linear[1] + b[5] * motion.linear[2];
  }
};

/// Disjoint sets of lanes, by slot.
class UnionFind {
 public:
  void reset(std::size_t slots) {
    root_.resize(slots);
    std::iota(root_.begin(), root_.end(), std::size_t{0});
  }
  /// The first slot of the set of `slot`.
  [[nodiscard]] std::size_t find(std::size_t slot) const {
    while (root_[slot] != slot) slot = root_[slot];
    return slot;
  }
  void unite(const LaneIndex& a, const LaneIndex& b) {
    const std::size_t i = find(a.slot());
    const std::size_t j = find(b.slot());
    root_[i < j ? j : i] = i < j ? i : j;
  }

 private:
  std::vector<std::size_t> root_;
};

/// An island: robots coupled by contacts between links, or one whose own links touch each other or a height field. The memory of
/// its search.
struct IslandWork {
  std::vector<LaneIndex> lanes;  ///< lanes of its robots, in the order of the batch's `order`
  std::vector<const LinkContact*> link_contacts;
  std::vector<TouchingLinks> pairs;
  std::vector<IslandContacts> contacts;
  std::vector<std::pair<std::size_t, Motion>> columns;  ///< for one pair: index in x and the resulting motion
  std::vector<std::size_t> hinge_indices;               ///< index in x of each link's hinge, robot by robot; none: `eliminated`
  std::vector<std::size_t> first_hinges;                ///< index of each robot's first hinge
  std::size_t first_root = 0;                           ///< index in x of the first root's angular acceleration
  std::vector<double> x;
  SymmetricSystem system;
  SymmetricSystem trees;  ///< A and b before contacts add to them
  std::vector<double> trees_x;
  bool trees_known = false;  ///< whether `trees` are those of the active rows of planes and limits
  bool settled = false;

  static constexpr std::size_t eliminated = static_cast<std::size_t>(-1);
};

/// Robots that one thread steps together, and its scratch memory. Any robots may be in it; those that may touch each other must
/// be.
struct Batch {
  std::vector<std::unique_ptr<Pack>> packs;
  std::size_t pack_count = 0;                        ///< packs in use; the others only keep their memory
  std::vector<std::array<LaneIndex, 2>> neighbours;  ///< robots that may touch, the earlier one of each pair first
  std::vector<RobotGaps> gaps;                       ///< of each of them
  std::vector<LaneIndex> order;                      ///< all robots; a robot's motion depends on this order, not on its lane
  std::vector<NearBoxes> near_boxes;
  std::vector<LinkContact> link_contacts;
  UnionFind step_sets;                 ///< robots that MuJoCo must step together, if it must step one of them
  UnionFind island_sets;               ///< robots coupled by contacts in this stage
  std::vector<std::size_t> island_of;  ///< island of each slot
  std::vector<std::size_t> rank_of;    ///< rank of each slot among the lanes of its island
  std::vector<IslandWork> islands;
  std::size_t island_count = 0;
  bool whole_depth;  ///< whether contacts between a face and a box have their whole depth
  std::optional<FieldCollider> field_collider;

  explicit Batch(mujoco::BoxDepth box_depth) : whole_depth{box_depth == mujoco::BoxDepth::whole || !mujoco::halves_box_depth} {}

  [[nodiscard]] Pack& pack(const LaneIndex& at) { return *packs[at.pack]; }
  [[nodiscard]] const Pack& pack(const LaneIndex& at) const { return *packs[at.pack]; }

  /// Empties all lanes.
  void clear() {
    pack_count = 0;
    neighbours.clear();
    for (RobotGaps& known : gaps) known.links.clear();
    order.clear();
  }

  /// Adds a pack without robots. `bodies`: bodies of its lanes, with the same shape; further lanes get the first one.
  Pack& add_pack(std::span<const std::shared_ptr<const KernelModel>> bodies) {
    if (pack_count == packs.size()) packs.push_back(std::make_unique<Pack>());
    Pack& pack = *packs[pack_count++];
    pack.model.set_bodies(bodies);
    const KernelModel& model = pack.model.shape();
    pack.state.fit(model);
    pack.work.fit(model);
    pack.work.forget_rows();
    pack.work.motion_known = false;
    pack.lanes = 0;
    if (model.field && !field_collider) field_collider.emplace(*model.field);
    return pack;
  }
};

}  // namespace trophic::backend::kernel::TROPHIC_LANES
