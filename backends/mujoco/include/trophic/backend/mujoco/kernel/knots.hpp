// SPDX-License-Identifier: MIT
// The search of robots whose links touch each other or a height field, all knots of a crew side by side.
#pragma once

#include <cstddef>
#include <trophic/backend/mujoco/kernel/knot.hpp>
#include <trophic/backend/mujoco/kernel/search.hpp>

namespace trophic::backend::kernel {

/// Robots in one knot; more of them are MuJoCo's, whose work grows less with their number.
inline constexpr std::size_t largest_knot = 32;

/// Ties the robots that are `coupled` and `going` into knots.
inline void tie_knots(Crew& crew) {
  crew.knot_count = 0;
  const std::size_t slots = crew.team_count * lane_count;
  crew.knot_of.assign(slots, slots);
  crew.rank_of.resize(slots);
  for (const Seat& seat : crew.order) {
    const Team& team = crew.team(seat);
    if ((team.coupled & team.going & (1u << seat.lane)) == 0) continue;
    std::size_t& index = crew.knot_of[crew.knot_ties.first(seat.slot())];
    if (index == slots) {
      index = crew.knot_count++;
      if (crew.knots.size() < crew.knot_count) crew.knots.emplace_back();
      crew.knots[index].seats.clear();
      crew.knots[index].link_contacts.clear();
    }
    KnotWork& knot = crew.knots[index];
    crew.rank_of[seat.slot()] = knot.seats.size();
    knot.seats.push_back(seat);
  }
  for (const LinkContact& contact : crew.link_contacts) {
    const Seat& seat = contact.seat[0];
    if (!crew.team(seat).is_going(seat.lane)) continue;
    crew.knots[crew.knot_of[crew.knot_ties.first(seat.slot())]].link_contacts.push_back(&contact);
  }
}

/// Copies the trial points of the lanes of `taken`.
TROPHIC_LANES_INLINE void keep_trial(Workspace& work, const Mask& taken) {
  for (std::size_t i = 0; i < work.links.size(); ++i) {
    KnotLink& kept = work.knot_links[i];
    kept.link.angular = select(taken, work.links[i].trial.angular, kept.link.angular);
    kept.link.linear = select(taken, work.links[i].trial.linear, kept.link.linear);
    if (i > 0) kept.hinge = select(taken, work.hinges[i - 1].trial, kept.hinge);
  }
}

/// Makes what was kept the trial point of all lanes.
TROPHIC_LANES_INLINE void take_kept_trial(Workspace& work) {
  for (std::size_t i = 0; i < work.links.size(); ++i) {
    work.links[i].trial = work.knot_links[i].link;
    if (i > 0) work.hinges[i - 1].trial = work.knot_links[i].hinge;
  }
}

/// The robots of a knot, as lanes of team `index`.
[[nodiscard]] inline unsigned lanes_in(const KnotWork& knot, std::size_t index) {
  unsigned lanes = 0;
  for (const Seat& seat : knot.seats) lanes |= seat.team == index ? 1u << seat.lane : 0u;
  return lanes;
}

/// Minimises the cost of the robots that are `coupled`, as `trial` of links and hinges; that of the others stays. Robots that do
/// not settle stop `going`.
///
/// Full Newton steps until the pushing rows stay the same, at first with those of planes that pushed last and those of links at
/// the warm start. A knot whose rows keep changing needs MuJoCo's line search.
TROPHIC_LANES_INLINE void minimise_knots(Crew& crew) {
  constexpr int most_steps = 12;
  tie_knots(crew);
  for (std::size_t t = 0; t < crew.team_count; ++t) {
    Team& team = *crew.teams[t];
    team.unsolved = team.coupled & team.going;
    if (team.unsolved == 0) continue;
    keep_trial(team.work, mask_of(all_lanes));
    for (KnotLink& link : team.work.knot_links) link.kept = Mask{};
    first_rows(team.model, team.current(), team.work);
  }
  std::size_t open = crew.knot_count;
  for (std::size_t k = 0; k < crew.knot_count; ++k) {
    KnotWork& knot = crew.knots[k];
    knot.settled = knot.seats.size() > largest_knot;
    if (knot.settled) {
      --open;
    } else {
      Knot{crew, knot}.begin();
    }
  }
  for (int step = 0; step < most_steps && open > 0; ++step) {
    for (std::size_t t = 0; t < crew.team_count; ++t) {
      if (crew.teams[t]->is_stale || step == 0) crew.teams[t]->is_stale = crew.teams[t]->unsolved != 0;
      if (crew.teams[t]->is_stale) eliminate_trees(*crew.teams[t]);
    }
    for (std::size_t k = 0; k < crew.knot_count; ++k) {
      if (!crew.knots[k].settled) Knot{crew, crew.knots[k]}.solve();
    }
    for (std::size_t t = 0; t < crew.team_count; ++t) {
      Team& team = *crew.teams[t];
      if (team.unsolved == 0) continue;
      move_eliminated(team);
      team.changed = lane_bits(evaluate_trial(team.model, team.work)) & team.unsolved;
      team.is_stale = team.changed != 0;
    }
    for (std::size_t k = 0; k < crew.knot_count; ++k) {
      KnotWork& knot = crew.knots[k];
      if (knot.settled) continue;
      const bool changed = Knot{crew, knot}.evaluate_contacts();
      knot.trees_known = true;
      for (const Seat& seat : knot.seats) knot.trees_known &= (crew.team(seat).changed & (1u << seat.lane)) == 0;
      if (!knot.trees_known || changed) continue;
      knot.settled = true;
      --open;
      for (const Seat& seat : knot.seats) crew.team(seat).solved |= 1u << seat.lane;
    }
    for (std::size_t t = 0; t < crew.team_count; ++t) {
      Team& team = *crew.teams[t];
      if (team.solved == 0) continue;
      remember_rows(team.work, team.solved);
      keep_trial(team.work, mask_of(team.solved));
      team.unsolved &= ~team.solved;
      team.solved = 0;
    }
  }
  for (std::size_t t = 0; t < crew.team_count; ++t) {
    Team& team = *crew.teams[t];
    if ((team.coupled & team.going) != 0) take_kept_trial(team.work);
    team.going &= ~team.unsolved;
  }
}

}  // namespace trophic::backend::kernel
