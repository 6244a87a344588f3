// SPDX-License-Identifier: MIT
// Third stage of a step for robots whose links touch each other or a height field: MuJoCo's constraint problem of all of them.
#pragma once

#include <algorithm>
#include <array>
#include <trophic/backend/mujoco/kernel/batch.hpp>
#include <trophic/backend/mujoco/kernel/solver.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

// The problem is that of solver.hpp, but a contact between links adds to the inertia of two links at once, so that there is no
// tree to recurse over. Its hinges are those between a touching link and its robot's root; all others are eliminated as in
// solver.hpp, with the contacts of planes and the joint limits. In the unknowns x, accelerations of those hinges robot by robot
// from the leaves inwards, then the roots' motions,
//   (A + sum S_p' K_p S_p) x = b - sum S_p' g_p,
// where A and b are what is left of the trees and S_p maps x to the motion of one link of pair p seen from the other, from the
// origin of the first one's root. The contacts of the pair are summed before: K = sum B' W B and g = sum B' W offset, where B
// maps that motion to a contact's normal and tangents, and W is the sum of D e e' over its active rows e = (1, +-mu, 0), (1, 0,
// +-mu).

/// One island of robots: its problem is set up once, then solved for one set of active rows after the other.
class Island {
 public:
  Island(Batch& batch, IslandWork& work) : batch_{batch}, own_{work} {}

  /// Sets up the problem, first with the rows active at the trial point.
  void begin() {
    choose_hinges();
    own_.pairs.clear();
    own_.contacts.clear();
    own_.x.resize(own_.first_root + 6 * own_.lanes.size());
    for_each_contact([&](const auto& contact) { add(contact); });
    for (const TouchingLinks& pair : own_.pairs) make_rows(pair);
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
    RootRows roots{};
    for (std::size_t p = 0; p < own_.pairs.size(); ++p) {
      const TouchingLinks& pair = own_.pairs[p];
      add_rows(pair, roots);
      if (p + 1 < own_.pairs.size() && own_.pairs[p + 1].at == pair.at && own_.pairs[p + 1].on_field == pair.on_field) continue;
      if (!pair.loops()) add_to_roots(pair, roots);
      roots = RootRows{};
    }
    own_.system.solve(own_.x);
    spread();
  }

  /// Finds the rows of contacts active at the trial point; returns whether they differ from the last ones.
  bool evaluate_contacts() {
    Mask changed{};
    for (const TouchingLinks& pair : own_.pairs) {
      const Motion motion = relative(pair, [](const LinkWork& link) -> const Spatial& { return link.trial; });
      for_each_block(pair, [&](IslandContacts& contacts) {
        Vec3 residual;
        for (int k = 0; k < 3; ++k) residual[k] = contacts.along(k, motion) + contacts.offset[k];
        changed |= update_rows(residual, pair.mu, 1.0, contacts.active);
      });
    }
    return lane_bits(changed) != 0;
  }

 private:
  /// Contacts between links of these robots, and contacts with the height field.
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

  /// The hinges between a touching link and the root of its robot.
  TROPHIC_LANES_INLINE void choose_hinges() {
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

  /// Calls `visit` with a pair's contacts, four at a time.
  template <class Visit>
  void for_each_block(const TouchingLinks& pair, const Visit& visit) {
    for (std::size_t k = pair.first; k != TouchingLinks::none; k = own_.contacts[k].next) visit(own_.contacts[k]);
  }

  [[nodiscard]] static Four pick(const Vec3& vector, std::size_t lane) {
    return Four{vector[0][lane], vector[1][lane], vector[2][lane], 0.0};
  }
  [[nodiscard]] static double whole(const Four& a) { return (a[0] + a[1]) + (a[2] + a[3]); }
  [[nodiscard]] static double dot(const Motion& a, const Motion& b) { return whole(a.angular * b.angular + a.linear * b.linear); }

  /// A motion at one side of a pair, given from its own root's origin: the second link's is positive.
  [[nodiscard]] static Motion motion_of(const TouchingLinks& pair, std::size_t side, const Spatial& motion) {
    const Four angular = pick(motion.angular, pair.at[side].lane);
    const Four linear = pick(motion.linear, pair.at[side].lane);
    if (side == 0) return {-angular, -linear};
    return {angular, linear + cross3(pair.apart_m, angular)};
  }
  /// A force at the pair as one on the second's root, at that one's origin.
  [[nodiscard]] static Motion on_second(const TouchingLinks& pair, const Motion& force) {
    return {force.angular + cross3(force.linear, pair.apart_m), force.linear};
  }
  /// The second link's motion seen from the first.
  template <class Of>
  [[nodiscard]] Motion relative(const TouchingLinks& pair, const Of& of) const {
    const auto side = [&](std::size_t k) { return motion_of(pair, k, of(batch_.pack(pair.at[k]).work.links[pair.link[k]])); };
    return pair.on_field ? side(1) : side(1) + side(0);
  }

  /// The entries of these links among the touching ones; new entries have no contact yet.
  [[nodiscard]] TROPHIC_LANES_INLINE TouchingLinks& pair_of(const std::array<LaneIndex, 2>& at,
                                                            const std::array<std::size_t, 2>& link) {
    for (std::size_t k = own_.pairs.size(); k-- > 0;) {
      if (own_.pairs[k].at == at && own_.pairs[k].link == link) return own_.pairs[k];
    }
    TouchingLinks& pair = own_.pairs.emplace_back();
    pair.at = at;
    pair.link = link;
    return pair;
  }

  TROPHIC_LANES_INLINE void add_contact(TouchingLinks& pair, const Point3& point_m, const std::array<Point3, 3>& frame,
                                        double depth_m) {
    if (pair.contacts++ % lane_count == 0) {
      (pair.first == TouchingLinks::none ? pair.first : own_.contacts[pair.last].next) = own_.contacts.size();
      pair.last = own_.contacts.size();
      own_.contacts.emplace_back();
    }
    IslandContacts& to = own_.contacts[pair.last];
    const std::size_t lane = to.count++;
    to.depth_m[lane] = depth_m;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t u = (i + 1) % 3;
        const std::size_t v = (i + 2) % 3;
        to.rows[k][i][lane] = point_m[u] * frame[k][v] - point_m[v] * frame[k][u];
        to.rows[k][3 + i][lane] = frame[k][i];
      }
    }
  }

  void add(const ContactAt& from) {
    const std::size_t link = from.contact.link;
    TouchingLinks& pair = pair_of({from.at, from.at}, {link, link});
    if (pair.contacts == 0) {
      const KernelModel& body = batch_.pack(from.at).model.body(from.at.lane);
      pair.on_field = true;
      pair.mu = body.friction;
      pair.inverse_weight_per_kg = body.links[link].inverse_weight_per_kg;
    }
    add_contact(pair, from.contact.contact.point_m, from.contact.contact.frame, from.contact.contact.depth_m);
  }

  void add(const LinkContact& from) {
    TouchingLinks& pair = pair_of(from.at, from.link);
    if (pair.contacts == 0) {
      const KernelModel& first = batch_.pack(from.at[0]).model.body(from.at[0].lane);
      const KernelModel& second = batch_.pack(from.at[1]).model.body(from.at[1].lane);
      pair.apart_m = lanes3(from.apart_m);
      pair.mu = std::max(first.link_friction, second.link_friction);
      pair.inverse_weight_per_kg =
          first.links[from.link[0]].own_inverse_weight_per_kg + second.links[from.link[1]].own_inverse_weight_per_kg;
    }
    add_contact(pair, from.point_m, from.frame, from.depth_m);
  }

  /// Like make_rows in contact.hpp, for all contacts of a pair of links.
  TROPHIC_LANES_INLINE void make_rows(const TouchingLinks& pair) {
    const ContactLaw& law = batch_.pack(pair.at[0]).model.body(pair.at[0].lane).law;
    const Motion velocity = relative(pair, [](const LinkWork& link) -> const Spatial& { return link.velocity; });
    const double scale = 2.0 * pair.mu * pair.mu * (1.0 + pair.mu * pair.mu) * pair.inverse_weight_per_kg;
    for_each_block(pair, [&](IslandContacts& contacts) {
      const Real imp = impedance(law, contacts.depth_m);
      contacts.weight = imp / ((1.0 - imp) * scale);
      for (int k = 0; k < 3; ++k) contacts.offset[k] = law.damping_per_s * contacts.along(k, velocity);
      contacts.offset[0] += law.stiffness_per_s2 * imp * contacts.depth_m;
    });
  }

  /// A and b: a hinge's inertia is U = inertia S of all links beyond it, with a hinge further in S_k' U, with the root U itself.
  TROPHIC_LANES_INLINE void write_down_trees() {
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

  /// S' U in one lane.
  [[nodiscard]] static double along(const Spatial& axis, const Spatial& reach, std::size_t lane) {
    return whole(pick(axis.angular, lane) * pick(reach.angular, lane) + pick(axis.linear, lane) * pick(reach.linear, lane));
  }

  /// K and g of all links of two robots that touch.
  struct RootRows {
    Motion inertia[6];
    Motion force;
    [[nodiscard]] Motion times(const Motion& s) const {
      Motion product{};
      for (std::size_t i = 0; i < 3; ++i) product = product + inertia[i] * s.angular[i] + inertia[3 + i] * s.linear[i];
      return product;
    }
  };

  /// Computed number by number, because overlapping blocks would wait for the previous store. Entries above the diagonal are
  /// meaningless.
  static void add(double* to, const Motion& what) {
    for (std::size_t i = 0; i < 3; ++i) {
      to[i] += what.angular[i];
      to[3 + i] += what.linear[i];
    }
  }

  /// A += S' K S, b -= S' g in all rows but those between roots, whose K and g are summed.
  TROPHIC_LANES_INLINE void add_rows(const TouchingLinks& pair, RootRows& roots) {
    Real sums[21] = {};
    Real forces[6] = {};
    Real pressed{};
    for_each_block(pair, [&](const IslandContacts& contacts) { pressed += sum_contacts(contacts, pair.mu, sums, forces); });
    if (lane_bits(pressed > 0.0) == 0) return;
    const auto entry = [&](std::size_t i, std::size_t j) { return sums[i < j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j]; };
    RootRows own;
    own.force = {wholes(forces[0], forces[1], forces[2]), wholes(forces[3], forces[4], forces[5])};
    roots.force = roots.force + own.force;
    for (std::size_t i = 0; i < 6; ++i) {
      own.inertia[i] = {wholes(entry(i, 0), entry(i, 1), entry(i, 2)), wholes(entry(i, 3), entry(i, 4), entry(i, 5))};
      roots.inertia[i] = roots.inertia[i] + own.inertia[i];
    }
    list_hinges(pair);
    for (std::size_t i = 0; i < own_.columns.size(); ++i) {
      const auto& [index, motion] = own_.columns[i];
      const Motion pushed = own.times(motion);
      own_.x[index] -= dot(motion, own.force);
      for (std::size_t j = 0; j <= i; ++j) own_.system(index, own_.columns[j].first) += dot(own_.columns[j].second, pushed);
      double* const column = own_.system.column(index);
      if (!pair.loops()) add(column + root_index(pair.at[1]), on_second(pair, pushed));
      if (pair.at[0] != pair.at[1]) add(column + root_index(pair.at[0]), pushed * -1.0);
    }
  }

  /// The same between the roots of a pair's robots.
  TROPHIC_LANES_INLINE void add_to_roots(const TouchingLinks& pair, const RootRows& roots) {
    const std::size_t first = root_index(pair.at[0]);
    const std::size_t second = root_index(pair.at[1]);
    const bool two = first != second;
    add(own_.x.data() + second, on_second(pair, roots.force) * -1.0);
    if (two) add(own_.x.data() + first, roots.force);
    for (std::size_t k = 0; k < 6; ++k) {
      if (two) add(own_.system.column(first + k) + first, roots.inertia[k]);
      if (two) add(own_.system.column(first + k) + second, on_second(pair, roots.inertia[k]) * -1.0);
      Four unit{};
      unit[k % 3] = 1.0;
      const Motion moved = k < 3 ? roots.inertia[k] + roots.times({Four{}, cross3(pair.apart_m, unit)}) : roots.inertia[k];
      add(own_.system.column(second + k) + second, on_second(pair, moved));
    }
  }

  /// The hinges that move a pair's links, and their effect; for two links of one robot, those that do not move both.
  TROPHIC_LANES_INLINE void list_hinges(const TouchingLinks& pair) {
    own_.columns.clear();
    auto link = pair.link;
    const auto add = [&](std::size_t side) {
      const Pack& pack = batch_.pack(pair.at[side]);
      const std::size_t index = hinge_index(pair.at[side], link[side]);
      own_.columns.emplace_back(index, motion_of(pair, side, pack.work.links[link[side]].axis));
      link[side] = pack.model.links[link[side]].parent;
    };
    if (pair.loops()) {
      while (link[0] != link[1]) add(link[0] > link[1] ? 0 : 1);
      return;
    }
    while (!pair.on_field && link[0] > 0) add(0);
    while (link[1] > 0) add(1);
  }

  /// Adds B' W B, its lower half row by row, and B' W offset of four contacts; returns their active weights.
  static Real sum_contacts(const IslandContacts& contacts, double mu, Real (&sums)[21], Real (&forces)[6]) {
    const RowSum w = sum_rows(contacts, mu, 1.0);
    const Vec3& o = contacts.offset;
    const Real pushed[3] = {w.normal * o[0] + w.first_coupling * o[1] + w.second_coupling * o[2],
                            w.first_coupling * o[0] + w.first * o[1], w.second_coupling * o[0] + w.second * o[2]};
    for (std::size_t i = 0, k = 0; i < 6; ++i) {
      const Real b0 = contacts.rows[0][i], b1 = contacts.rows[1][i], b2 = contacts.rows[2][i];
      const Real w0 = w.normal * b0 + w.first_coupling * b1 + w.second_coupling * b2;
      const Real w1 = w.first_coupling * b0 + w.first * b1;
      const Real w2 = w.second_coupling * b0 + w.second * b2;
      forces[i] += b0 * pushed[0] + b1 * pushed[1] + b2 * pushed[2];
      for (std::size_t j = 0; j <= i; ++j) {
        sums[k++] += w0 * contacts.rows[0][j] + w1 * contacts.rows[1][j] + w2 * contacts.rows[2][j];
      }
    }
    return w.normal;
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

}  // namespace trophic::backend::kernel::TROPHIC_LANES
