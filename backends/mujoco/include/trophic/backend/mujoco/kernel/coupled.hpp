// SPDX-License-Identifier: MIT
// Third stage of a step for robots whose links touch each other or a height field: MuJoCo's constraint problem of all of them.
#pragma once

#include <array>
#include <trophic/backend/mujoco/kernel/contact.hpp>
#include <trophic/backend/mujoco/kernel/search.hpp>
#include <trophic/backend/mujoco/kernel/solver.hpp>
#include <trophic/backend/mujoco/kernel/workspace.hpp>

namespace trophic::backend::kernel {

// The problem is that of solver.hpp, but a contact between links adds to the inertia of two links at once, so that there is no
// tree to recurse over. Its hinges are those between a touching link and the root; all others are eliminated as in solver.hpp,
// with the contacts of planes and the joint limits. In the unknowns x, accelerations of those hinges from the leaves inwards,
// then the roots' motions,
//   (A + sum J_c' W_c J_c) x = b - sum J_c' W_c offset_c,
// where A and b are what is left of the trees, J_c maps x to the acceleration of one side of contact c seen from the other along
// its normal and tangents, and W_c is the sum of D e e' over its pushing rows e = (1, +-mu, 0), (1, 0, +-mu).

/// The search of some robots: their problem is written down once, then solved for one set of pushing rows after the other.
class CoupledSearch {
 public:
  CoupledSearch(const KernelModel& model, Workspace& work, unsigned lanes)
      : model_{model}, work_{work}, own_{work.coupled}, lanes_{lanes} {
    std::size_t robots = 0;
    for_each_lane([&](std::size_t lane) { rank_[lane] = robots++; });
    choose_hinges();
    first_root_ = robots * own_.kept.size();
    own_.contacts.clear();
    own_.coordinates.clear();
    own_.jacobians.clear();
    own_.x.assign(first_root_ + 6 * robots, 0.0);
    own_.system.reset(own_.x.size());
    for_each_contact([&](const auto& contact) { add(contact); });
  }

  /// Full Newton steps until the pushing rows stay the same, at first with those of planes that pushed last, those of links at
  /// the warm start; the minimum becomes the trial point of all links. Returns false if rows keep changing: then MuJoCo's line
  /// search must solve it.
  [[nodiscard]] bool minimise(const LaneState& state) {
    first_rows(model_, state, work_);
    read_warm_start(state);
    evaluate_contacts();
    for (int step = 0; step < most_steps; ++step) {
      solve();
      const bool changed = evaluate_contacts();
      trees_known_ = (lane_bits(evaluate_trial(model_, work_)) & lanes_) == 0;
      if (!trees_known_ || changed) continue;
      remember_rows(work_, lanes_);
      return true;
    }
    return false;
  }

 private:
  static constexpr int most_steps = 12;

  template <class Visit>
  void for_each_lane(const Visit& visit) const {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      if ((lanes_ & (1u << lane)) != 0) visit(lane);
    }
  }

  /// Contacts between links of these robots, and with the height field.
  template <class Visit>
  void for_each_contact(const Visit& visit) const {
    for (const LinkContact& contact : work_.link_contacts) {
      if ((lanes_ & (1u << contact.lane[0])) != 0) visit(contact);
    }
    for (const FieldContact& contact : work_.field_contacts) {
      if ((lanes_ & (1u << contact.lane)) != 0) visit(contact);
    }
  }

  [[nodiscard]] static std::array<std::size_t, 2> links_of(const LinkContact& contact) { return contact.link; }
  [[nodiscard]] static std::array<std::size_t, 1> links_of(const FieldContact& contact) { return {contact.link}; }

  /// Those between a link that touches and the root, in any of the robots.
  void choose_hinges() {
    constexpr std::size_t chosen = 0;
    const std::size_t none = model_.links.size();
    own_.order.assign(none, none);
    const auto choose = [&](std::size_t link) {
      for (; link > 0 && own_.order[link] != chosen; link = model_.links[link].parent) own_.order[link] = chosen;
    };
    for_each_contact([&](const auto& contact) {
      for (const std::size_t link : links_of(contact)) choose(link);
    });
    own_.kept.clear();
    for (std::size_t link = none - 1; link > 0; --link) {
      if (own_.order[link] == none) continue;
      own_.order[link] = own_.kept.size();
      own_.kept.push_back(link);
    }
  }
  [[nodiscard]] bool is_kept(std::size_t link) const { return own_.order[link] < own_.kept.size(); }

  /// Index in x of a link's hinge to its parent.
  [[nodiscard]] std::size_t hinge_index(std::size_t lane, std::size_t link) const {
    return rank_[lane] * own_.kept.size() + own_.order[link];
  }
  /// Index in x of a root's angular acceleration; the linear one follows.
  [[nodiscard]] std::size_t root_index(std::size_t lane) const { return first_root_ + 6 * rank_[lane]; }

  [[nodiscard]] static std::array<double, 3> pick(const Vec3& vector, std::size_t lane) {
    return {vector[0][lane], vector[1][lane], vector[2][lane]};
  }
  [[nodiscard]] static std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  [[nodiscard]] static double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  /// Velocity of the point of a body with motion `motion`.
  [[nodiscard]] static std::array<double, 3> at_point(const Spatial& motion, std::size_t lane,
                                                      const std::array<double, 3>& point) {
    const std::array<double, 3> turning = cross(pick(motion.angular, lane), point);
    std::array<double, 3> sum = pick(motion.linear, lane);
    for (std::size_t i = 0; i < 3; ++i) sum[i] += turning[i];
    return sum;
  }

  using Frame = std::array<std::array<double, 3>, 3>;

  /// A contact that no coordinate moves yet, with room for its J. The next is to be made when this one is complete.
  [[nodiscard]] CoupledContact new_contact() {
    const std::size_t jacobian = own_.jacobians.size();
    own_.jacobians.resize(jacobian + 3 * own_.system.column_size());
    return {.first = own_.coordinates.size(), .jacobian = jacobian};
  }

  void add_coordinate(CoupledContact& contact, std::size_t index, const std::array<double, 3>& motion) {
    own_.coordinates.push_back(index);
    ++contact.coordinates;
    for (std::size_t k = 0; k < 3; ++k) own_.jacobians[contact.jacobian + k * own_.system.column_size() + index] = motion[k];
  }

  /// Appends what a link's hinges, inwards, add to the contact's acceleration.
  void add_hinge(CoupledContact& contact, std::size_t lane, std::size_t link, double sign, const std::array<double, 3>& point,
                 const Frame& frame) {
    const std::array<double, 3> motion = at_point(work_.links[link].axis, lane, point);
    add_coordinate(contact, hinge_index(lane, link),
                   {sign * dot(frame[0], motion), sign * dot(frame[1], motion), sign * dot(frame[2], motion)});
  }
  void add_hinges(CoupledContact& contact, std::size_t lane, std::size_t link, double sign, const std::array<double, 3>& point,
                  const Frame& frame) {
    for (; link > 0; link = model_.links[link].parent) add_hinge(contact, lane, link, sign, point, frame);
  }
  /// And what the root's motion adds: f . (w x p) = w . (p x f).
  void add_root(CoupledContact& contact, std::size_t lane, double sign, const std::array<double, 3>& point, const Frame& frame) {
    const Frame arm = {cross(point, frame[0]), cross(point, frame[1]), cross(point, frame[2])};
    std::size_t index = root_index(lane);
    for (const Frame* part : {&arm, &frame}) {
      for (std::size_t i = 0; i < 3; ++i) {
        add_coordinate(contact, index++, {sign * (*part)[0][i], sign * (*part)[1][i], sign * (*part)[2][i]});
      }
    }
  }

  /// As make_rows in contact.hpp, for a relative velocity at the contact and its inverse weight.
  [[nodiscard]] CoupledContact rows_of(double depth_m, const Frame& frame, const std::array<double, 3>& velocity, double mu,
                                       double inverse_weight_per_kg) {
    const double imp = impedance(model_.law, broadcast(depth_m))[0];
    CoupledContact contact = new_contact();
    contact.weight = imp / ((1.0 - imp) * 2.0 * mu * mu * (1.0 + mu * mu) * inverse_weight_per_kg);
    contact.mu = mu;
    for (std::size_t k = 0; k < 3; ++k) contact.offset[k] = model_.law.damping_per_s * dot(frame[k], velocity);
    contact.offset[0] += model_.law.stiffness_per_s2 * imp * depth_m;
    return contact;
  }

  void add(const FieldContact& from) {
    const auto& [point_m, frame, depth_m] = from.contact;
    const std::array<double, 3> velocity = at_point(work_.links[from.link].velocity, from.lane, point_m);
    CoupledContact contact = rows_of(depth_m, frame, velocity, model_.friction, model_.links[from.link].inverse_weight_per_kg);
    add_hinges(contact, from.lane, from.link, 1.0, point_m, frame);
    add_root(contact, from.lane, 1.0, point_m, frame);
    own_.contacts.push_back(contact);
  }

  /// Of the second link's motion seen from the first.
  void add(const LinkContact& from) {
    const double inverse_weight_per_kg =
        model_.links[from.link[0]].own_inverse_weight_per_kg + model_.links[from.link[1]].own_inverse_weight_per_kg;
    const std::array<double, 3> before = at_point(work_.links[from.link[0]].velocity, from.lane[0], from.point_m[0]);
    std::array<double, 3> velocity = at_point(work_.links[from.link[1]].velocity, from.lane[1], from.point_m[1]);
    for (std::size_t i = 0; i < 3; ++i) velocity[i] -= before[i];
    CoupledContact contact = rows_of(from.depth_m, from.frame, velocity, model_.link_friction, inverse_weight_per_kg);
    if (from.lane[0] != from.lane[1]) {
      add_hinges(contact, from.lane[0], from.link[0], -1.0, from.point_m[0], from.frame);
      add_hinges(contact, from.lane[1], from.link[1], 1.0, from.point_m[1], from.frame);
      add_root(contact, from.lane[0], -1.0, from.point_m[0], from.frame);
      add_root(contact, from.lane[1], 1.0, from.point_m[1], from.frame);
    } else {
      add_loop(contact, from);
    }
    own_.contacts.push_back(contact);
  }

  /// Two links of one robot: what moves both does not count.
  void add_loop(CoupledContact& contact, const LinkContact& from) {
    auto [first, second] = from.link;
    while (first != second) {
      std::size_t& outer = first > second ? first : second;
      add_hinge(contact, from.lane[0], outer, first > second ? -1.0 : 1.0, from.point_m[0], from.frame);
      outer = model_.links[outer].parent;
    }
  }

  void read_warm_start(const LaneState& state) {
    const LaneArray& warm = state.acceleration;
    for_each_lane([&](std::size_t lane) {
      const std::size_t root = root_index(lane);
      const Mat3& rotation = work_.links[0].rotation;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          own_.x[root + i] += rotation.column[k][static_cast<int>(i)][lane] * warm[3 + k][lane];
        }
        own_.x[root + 3 + i] = warm[i][lane];
      }
      for (const std::size_t link : own_.kept) own_.x[hinge_index(lane, link)] = warm[5 + link][lane];
    });
  }

  /// Finds the rows of contacts that push at x; returns whether they differ from the last ones.
  bool evaluate_contacts() {
    bool changed = false;
    const auto update = [&](bool& active, double residual) {
      changed |= active != (residual < 0.0);
      active = residual < 0.0;
    };
    for (CoupledContact& contact : own_.contacts) {
      const std::array<const double*, 3> row = own_.rows(contact);
      std::array<double, 3> y = contact.offset;
      for (const std::size_t index : own_.coordinates_of(contact)) {
        for (std::size_t k = 0; k < 3; ++k) y[k] += row[k][index] * own_.x[index];
      }
      for (std::size_t k = 1; k < 3; ++k) {
        update(contact.active[2 * k - 2], y[0] + contact.mu * y[k]);
        update(contact.active[2 * k - 1], y[0] - contact.mu * y[k]);
      }
    }
    return changed;
  }

  /// x and the trial point become the minimum of the quadratic of the rows that push now. The trees are computed anew only if
  /// rows of planes or joint limits changed.
  void solve() {
    if (trees_known_) {
      own_.system = own_.trees;
      own_.x = own_.trees_x;
    } else {
      eliminate_trees();
      write_down_trees();
      own_.trees = own_.system;
      own_.trees_x = own_.x;
    }
    for (const CoupledContact& contact : own_.contacts) add_rows(contact);
    own_.system.solve(own_.x);
    spread();
  }

  /// Eliminates the hinges that are not kept.
  void eliminate_trees() {
    gather_active(model_, work_);
    for (std::size_t i = model_.links.size() - 1; i > 0; --i) {
      LinkWork& link = work_.links[i];
      LinkWork& parent = work_.links[model_.links[i].parent];
      if (!is_kept(i)) {
        eliminate_hinge(link, parent);
        continue;
      }
      link.reach = link.articulated * link.axis;
      link.torque -= kernel::dot(link.axis, link.force);
      kernel::add(link.articulated, parent.articulated);
      parent.force = parent.force + link.force;
    }
  }

  /// A and b: a hinge's inertia is U = inertia S of all links beyond it, with a hinge further in S_k' U, with the root U itself.
  void write_down_trees() {
    SymmetricSystem& system = own_.system;
    system.reset(own_.x.size());
    for (const std::size_t i : own_.kept) {
      const LinkWork& link = work_.links[i];
      for (std::size_t k = i; k > 0; k = model_.links[k].parent) {
        const Real inertia = kernel::dot(work_.links[k].axis, link.reach) + (k == i ? link.load : Real{});
        for_each_lane([&](std::size_t lane) { system(hinge_index(lane, i), hinge_index(lane, k)) = inertia[lane]; });
      }
      for_each_lane([&](std::size_t lane) {
        const std::size_t row = hinge_index(lane, i);
        for (int k = 0; k < 3; ++k) {
          system(row, root_index(lane) + static_cast<std::size_t>(k)) = link.reach.angular[k][lane];
          system(row, root_index(lane) + 3 + static_cast<std::size_t>(k)) = link.reach.linear[k][lane];
        }
        own_.x[row] = link.torque[lane];
      });
    }
    const LinkWork& whole = work_.links[0];
    for_each_lane([&](std::size_t lane) {
      const std::size_t root = root_index(lane);
      for (std::size_t i = 0; i < 3; ++i) {
        const int row = static_cast<int>(i);
        for (std::size_t k = i; k < 3; ++k) {
          system(root + i, root + k) = whole.articulated.angular(row, static_cast<int>(k))[lane];
          system(root + 3 + i, root + 3 + k) = whole.articulated.linear(row, static_cast<int>(k))[lane];
        }
        for (std::size_t k = 0; k < 3; ++k) system(root + i, root + 3 + k) = whole.articulated.coupling[i][k][lane];
        own_.x[root + i] = -whole.force.angular[row][lane];
        own_.x[root + 3 + i] = -whole.force.linear[row][lane];
      }
    });
  }

  /// A += J' W J, b -= J' W offset.
  void add_rows(const CoupledContact& contact) {
    const std::array<double, 4> d = contact.pushing_weights();
    const double first = d[0] + d[1];
    const double second = d[2] + d[3];
    if (first + second == 0.0) return;
    const double mu = contact.mu;
    const double to_first = mu * (d[0] - d[1]);
    const double to_second = mu * (d[2] - d[3]);
    const auto weigh = [&](const std::array<double, 3>& y) -> std::array<double, 3> {
      return {(first + second) * y[0] + to_first * y[1] + to_second * y[2], to_first * y[0] + mu * mu * first * y[1],
              to_second * y[0] + mu * mu * second * y[2]};
    };
    const std::array<const double*, 3> row = own_.rows(contact);
    const std::array<double, 3> push = weigh(contact.offset);
    for (const std::size_t index : own_.coordinates_of(contact)) {
      const std::array<double, 3> own = {row[0][index], row[1][index], row[2][index]};
      const std::array<double, 3> weighed = weigh(own);
      own_.x[index] -= dot(own, push);
      double* const __restrict column = own_.system.column(index);
      for (std::size_t i = SymmetricSystem::block_start(index); i < own_.system.column_size(); i += SymmetricSystem::block) {
        store_block(column + i,
                    load_block(column + i) + (weighed[0] * load_block(row[0] + i) + weighed[1] * load_block(row[1] + i) +
                                              weighed[2] * load_block(row[2] + i)));
      }
    }
  }

  /// The motions of all links at x.
  void spread() {
    for_each_lane([&](std::size_t lane) {
      const std::size_t root = root_index(lane);
      for (std::size_t i = 0; i < 3; ++i) {
        work_.links[0].trial.angular[static_cast<int>(i)][lane] = own_.x[root + i];
        work_.links[0].trial.linear[static_cast<int>(i)][lane] = own_.x[root + 3 + i];
      }
      for (const std::size_t link : own_.kept) work_.hinges[link - 1].trial[lane] = own_.x[hinge_index(lane, link)];
    });
    for (std::size_t i = 1; i < model_.links.size(); ++i) {
      LinkWork& link = work_.links[i];
      const Spatial& parent = work_.links[model_.links[i].parent].trial;
      Real& acceleration = work_.hinges[i - 1].trial;
      if (!is_kept(i)) acceleration = eliminated_acceleration(link, parent);
      link.trial = parent + link.axis * acceleration;
    }
  }

  const KernelModel& model_;
  Workspace& work_;
  CoupledWork& own_;
  unsigned lanes_;
  std::array<std::size_t, lane_count> rank_{};  ///< among the robots of `lanes`
  std::size_t first_root_ = 0;
  bool trees_known_ = false;  ///< whether `trees` are those of the rows of planes and limits that push now
};

}  // namespace trophic::backend::kernel
