// SPDX-License-Identifier: MIT
// Contacts of links with each other or a height field.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <trophic/backend/mujoco/kernel/batch.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

/// One lane of the rotation times a vector.
[[nodiscard]] TROPHIC_LANES_INLINE double rotated(const Mat3& rotation, const double* a, int i, std::size_t lane) {
  return rotation.column[0][i][lane] * a[0] + rotation.column[1][i][lane] * a[1] + rotation.column[2][i][lane] * a[2];
}

/// Centres of all boxes, from the origin of the root.
TROPHIC_LANES_INLINE void place_centres(const LaneModel& model, Workspace& work) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const LaneLink& link = model.links[i];
    const LinkWork& pose = work.links[i];
    for (std::size_t b = link.first_box; b < link.first_box + link.boxes; ++b) {
      work.box_centres[b] = pose.anchor + rotate(pose.rotation, model.boxes[b].centre_m);
    }
  }
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
    if (overlap.separated(least_overlap_m)) continue;
    overlap.meet();
    keep_contacts(overlap);
    add_box_contacts(near, overlap, batch);
  }
}

/// Appends two boxes, written in place because a copy would wait for the previous store.
TROPHIC_LANES_INLINE void add_near(const BoxOf& a, const BoxOf& b, const Point3& apart_m, Batch& batch) {
  NearBoxes& near = batch.near_boxes.emplace_back();
  near.of[0] = a;
  near.of[1] = b;
  near.apart_m = apart_m;
}

/// Boxes of links of two robots whose spheres overlap.
TROPHIC_LANES_INLINE void collide_links(const BoxOf& a, const BoxOf& b, const Point3& apart_m, Batch& batch) {
  const Pack& pack_a = batch.pack(a.at);
  const Pack& pack_b = batch.pack(b.at);
  const KernelLink& link_a = pack_a.model.body(a.at.lane).links[a.link];
  const KernelLink& link_b = pack_b.model.body(b.at.lane).links[b.link];
  for (std::size_t i = link_a.first_box; i < link_a.first_box + link_a.boxes; ++i) {
    for (std::size_t j = link_b.first_box; j < link_b.first_box + link_b.boxes; ++j) {
      double square_m2 = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const int axis = static_cast<int>(k);
        const double between_m =
            pack_b.work.box_centres[j][axis][b.at.lane] + apart_m[k] - pack_a.work.box_centres[i][axis][a.at.lane];
        square_m2 += between_m * between_m;
      }
      const double reach_m = pack_a.model.body(a.at.lane).boxes[i].radius_m + pack_b.model.body(b.at.lane).boxes[j].radius_m;
      if (square_m2 <= reach_m * reach_m) add_near({i, a.link, a.at}, {j, b.link, b.at}, apart_m, batch);
    }
  }
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

/// Contacts of the robots in two lanes: tests spheres around robots, around links, then boxes.
TROPHIC_LANES_INLINE void collide_robots(Batch& batch, const LaneIndex& a, const LaneIndex& b) {
  const Pack& pack_a = batch.pack(a);
  const Pack& pack_b = batch.pack(b);
  Point3 apart_m;
  for (std::size_t k = 0; k < 3; ++k) apart_m[k] = pack_b.current().position[k][b.lane] - pack_a.current().position[k][a.lane];
  const double square_m2 = apart_m[0] * apart_m[0] + apart_m[1] * apart_m[1] + apart_m[2] * apart_m[2];
  const KernelModel& body_a = pack_a.model.body(a.lane);
  const KernelModel& body_b = pack_b.model.body(b.lane);
  const double robots_m = body_a.bounding_radius_m + body_b.bounding_radius_m;
  if (!(square_m2 <= robots_m * robots_m)) return;
  for (std::size_t i = 0; i < pack_a.work.links.size(); ++i) {
    for (std::size_t j = 0; j < pack_b.work.links.size(); ++j) {
      double between_m2 = 0.0;
      for (int k = 0; k < 3; ++k) {
        const double between_m = pack_b.work.links[j].sphere_centre[k][b.lane] + apart_m[static_cast<std::size_t>(k)] -
                                 pack_a.work.links[i].sphere_centre[k][a.lane];
        between_m2 += between_m * between_m;
      }
      const double reach_m = body_a.links[i].sphere_radius_m + body_b.links[j].sphere_radius_m;
      if (between_m2 <= reach_m * reach_m) collide_links({0, i, a}, {0, j, b}, apart_m, batch);
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
  for (const auto& [a, b] : batch.neighbours) {
    if (batch.pack(a).is_valid(a.lane) && batch.pack(b).is_valid(b.lane)) collide_robots(batch, a, b);
  }
  collide_boxes(batch);
  for (std::size_t t = 0; t < batch.pack_count; ++t) batch.packs[t]->coupled = 0;
  for (const LinkContact& contact : batch.link_contacts) {
    for (const LaneIndex& at : contact.at) batch.pack(at).coupled |= 1u << at.lane;
  }
}

/// Appends the contacts of one link in one lane with the height field: sphere around the link, lowest point of a box, then
/// MuJoCo's test.
TROPHIC_LANES_INLINE void collide_field(const KernelModel& model, std::size_t index, std::size_t lane,
                                        const std::array<double, 3>& origin_m, Workspace& work, FieldCollider& collider) {
  constexpr double gap_m = 1e-7;
  const KernelLink& from = model.links[index];
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
  for (std::size_t b = from.first_box; b < from.first_box + from.boxes; ++b) {
    const PlacedBox& box = placed_box(model, link, b, lane, work);
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
      collide_field(pack.model.body(lane), link, lane, origin_m, pack.work, *collider);
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
