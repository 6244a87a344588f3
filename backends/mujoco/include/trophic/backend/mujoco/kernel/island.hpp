// SPDX-License-Identifier: MIT
// Third stage of a step for robots whose links touch each other or a height field: MuJoCo's constraint problem of all of them.
#pragma once

#include <array>
#include <trophic/backend/mujoco/kernel/batch.hpp>
#include <trophic/backend/mujoco/kernel/contact.hpp>
#include <trophic/backend/mujoco/kernel/solver.hpp>

namespace trophic::backend::kernel {

// The problem is that of solver.hpp, but a contact between links adds to the inertia of two links at once, so that there is no
// tree to recurse over. Its hinges are those between a touching link and its robot's root; all others are eliminated as in
// solver.hpp, with the contacts of planes and the joint limits. In the unknowns x, accelerations of those hinges robot by robot
// from the leaves inwards, then the roots' motions,
//   (A + sum J_c' W_c J_c) x = b - sum J_c' W_c offset_c,
// where A and b are what is left of the trees, J_c maps x to the acceleration of one side of contact c seen from the other along
// its normal and tangents, and W_c is the sum of D e e' over its active rows e = (1, +-mu, 0), (1, 0, +-mu).

/// One island of robots: its problem is written down once, then solved for one set of active rows after the other.
class Island {
 public:
  Island(Batch& batch, IslandWork& work) : batch_{batch}, own_{work} {}

  /// Writes the problem down, first with the rows active at the last acceleration. Marks the links that are kept.
  void begin() {
    choose_hinges();
    own_.contacts.clear();
    own_.coordinates.clear();
    own_.jacobians.clear();
    own_.x.assign(own_.first_root + 6 * own_.lanes.size(), 0.0);
    own_.system.reset(own_.x.size());
    for_each_contact([&](const auto& contact) { add(contact); });
    read_warm_start();
    evaluate_contacts();
    own_.trees_known = own_.settled = false;
  }

  /// x becomes the minimum of the quadratic of the active rows, and so does the trial point of roots and kept hinges.
  /// Trees have been eliminated if not `trees_known`.
  void solve() {
    if (own_.trees_known) {
      own_.system = own_.trees;
      own_.x = own_.trees_x;
    } else {
      write_down_trees();
      own_.trees = own_.system;
      own_.trees_x = own_.x;
    }
    for (const IslandContact& contact : own_.contacts) add_rows(contact);
    own_.system.solve(own_.x);
    spread();
  }

  /// Finds the rows of contacts active at x; returns whether they differ from the last ones.
  bool evaluate_contacts() {
    bool changed = false;
    const auto update = [&](bool& active, double residual) {
      changed |= active != (residual < 0.0);
      active = residual < 0.0;
    };
    for (IslandContact& contact : own_.contacts) {
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

 private:
  /// Contacts between links of these robots, and with the height field.
  template <class Visit>
  void for_each_contact(const Visit& visit) const {
    for (const LinkContact* contact : own_.link_contacts) visit(*contact);
    for (const LaneIndex& at : own_.lanes) {
      for (const FieldContact& contact : batch_.pack(at).work.field_contacts) {
        if (contact.lane == at.lane) visit(ContactAt{contact, at});
      }
    }
  }

  /// A contact with the height field and its robot's lane.
  struct ContactAt {
    const FieldContact& contact;
    const LaneIndex& at;
  };

  /// Those between a link that touches and the root of its robot.
  void choose_hinges() {
    own_.first_hinges.clear();
    own_.hinge_indices.clear();
    for (const LaneIndex& at : own_.lanes) {
      own_.first_hinges.push_back(own_.hinge_indices.size());
      own_.hinge_indices.resize(own_.hinge_indices.size() + batch_.pack(at).work.links.size(), IslandWork::eliminated);
    }
    constexpr std::size_t chosen = 0;
    const auto choose = [&](const LaneIndex& at, std::size_t link) {
      const LaneModel& model = batch_.pack(at).model;
      for (; link > 0 && hinge_index(at, link) != chosen; link = model.links[link].parent) hinge_index(at, link) = chosen;
    };
    for (const LinkContact* contact : own_.link_contacts) {
      for (std::size_t side = 0; side < 2; ++side) choose(contact->at[side], contact->link[side]);
    }
    for (const LaneIndex& at : own_.lanes) {
      for (const FieldContact& contact : batch_.pack(at).work.field_contacts) {
        if (contact.lane == at.lane) choose(at, contact.link);
      }
    }
    own_.first_root = 0;
    for (const LaneIndex& at : own_.lanes) {
      std::vector<IslandLink>& links = batch_.pack(at).work.island_links;
      for (std::size_t link = links.size() - 1; link > 0; --link) {
        if (!is_kept(at, link)) continue;
        hinge_index(at, link) = own_.first_root++;
        links[link].kept[at.lane] = -1;
      }
    }
  }

  /// Index in x of a link's hinge to its parent.
  [[nodiscard]] std::size_t& hinge_index(const LaneIndex& at, std::size_t link) {
    return own_.hinge_indices[own_.first_hinges[batch_.rank_of[at.slot()]] + link];
  }
  [[nodiscard]] bool is_kept(const LaneIndex& at, std::size_t link) { return hinge_index(at, link) != IslandWork::eliminated; }
  /// Index in x of a root's angular acceleration; the linear one follows.
  [[nodiscard]] std::size_t root_index(const LaneIndex& at) const { return own_.first_root + 6 * batch_.rank_of[at.slot()]; }

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
  [[nodiscard]] IslandContact new_contact() {
    const std::size_t jacobian = own_.jacobians.size();
    own_.jacobians.resize(jacobian + 3 * own_.system.column_size());
    return {.first = own_.coordinates.size(), .jacobian = jacobian};
  }

  void add_coordinate(IslandContact& contact, std::size_t index, const std::array<double, 3>& motion) {
    own_.coordinates.push_back(index);
    ++contact.coordinates;
    for (std::size_t k = 0; k < 3; ++k) own_.jacobians[contact.jacobian + k * own_.system.column_size() + index] = motion[k];
  }

  /// Appends what a link's hinges, inwards, add to the contact's acceleration.
  void add_hinge(IslandContact& contact, const LaneIndex& at, std::size_t link, double sign, const std::array<double, 3>& point,
                 const Frame& frame) {
    const std::array<double, 3> motion = at_point(batch_.pack(at).work.links[link].axis, at.lane, point);
    add_coordinate(contact, hinge_index(at, link),
                   {sign * dot(frame[0], motion), sign * dot(frame[1], motion), sign * dot(frame[2], motion)});
  }
  void add_hinges(IslandContact& contact, const LaneIndex& at, std::size_t link, double sign, const std::array<double, 3>& point,
                  const Frame& frame) {
    const LaneModel& model = batch_.pack(at).model;
    for (; link > 0; link = model.links[link].parent) add_hinge(contact, at, link, sign, point, frame);
  }
  /// And what the root's motion adds: f . (w x p) = w . (p x f).
  void add_root(IslandContact& contact, const LaneIndex& at, double sign, const std::array<double, 3>& point,
                const Frame& frame) {
    const Frame arm = {cross(point, frame[0]), cross(point, frame[1]), cross(point, frame[2])};
    std::size_t index = root_index(at);
    for (const Frame* part : {&arm, &frame}) {
      for (std::size_t i = 0; i < 3; ++i) {
        add_coordinate(contact, index++, {sign * (*part)[0][i], sign * (*part)[1][i], sign * (*part)[2][i]});
      }
    }
  }

  /// As make_rows in contact.hpp, for a relative velocity at the contact and its inverse weight.
  [[nodiscard]] IslandContact rows_of(const ContactLaw& law, double depth_m, const Frame& frame,
                                      const std::array<double, 3>& velocity, double mu, double inverse_weight_per_kg) {
    const double imp = impedance(law, broadcast(depth_m))[0];
    IslandContact contact = new_contact();
    contact.weight = imp / ((1.0 - imp) * 2.0 * mu * mu * (1.0 + mu * mu) * inverse_weight_per_kg);
    contact.mu = mu;
    for (std::size_t k = 0; k < 3; ++k) contact.offset[k] = law.damping_per_s * dot(frame[k], velocity);
    contact.offset[0] += law.stiffness_per_s2 * imp * depth_m;
    return contact;
  }

  void add(const ContactAt& from) {
    const Pack& pack = batch_.pack(from.at);
    const KernelModel& body = pack.model.body(from.at.lane);
    const std::size_t link = from.contact.link;
    const auto& [point_m, frame, depth_m] = from.contact.contact;
    const std::array<double, 3> velocity = at_point(pack.work.links[link].velocity, from.at.lane, point_m);
    IslandContact contact = rows_of(body.law, depth_m, frame, velocity, body.friction, body.links[link].inverse_weight_per_kg);
    add_hinges(contact, from.at, link, 1.0, point_m, frame);
    add_root(contact, from.at, 1.0, point_m, frame);
    own_.contacts.push_back(contact);
  }

  /// The contact constrains the second link's motion seen from the first.
  void add(const LinkContact& from) {
    const Pack& first = batch_.pack(from.at[0]);
    const Pack& second = batch_.pack(from.at[1]);
    const KernelModel& first_body = first.model.body(from.at[0].lane);
    const KernelModel& second_body = second.model.body(from.at[1].lane);
    const double inverse_weight_per_kg =
        first_body.links[from.link[0]].own_inverse_weight_per_kg + second_body.links[from.link[1]].own_inverse_weight_per_kg;
    const std::array<double, 3> before = at_point(first.work.links[from.link[0]].velocity, from.at[0].lane, from.point_m[0]);
    std::array<double, 3> velocity = at_point(second.work.links[from.link[1]].velocity, from.at[1].lane, from.point_m[1]);
    for (std::size_t i = 0; i < 3; ++i) velocity[i] -= before[i];
    const double mu = std::max(first_body.link_friction, second_body.link_friction);
    IslandContact contact = rows_of(first_body.law, from.depth_m, from.frame, velocity, mu, inverse_weight_per_kg);
    if (from.at[0] != from.at[1]) {
      add_hinges(contact, from.at[0], from.link[0], -1.0, from.point_m[0], from.frame);
      add_hinges(contact, from.at[1], from.link[1], 1.0, from.point_m[1], from.frame);
      add_root(contact, from.at[0], -1.0, from.point_m[0], from.frame);
      add_root(contact, from.at[1], 1.0, from.point_m[1], from.frame);
    } else {
      add_loop(contact, from);
    }
    own_.contacts.push_back(contact);
  }

  /// Two links of one robot: what moves both does not count.
  void add_loop(IslandContact& contact, const LinkContact& from) {
    const LaneModel& model = batch_.pack(from.at[0]).model;
    auto [first, second] = from.link;
    while (first != second) {
      std::size_t& outer = first > second ? first : second;
      add_hinge(contact, from.at[0], outer, first > second ? -1.0 : 1.0, from.point_m[0], from.frame);
      outer = model.links[outer].parent;
    }
  }

  void read_warm_start() {
    for (const LaneIndex& at : own_.lanes) {
      const Pack& pack = batch_.pack(at);
      const LaneArray& warm = pack.current().acceleration;
      const Mat3& rotation = pack.work.links[0].rotation;
      const std::size_t root = root_index(at);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          own_.x[root + i] += rotation.column[k][static_cast<int>(i)][at.lane] * warm[3 + k][at.lane];
        }
        own_.x[root + 3 + i] = warm[i][at.lane];
      }
      for (std::size_t link = 1; link < pack.work.links.size(); ++link) {
        if (is_kept(at, link)) own_.x[hinge_index(at, link)] = warm[5 + link][at.lane];
      }
    }
  }

  /// A and b: a hinge's inertia is U = inertia S of all links beyond it, with a hinge further in S_k' U, with the root U itself.
  void write_down_trees() {
    SymmetricSystem& system = own_.system;
    system.reset(own_.x.size());
    for (const LaneIndex& at : own_.lanes) {
      const Pack& pack = batch_.pack(at);
      const std::size_t root = root_index(at);
      const std::size_t lane = at.lane;
      for (std::size_t i = 1; i < pack.work.links.size(); ++i) {
        if (!is_kept(at, i)) continue;
        const LinkWork& link = pack.work.links[i];
        const std::size_t row = hinge_index(at, i);
        for (std::size_t k = i; k > 0; k = pack.model.links[k].parent) {
          const double inertia = along(pack.work.links[k].axis, link.reach, lane) + (k == i ? link.load[lane] : 0.0);
          system(row, hinge_index(at, k)) = inertia;
        }
        for (int k = 0; k < 3; ++k) {
          system(row, root + static_cast<std::size_t>(k)) = link.reach.angular[k][lane];
          system(row, root + 3 + static_cast<std::size_t>(k)) = link.reach.linear[k][lane];
        }
        own_.x[row] = link.torque[lane];
      }
      const LinkWork& whole = pack.work.links[0];
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
    }
  }

  /// S' U in one lane, in the order of operations of `dot`.
  [[nodiscard]] static double along(const Spatial& axis, const Spatial& reach, std::size_t lane) {
    return dot(pick(axis.angular, lane), pick(reach.angular, lane)) + dot(pick(axis.linear, lane), pick(reach.linear, lane));
  }

  /// A += J' W J, b -= J' W offset.
  void add_rows(const IslandContact& contact) {
    const std::array<double, 4> d = contact.active_weights();
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
    const std::array<double, 3> weighed_offset = weigh(contact.offset);
    for (const std::size_t index : own_.coordinates_of(contact)) {
      const std::array<double, 3> own = {row[0][index], row[1][index], row[2][index]};
      const std::array<double, 3> weighed = weigh(own);
      own_.x[index] -= dot(own, weighed_offset);
      double* const __restrict column = own_.system.column(index);
      for (std::size_t i = SymmetricSystem::block_start(index); i < own_.system.column_size(); i += SymmetricSystem::block) {
        store_block(column + i,
                    load_block(column + i) + (weighed[0] * load_block(row[0] + i) + weighed[1] * load_block(row[1] + i) +
                                              weighed[2] * load_block(row[2] + i)));
      }
    }
  }

  /// The motions of the roots and the accelerations of the kept hinges at x.
  void spread() {
    for (const LaneIndex& at : own_.lanes) {
      Workspace& work = batch_.pack(at).work;
      const std::size_t root = root_index(at);
      for (std::size_t i = 0; i < 3; ++i) {
        work.links[0].trial.angular[static_cast<int>(i)][at.lane] = own_.x[root + i];
        work.links[0].trial.linear[static_cast<int>(i)][at.lane] = own_.x[root + 3 + i];
      }
      for (std::size_t link = 1; link < work.links.size(); ++link) {
        if (is_kept(at, link)) work.hinges[link - 1].trial[at.lane] = own_.x[hinge_index(at, link)];
      }
    }
  }

  Batch& batch_;
  IslandWork& own_;
};

/// Eliminates the hinges of a pack that are not unknowns of islands.
TROPHIC_LANES_INLINE void eliminate_trees(Pack& pack) {
  const LaneModel& model = pack.model;
  Workspace& work = pack.work;
  gather_active(model, work);
  for (std::size_t i = work.links.size() - 1; i > 0; --i) {
    LinkWork& link = work.links[i];
    link.reach = link.articulated * link.axis;
    link.inverse = where(~work.island_links[i].kept, 1.0 / (dot(link.axis, link.reach) + link.load));
    link.torque -= dot(link.axis, link.force);
    pass_inwards(link, work.links[model.links[i].parent]);
  }
}

/// The motions of all links of a pack, given those of the roots and the kept hinges.
TROPHIC_LANES_INLINE void move_eliminated(Pack& pack) {
  Workspace& work = pack.work;
  for (std::size_t i = 1; i < work.links.size(); ++i) {
    LinkWork& link = work.links[i];
    const Spatial& parent = work.links[pack.model.links[i].parent].trial;
    Real& acceleration = work.hinges[i - 1].trial;
    acceleration = select(work.island_links[i].kept, acceleration, eliminated_acceleration(link, parent));
    link.trial = parent + link.axis * acceleration;
  }
}

}  // namespace trophic::backend::kernel
