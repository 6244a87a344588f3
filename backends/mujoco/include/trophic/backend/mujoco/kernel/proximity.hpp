// SPDX-License-Identifier: MIT
// Contacts of links with each other or a height field.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <trophic/backend/mujoco/kernel/batch.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

/// Far above the rounding errors of distances and of `moved_m` within a block of steps, in single precision too.
inline constexpr double gap_margin_m = 1e-5;
/// The number in RobotGaps of links or boxes that may touch.
inline constexpr double no_gap_m = -1.0;

/// One lane of the rotation times a vector.
[[nodiscard]] TROPHIC_LANES_INLINE double rotated(const Mat3& rotation, const double* a, int i, std::size_t lane) {
  return rotation.column[0][i][lane] * a[0] + rotation.column[1][i][lane] * a[1] + rotation.column[2][i][lane] * a[2];
}

/// The centres of the boxes of a link, from the origin of the root.
TROPHIC_LANES_INLINE void place_centres(const LaneModel& model, std::size_t i, Workspace& work) {
  LinkWork& pose = work.links[i];
  if (pose.has_centres) return;
  pose.has_centres = true;
  const LaneLink& link = model.links[i];
  for (std::size_t b = link.first_box; b < link.first_box + link.boxes; ++b)
    work.box_centres[b] = box_centre(pose, model.boxes[b]);
}

/// A box of the robot in a lane, from the origin of the robot's root; computed once per stage.
[[nodiscard]] TROPHIC_LANES_INLINE const PlacedBox& placed_box(const KernelModel& model, const LinkWork& link, std::size_t box,
                                                               std::size_t lane, Workspace& work) {
  const std::size_t slot = lane * model.boxes.size() + box;
  PlacedBox& placed = work.placed_boxes[slot];
  if (work.box_placed[slot] != 0) return placed;
  work.box_placed[slot] = 1;
  const KernelBox& from = model.boxes[box];
  placed.half_m = from.geom_half_extents_m;
  for (std::size_t k = 0; k < 3; ++k) {
    placed.centre_m[k] = work.box_centres[box][static_cast<int>(k)][lane];
    for (int i = 0; i < 3; ++i)
      placed.axis[k][static_cast<std::size_t>(i)] = rotated(link.rotation, from.geom_axes.data() + 3 * k, i, lane);
  }
  return placed;
}

/// The Euclidean distance between two positions in coordinates `first` to `end`.
[[nodiscard]] TROPHIC_LANES_INLINE Real change_of(std::size_t first, std::size_t end, const LaneArray& now,
                                                  const LaneArray& last) {
  Real square{};
  for (std::size_t i = first; i < end; ++i) square += (now[i] - last[i]) * (now[i] - last[i]);
  return sqrt(square);
}

/// Counts how far links have moved. If the root's origin moves by d and its unit quaternion by q, points at distance r move by
/// d + 2 r |q| at most; a hinge that turns by an angle moves what is at distance r from its anchor by r times the angle at most.
TROPHIC_LANES_INLINE void count_motion(const LaneModel& model, const LaneState& state, Workspace& work) {
  const LaneArray& now = state.position;
  LaneArray& last = work.counted_position;
  if (!work.motion_known) {
    last = now;
    for (std::size_t i = 0; i < model.links.size(); ++i) work.moved_m[i] = work.swung_m[i] = Real{};
    work.motion_known = true;
    return;
  }
  work.moved_m[0] += change_of(0, 3, now, last) + model.links[0].reach_m * change_of(3, 7, now, last) * 2.0;
  for (std::size_t i = 1; i < model.links.size(); ++i) {
    work.swung_m[i] += abs(now[6 + i] - last[6 + i]) * model.links[i].reach_m;
    work.moved_m[i] = work.moved_m[model.links[i].parent] + work.swung_m[i];
  }
  last = now;
}

/// Lanes in which spheres around two centres overlap.
[[nodiscard]] TROPHIC_LANES_INLINE unsigned overlapping(const Vec3& a, const Vec3& b, const Real& radius_m) {
  const Vec3 between = b - a;
  return lane_bits(dot(between, between) <= radius_m * radius_m);
}

/// Appends the contacts of two boxes.
TROPHIC_LANES_INLINE void add_box_contacts(const NearBoxes& near, const BoxOverlap& overlap, Batch& batch) {
  const auto& [a, b] = near.of;
  const std::size_t known = batch.link_contacts.size();
  const auto frame = contact_frame(overlap.normal.data());
  const double scale = overlap.on_face && batch.whole_depth ? 2.0 : 1.0;
  for (std::size_t c = 0; c < overlap.count; ++c) {
    LinkContact& contact = batch.link_contacts.emplace_back();
    contact.at = {a.at, b.at};
    contact.link = {a.link, b.link};
    contact.point_m = overlap.points_m[c];
    contact.apart_m = near.apart_m;
    contact.frame = frame;
    contact.depth_m = scale * overlap.depths_m[c];
  }
  if (a.at == b.at || batch.link_contacts.size() == known) return;
  batch.step_sets.unite(a.at, b.at);
  batch.island_sets.unite(a.at, b.at);
}

/// Appends the contacts of all boxes whose spheres overlap. Boxes that overlap by rounding only, side by side, do not touch.
TROPHIC_LANES_INLINE void collide_boxes(Batch& batch) {
  const auto placed = [&](const BoxOf& of) -> const PlacedBox& {
    Pack& pack = batch.pack(of.at);
    return placed_box(pack.model.body(of.at.lane), pack.work.links[of.link], of.box, of.at.lane, pack.work);
  };
  for (const NearBoxes& near : batch.near_boxes) {
    BoxOverlap overlap{placed(near.of[0]), placed(near.of[1]), near.apart_m};
    if (overlap.separated(least_overlap_m)) {
      if (near.gap_m != nullptr) *near.gap_m = near.moved_m + overlap.gap_m - gap_margin_m;
      continue;
    }
    overlap.meet();
    keep_contacts(overlap);
    add_box_contacts(near, overlap, batch);
  }
}

/// Appends two boxes, written in place because a copy would wait for the previous store.
TROPHIC_LANES_INLINE void add_near(const BoxOf& a, const BoxOf& b, const Point3& apart_m, Batch& batch, double moved_m = 0.0,
                                   double* gap_m = nullptr) {
  NearBoxes& near = batch.near_boxes.emplace_back();
  near.of[0] = a;
  near.of[1] = b;
  near.apart_m = apart_m;
  near.moved_m = moved_m;
  near.gap_m = gap_m;
}

/// Of two robots' points, the second's robot `apart_m` from the first's.
[[nodiscard]] TROPHIC_LANES_INLINE double square_between(const Vec3& a, std::size_t lane_a, const Vec3& b, std::size_t lane_b,
                                                         const Point3& apart_m) {
  double square_m2 = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    const double between_m = b[axis][lane_b] + apart_m[k] - a[axis][lane_a];
    square_m2 += between_m * between_m;
  }
  return square_m2;
}

/// Boxes of links of two robots whose spheres overlap, of those that may have come near since they were last apart. Returns the
/// least of the gaps if all are apart, else a number below `moved_m`.
TROPHIC_LANES_INLINE double collide_links(const BoxOf& a, const BoxOf& b, const Point3& apart_m, double moved_m, double* gaps_m,
                                          Batch& batch) {
  Pack& pack_a = batch.pack(a.at);
  Pack& pack_b = batch.pack(b.at);
  const KernelModel& body_a = pack_a.model.body(a.at.lane);
  const KernelModel& body_b = pack_b.model.body(b.at.lane);
  const KernelLink& link_a = body_a.links[a.link];
  const KernelLink& link_b = body_b.links[b.link];
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = link_a.first_box; i < link_a.first_box + link_a.boxes; ++i) {
    for (std::size_t j = link_b.first_box; j < link_b.first_box + link_b.boxes; ++j) {
      double& gap_m = gaps_m[i * body_b.boxes.size() + j];
      if (!(moved_m < gap_m)) {
        place_centres(pack_a.model, a.link, pack_a.work);
        place_centres(pack_b.model, b.link, pack_b.work);
        const double square_m2 =
            square_between(pack_a.work.box_centres[i], a.at.lane, pack_b.work.box_centres[j], b.at.lane, apart_m);
        const double reach_m = body_a.boxes[i].radius_m + body_b.boxes[j].radius_m;
        if (square_m2 <= reach_m * reach_m) {
          gap_m = no_gap_m;
          add_near({i, a.link, a.at}, {j, b.link, b.at}, apart_m, batch, moved_m, &gap_m);
        } else {
          gap_m = moved_m + std::sqrt(square_m2) - reach_m - gap_margin_m;
        }
      }
      least_m = std::min(least_m, gap_m);
    }
  }
  return least_m;
}

/// Contacts between links of one robot that MuJoCo would collide: tests spheres around links, then around boxes, of all robots at
/// once.
TROPHIC_LANES_INLINE void collide_own_links(Batch& batch, std::size_t index, unsigned lanes) {
  const LaneModel& model = batch.packs[index]->model;
  Workspace& work = batch.packs[index]->work;
  for (const LinkPair& pair : model.shape().pairs) {
    const LaneLink& first = model.links[pair.first];
    const LaneLink& second = model.links[pair.second];
    const unsigned near = overlapping(work.links[pair.first].sphere_centre, work.links[pair.second].sphere_centre,
                                      first.sphere_radius_m + second.sphere_radius_m) &
                          lanes;
    if (near == 0) continue;
    place_centres(model, pair.first, work);
    place_centres(model, pair.second, work);
    for (std::size_t i = first.first_box; i < first.first_box + first.boxes; ++i) {
      const Vec3 centre = work.box_centres[i];
      for (std::size_t j = second.first_box; j < second.first_box + second.boxes; ++j) {
        unsigned hits = overlapping(centre, work.box_centres[j], model.boxes[i].radius_m + model.boxes[j].radius_m) & near;
        for (; hits != 0; hits &= hits - 1) {
          const auto lane = static_cast<std::size_t>(std::countr_zero(hits));
          const LaneIndex at = {index, lane};
          add_near({i, pair.first, at}, {j, pair.second, at}, {}, batch);
        }
      }
    }
  }
}

/// Contacts of two neighbours: tests spheres around robots, around links, then boxes, of those that may have come near since
/// they were last apart.
TROPHIC_LANES_INLINE void collide_robots(Batch& batch, std::size_t pair) {
  const auto& [a, b] = batch.neighbours[pair];
  RobotGaps& gaps = batch.gaps[pair];
  const Pack& pack_a = batch.pack(a);
  const Pack& pack_b = batch.pack(b);
  Point3 apart_m;
  for (std::size_t k = 0; k < 3; ++k) apart_m[k] = pack_b.current().position[k][b.lane] - pack_a.current().position[k][a.lane];
  const double square_m2 = apart_m[0] * apart_m[0] + apart_m[1] * apart_m[1] + apart_m[2] * apart_m[2];
  const KernelModel& body_a = pack_a.model.body(a.lane);
  const KernelModel& body_b = pack_b.model.body(b.lane);
  const double robots_m = body_a.bounding_radius_m + body_b.bounding_radius_m;
  if (!(square_m2 <= robots_m * robots_m)) return;
  if (gaps.links.empty()) {
    gaps.links.assign(body_a.links.size() * body_b.links.size(), no_gap_m);
    gaps.boxes.assign(body_a.boxes.size() * body_b.boxes.size(), no_gap_m);
  }
  double* gap_m = gaps.links.data();
  for (std::size_t i = 0; i < body_a.links.size(); ++i) {
    const double moved_a_m = pack_a.work.moved_m[i][a.lane];
    for (std::size_t j = 0; j < body_b.links.size(); ++j, ++gap_m) {
      const double moved_m = moved_a_m + pack_b.work.moved_m[j][b.lane];
      if (moved_m < *gap_m) continue;
      const double between_m2 =
          square_between(pack_a.work.links[i].sphere_centre, a.lane, pack_b.work.links[j].sphere_centre, b.lane, apart_m);
      const double reach_m = body_a.links[i].sphere_radius_m + body_b.links[j].sphere_radius_m;
      *gap_m = between_m2 <= reach_m * reach_m ? collide_links({0, i, a}, {0, j, b}, apart_m, moved_m, gaps.boxes.data(), batch)
                                               : moved_m + std::sqrt(between_m2) - reach_m - gap_margin_m;
    }
  }
}

/// All contacts between links of the robots that are `valid`, of one robot or of two; these robots become `coupled`.
TROPHIC_LANES_INLINE void find_link_contacts(Batch& batch) {
  batch.near_boxes.clear();
  batch.link_contacts.clear();
  for (std::size_t t = 0; t < batch.pack_count; ++t) {
    std::ranges::fill(batch.packs[t]->work.box_placed, std::uint8_t{0});
    collide_own_links(batch, t, batch.packs[t]->valid);
  }
  if (batch.gaps.size() < batch.neighbours.size()) batch.gaps.resize(batch.neighbours.size());
  for (std::size_t t = 0; !batch.neighbours.empty() && t < batch.pack_count; ++t) {
    Pack& pack = *batch.packs[t];
    count_motion(pack.model, pack.current(), pack.work);
  }
  for (std::size_t pair = 0; pair < batch.neighbours.size(); ++pair) {
    const auto& [a, b] = batch.neighbours[pair];
    if (batch.pack(a).is_valid(a.lane) && batch.pack(b).is_valid(b.lane)) collide_robots(batch, pair);
  }
  collide_boxes(batch);
  for (std::size_t t = 0; t < batch.pack_count; ++t) batch.packs[t]->coupled = 0;
  for (const LinkContact& contact : batch.link_contacts) {
    for (const LaneIndex& at : contact.at) batch.pack(at).coupled |= 1u << at.lane;
  }
}

/// Appends the contacts of one link in one lane with the height field: sphere around the link, lowest point of a box, then
/// MuJoCo's test.
TROPHIC_LANES_INLINE void collide_field(const LaneModel& model, std::size_t index, std::size_t lane,
                                        const std::array<double, 3>& origin_m, Workspace& work, FieldCollider& collider) {
  constexpr double gap_m = 1e-7;
  const KernelModel& body = model.body(lane);
  const KernelLink& from = body.links[index];
  const LinkWork& link = work.links[index];
  const double radius_m = from.sphere_radius_m;
  std::array<double, 3> centre_m = origin_m;
  for (std::size_t k = 0; k < 3; ++k) centre_m[k] += link.sphere_centre[static_cast<int>(k)][lane];
  if (!std::isfinite(centre_m[0] + centre_m[1] + centre_m[2])) {
    work.doubtful[lane] = -1;  // MuJoCo reports the error
    return;
  }
  const double highest_m = collider.highest_m(centre_m[0], centre_m[1], radius_m) + gap_m;
  if (centre_m[2] - radius_m > highest_m) return;
  place_centres(model, index, work);
  for (std::size_t b = from.first_box; b < from.first_box + from.boxes; ++b) {
    const PlacedBox& box = placed_box(body, link, b, lane, work);
    double lowest_m = origin_m[2] + box.centre_m[2];
    for (std::size_t k = 0; k < 3; ++k) lowest_m -= std::abs(box.axis[k][2]) * box.half_m[k];
    if (lowest_m > highest_m) continue;
    const auto take = [&](const BoxContact& contact) { work.field_contacts.push_back({lane, index, contact}); };
    if (!collider.collide(box, origin_m, take)) work.doubtful[lane] = -1;
  }
}

/// All contacts of the robots of a pack that are `valid` with the height field; these robots become `coupled`.
TROPHIC_LANES_INLINE void find_field_contacts(Pack& pack, std::optional<FieldCollider>& collider) {
  pack.work.field_contacts.clear();
  if (!pack.model.shape().field) return;
  const LaneArray& at = pack.current().position;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    if (!pack.is_valid(lane)) continue;
    const std::array<double, 3> origin_m = {at[0][lane], at[1][lane], at[2][lane]};
    for (std::size_t link = 0; link < pack.work.links.size(); ++link) {
      collide_field(pack.model, link, lane, origin_m, pack.work, *collider);
    }
  }
  for (const FieldContact& contact : pack.work.field_contacts) pack.coupled |= 1u << contact.lane;
}

/// Robots in the step set of an invalid robot become invalid as well.
TROPHIC_LANES_INLINE void invalidate_step_sets(Batch& batch) {
  unsigned lost = 0;
  for (std::size_t t = 0; t < batch.pack_count; ++t) lost |= batch.packs[t]->lanes & ~batch.packs[t]->valid;
  if (lost == 0 || batch.neighbours.empty()) return;
  for (const LaneIndex& fallen : batch.order) {
    if (batch.pack(fallen).is_valid(fallen.lane)) continue;
    for (const LaneIndex& other : batch.order) {
      if (batch.step_sets.find(other.slot()) == batch.step_sets.find(fallen.slot()))
        batch.pack(other).valid &= ~(1u << other.lane);
    }
  }
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
