// SPDX-License-Identifier: MIT
// The search of robots whose links touch each other or a height field, all islands of a batch at once.
#pragma once

#include <cstddef>
#include <trophic/backend/mujoco/kernel/island.hpp>
#include <trophic/backend/mujoco/kernel/search.hpp>

namespace trophic::backend::kernel::TROPHIC_LANES {

/// The largest number of robots in an island; larger ones are left to MuJoCo, whose work grows less with their number.
inline constexpr std::size_t largest_island = 32;

/// Divides the robots that are `coupled` and `valid` into islands.
inline void find_islands(Batch& batch) {
  batch.island_count = 0;
  const std::size_t slots = batch.pack_count * lane_count;
  batch.island_of.assign(slots, slots);
  batch.rank_of.resize(slots);
  for (const LaneIndex& at : batch.order) {
    const Pack& pack = batch.pack(at);
    if ((pack.coupled & pack.valid & (1u << at.lane)) == 0) continue;
    std::size_t& index = batch.island_of[batch.island_sets.find(at.slot())];
    if (index == slots) {
      index = batch.island_count++;
      if (batch.islands.size() < batch.island_count) batch.islands.emplace_back();
      batch.islands[index].lanes.clear();
      batch.islands[index].link_contacts.clear();
    }
    IslandWork& island = batch.islands[index];
    batch.rank_of[at.slot()] = island.lanes.size();
    island.lanes.push_back(at);
  }
  for (const LinkContact& contact : batch.link_contacts) {
    const LaneIndex& at = contact.at[0];
    if (!batch.pack(at).is_valid(at.lane)) continue;
    batch.islands[batch.island_of[batch.island_sets.find(at.slot())]].link_contacts.push_back(&contact);
  }
}

/// Copies the trial points of the lanes of `taken`.
TROPHIC_LANES_INLINE void keep_trial(Workspace& work, const Mask& taken) {
  for (std::size_t i = 0; i < work.links.size(); ++i) {
    IslandLink& kept = work.island_links[i];
    kept.link.angular = select(taken, work.links[i].trial.angular, kept.link.angular);
    kept.link.linear = select(taken, work.links[i].trial.linear, kept.link.linear);
    if (i > 0) kept.hinge = select(taken, work.hinges[i - 1].trial, kept.hinge);
  }
}

/// Restores the stored values as the trial point of all lanes.
TROPHIC_LANES_INLINE void take_kept_trial(Workspace& work) {
  for (std::size_t i = 0; i < work.links.size(); ++i) {
    work.links[i].trial = work.island_links[i].link;
    if (i > 0) work.hinges[i - 1].trial = work.island_links[i].hinge;
  }
}

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

/// Minimises the cost of the robots that are `coupled`, as `trial` of links and hinges; that of the others is unchanged. Robots
/// that do not converge become invalid.
///
/// Takes full Newton steps until the active rows stay the same, starting from the rows of planes that were active last and those
/// of links at the last acceleration. An island whose rows keep changing needs MuJoCo's line search.
TROPHIC_LANES_INLINE void minimise_islands(Batch& batch) {
  constexpr int most_steps = 12;
  find_islands(batch);
  for (std::size_t t = 0; t < batch.pack_count; ++t) {
    Pack& pack = *batch.packs[t];
    pack.unsolved = pack.coupled & pack.valid;
    if (pack.unsolved == 0) continue;
    keep_trial(pack.work, mask_of(all_lanes));
    for (IslandLink& link : pack.work.island_links) link.kept = Mask{};
    first_rows(pack.model, pack.current(), pack.work);
    try_last(pack.model, pack.current(), pack.work);
  }
  std::size_t open = batch.island_count;
  for (std::size_t k = 0; k < batch.island_count; ++k) {
    IslandWork& island = batch.islands[k];
    island.settled = island.lanes.size() > largest_island;
    if (island.settled) {
      --open;
    } else {
      Island{batch, island}.begin();
    }
  }
  for (int step = 0; step < most_steps && open > 0; ++step) {
    for (std::size_t t = 0; t < batch.pack_count; ++t) {
      if (batch.packs[t]->is_stale || step == 0) batch.packs[t]->is_stale = batch.packs[t]->unsolved != 0;
      if (batch.packs[t]->is_stale) eliminate_trees(*batch.packs[t]);
    }
    for (std::size_t k = 0; k < batch.island_count; ++k) {
      if (!batch.islands[k].settled) Island{batch, batch.islands[k]}.solve();
    }
    for (std::size_t t = 0; t < batch.pack_count; ++t) {
      Pack& pack = *batch.packs[t];
      if (pack.unsolved == 0) continue;
      move_eliminated(pack);
      pack.changed = lane_bits(evaluate_trial(pack.model, pack.work)) & pack.unsolved;
      pack.is_stale = pack.changed != 0;
    }
    for (std::size_t k = 0; k < batch.island_count; ++k) {
      IslandWork& island = batch.islands[k];
      if (island.settled) continue;
      const bool changed = Island{batch, island}.evaluate_contacts();
      island.trees_known = true;
      for (const LaneIndex& at : island.lanes) island.trees_known &= (batch.pack(at).changed & (1u << at.lane)) == 0;
      if (!island.trees_known || changed) continue;
      island.settled = true;
      --open;
      for (const LaneIndex& at : island.lanes) batch.pack(at).solved |= 1u << at.lane;
    }
    for (std::size_t t = 0; t < batch.pack_count; ++t) {
      Pack& pack = *batch.packs[t];
      if (pack.solved == 0) continue;
      remember_rows(pack.work, pack.solved);
      keep_trial(pack.work, mask_of(pack.solved));
      pack.unsolved &= ~pack.solved;
      pack.solved = 0;
    }
  }
  for (std::size_t t = 0; t < batch.pack_count; ++t) {
    Pack& pack = *batch.packs[t];
    if ((pack.coupled & pack.valid) != 0) take_kept_trial(pack.work);
    pack.valid &= ~pack.unsolved;
  }
}

}  // namespace trophic::backend::kernel::TROPHIC_LANES
