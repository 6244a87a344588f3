// SPDX-License-Identifier: MIT
// Third stage of a step for robots whose links touch each other or a height field: MuJoCo's constraint problem of all of them.
#pragma once

#include <array>
#include <bit>
#include <trophic/backend/mujoco/kernel/contact.hpp>
#include <trophic/backend/mujoco/kernel/workspace.hpp>

namespace trophic::backend::kernel {

// The problem is that of solver.hpp, but a contact between links adds to the inertia of two links at once, so that there is no
// tree to recurse over. In the unknowns x, joint accelerations from the leaves inwards, then the roots' motions,
//   (M + sum J_c' W_c J_c) x = tau - sum J_c' W_c offset_c,
// where J_c maps x to the acceleration of one side of contact c seen from the other along its normal and tangents, and W_c is the
// sum of D e e' over its pushing rows e = (1, +-mu, 0), (1, 0, +-mu).

/// The search of some robots: their problem is written down once, then solved for one set of pushing rows after the other.
class CoupledSearch {
 public:
  CoupledSearch(const KernelModel& model, Workspace& work, unsigned lanes)
      : model_{model}, work_{work}, own_{work.coupled}, lanes_{lanes} {
    std::size_t robots = 0;
    for_each_lane([&](std::size_t lane) { rank_[lane] = robots++; });
    hinges_ = model.hinges.size();
    first_root_ = robots * hinges_;
    own_.contacts.clear();
    own_.coordinates.clear();
    own_.jacobians.clear();
    own_.x.assign(first_root_ + 6 * robots, 0.0);
    own_.system.reset(own_.x.size());
    own_.limits.assign(first_root_, {});
    for_each_lane([&](std::size_t lane) {
      add_plane_contacts(lane);
      add_limits(lane);
    });
    for (const LinkContact& contact : work.link_contacts) {
      if ((lanes & (1u << contact.lane[0])) != 0) add_link_contact(contact);
    }
    for (const FieldContact& contact : work.field_contacts) {
      if ((lanes & (1u << contact.lane)) != 0) add_field_contact(contact);
    }
  }

  /// Full Newton steps from the warm start until the pushing rows no longer change; the minimum becomes the trial point of the
  /// robots. False where they go on changing: MuJoCo's line search must do it.
  [[nodiscard]] bool minimise(const LaneState& state) {
    read_warm_start(state);
    evaluate();
    for (int step = 0; step < most_steps; ++step) {
      solve_active();
      if (!evaluate()) {
        write_trial();
        return true;
      }
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

  /// Index in x of the hinge that a link hangs on; leaves come first.
  [[nodiscard]] std::size_t hinge_index(std::size_t lane, std::size_t link) const {
    return rank_[lane] * hinges_ + hinges_ - link;
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

  void add_plane_contacts(std::size_t lane) {
    for (std::size_t g = 0; g < work_.group_count; ++g) {
      const ContactGroup& group = work_.groups[g];
      const Plane& plane = model_.planes[group.plane];
      const auto axis = static_cast<std::size_t>(plane.axis);
      std::array<std::array<double, 3>, 3> frame{};
      frame[0][axis] = plane.sign;
      frame[1][(axis + 1) % 3] = 1.0;
      frame[2][(axis + 2) % 3] = 1.0;
      for (std::size_t c = group.first; c < group.first + group.count; ++c) {
        const ContactWork& from = work_.contacts[c];
        if (!(from.depth[lane] < 0.0)) continue;
        CoupledContact contact = new_contact();
        contact.weight = from.weight[lane];
        contact.mu = model_.friction;
        contact.offset = {plane.sign * from.offset[0][lane], from.offset[1][lane], from.offset[2][lane]};
        add_hinges(contact, lane, group.link, 1.0, pick(from.point, lane), frame);
        add_root(contact, lane, 1.0, pick(from.point, lane), frame);
        own_.contacts.push_back(contact);
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

  void add_field_contact(const FieldContact& from) {
    const auto& [point_m, frame, depth_m] = from.contact;
    const std::array<double, 3> velocity = at_point(work_.links[from.link].velocity, from.lane, point_m);
    CoupledContact contact = rows_of(depth_m, frame, velocity, model_.friction, model_.links[from.link].inverse_weight_per_kg);
    add_hinges(contact, from.lane, from.link, 1.0, point_m, frame);
    add_root(contact, from.lane, 1.0, point_m, frame);
    own_.contacts.push_back(contact);
  }

  /// Of the second link's motion seen from the first.
  void add_link_contact(const LinkContact& from) {
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

  void add_limits(std::size_t lane) {
    for (std::size_t j = 0; j < hinges_; ++j) {
      const HingeWork& from = work_.hinges[j];
      own_.limits[hinge_index(lane, j + 1)] = {
          .weight = from.limit_weight[lane], .side = from.limit_side[lane], .offset = from.limit_offset[lane]};
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
      for (std::size_t j = 0; j < hinges_; ++j) own_.x[hinge_index(lane, j + 1)] = warm[6 + j][lane];
    });
  }

  /// Which rows push at x; true where the answer differs from the last one.
  bool evaluate() {
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
    for (std::size_t i = 0; i < first_root_; ++i) {
      CoupledLimit& limit = own_.limits[i];
      if (limit.weight > 0.0) update(limit.active, limit.offset - limit.side * own_.x[i]);
    }
    return changed;
  }

  /// x becomes the minimum of the quadratic of the rows that push now.
  void solve_active() {
    own_.system.reset(own_.x.size());
    for_each_lane([&](std::size_t lane) { add_masses(lane); });
    for (std::size_t i = 0; i < first_root_; ++i) {
      const CoupledLimit& limit = own_.limits[i];
      if (!limit.active) continue;
      own_.system(i, i) += limit.weight;
      own_.x[i] += limit.side * limit.weight * limit.offset;
    }
    for (const CoupledContact& contact : own_.contacts) add_contact(contact);
    own_.system.solve(own_.x);
  }

  /// Mass matrix and generalised forces of one robot.
  void add_masses(std::size_t lane) {
    SymmetricSystem& system = own_.system;
    const auto both = [lane](const Spatial& a, const Spatial& b) {
      return dot(pick(a.angular, lane), pick(b.angular, lane)) + dot(pick(a.linear, lane), pick(b.linear, lane));
    };
    const std::size_t root = root_index(lane);
    for (std::size_t i = 1; i < model_.links.size(); ++i) {
      const std::size_t row = hinge_index(lane, i);
      const CompositeWork& composite = work_.composites[i];
      for (std::size_t k = i; k > 0; k = model_.links[k].parent) {
        system(row, hinge_index(lane, k)) = both(work_.links[k].axis, composite.momentum);
      }
      const std::array<double, 3> angular = pick(composite.momentum.angular, lane);
      const std::array<double, 3> linear = pick(composite.momentum.linear, lane);
      for (std::size_t k = 0; k < 3; ++k) {
        system(row, root + k) = angular[k];
        system(row, root + 3 + k) = linear[k];
      }
      own_.x[row] = work_.hinges[i - 1].torque[lane] - both(work_.links[i].axis, composite.bias);
    }
    const CompositeWork& whole = work_.composites[0];
    const std::array<double, 3> h = pick(whole.inertia.moment, lane);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = i; k < 3; ++k) {
        system(root + i, root + k) = whole.inertia.rotational(static_cast<int>(i), static_cast<int>(k))[lane];
      }
      system(root + 3 + i, root + 3 + i) = whole.inertia.mass_kg;
      system(root + i, root + 3 + (i + 1) % 3) = -h[(i + 2) % 3];
      system(root + i, root + 3 + (i + 2) % 3) = h[(i + 1) % 3];
      own_.x[root + i] = -whole.bias.angular[static_cast<int>(i)][lane];
      own_.x[root + 3 + i] = -whole.bias.linear[static_cast<int>(i)][lane];
    }
  }

  /// A += J' W J, b -= J' W offset.
  void add_contact(const CoupledContact& contact) {
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

  void write_trial() {
    for_each_lane([&](std::size_t lane) {
      const std::size_t root = root_index(lane);
      for (std::size_t i = 0; i < 3; ++i) {
        work_.links[0].trial.angular[static_cast<int>(i)][lane] = own_.x[root + i];
        work_.links[0].trial.linear[static_cast<int>(i)][lane] = own_.x[root + 3 + i];
      }
      for (std::size_t j = 0; j < hinges_; ++j) work_.hinges[j].trial[lane] = own_.x[hinge_index(lane, j + 1)];
    });
  }

  const KernelModel& model_;
  Workspace& work_;
  CoupledWork& own_;
  unsigned lanes_;
  std::array<std::size_t, lane_count> rank_{};  ///< among the robots of `lanes`
  std::size_t hinges_ = 0;
  std::size_t first_root_ = 0;
};

/// For each lane, the lanes that contacts between links tie its robot to, itself among them.
[[nodiscard]] inline std::array<unsigned, lane_count> tied_lanes(const Workspace& work) {
  std::array<unsigned, lane_count> tied{};
  for (std::size_t lane = 0; lane < lane_count; ++lane) tied[lane] = 1u << lane;
  for (const LinkContact& contact : work.link_contacts) {
    const unsigned both = tied[contact.lane[0]] | tied[contact.lane[1]];
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      if ((both & (1u << lane)) != 0) tied[lane] = both;
    }
  }
  return tied;
}

/// Minimises the cost of the robots in `coupled`, set by set of robots that touch, as `trial` of links and hinges. Returns the
/// lanes that did not settle.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned minimise_coupled(const KernelModel& model, const LaneState& state, Workspace& work,
                                                             unsigned coupled) {
  const std::array<unsigned, lane_count> tied = tied_lanes(work);
  unsigned unsettled = 0;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const bool first = static_cast<std::size_t>(std::countr_zero(tied[lane])) == lane;
    if ((coupled & (1u << lane)) == 0 || !first) continue;
    if (!CoupledSearch{model, work, tied[lane]}.minimise(state)) unsettled |= tied[lane];
  }
  return unsettled;
}

}  // namespace trophic::backend::kernel
