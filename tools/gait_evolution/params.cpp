// SPDX-License-Identifier: MIT
// Definitions of params.hpp.
#include <tools/gait_evolution/params.hpp>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace trophic::gait_evolution {

namespace {

using Indices = std::vector<std::size_t>;

[[nodiscard]] Indices all_of(std::span<const double> fitness) {
  Indices all(fitness.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

[[nodiscard]] Indices round_robin(std::span<const double> fitness, std::size_t count, std::size_t opponents, Rng& rng) {
  Indices wins(fitness.size());
  for (std::size_t self = 0; self < fitness.size(); ++self) {
    Indices others = all_of(fitness);
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(self));
    if (opponents != 0 && opponents < others.size()) {
      rng.shuffle(std::span{others});
      others.resize(opponents);
    }
    wins[self] = static_cast<std::size_t>(
        std::ranges::count_if(others, [&](std::size_t other) { return fitness[self] > fitness[other]; }));
  }
  Indices order = all_of(fitness);
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return wins[a] != wins[b] ? wins[a] > wins[b] : fitness[a] > fitness[b]; });
  order.resize(count);
  return order;
}

/// The place in `candidates` of the fittest of `size` drawn ones.
[[nodiscard]] std::size_t tournament(std::span<const double> fitness, const Indices& candidates, std::size_t size, Rng& rng) {
  std::size_t best = rng.index(candidates.size());
  for (std::size_t drawn = 1; drawn < size; ++drawn) {
    const std::size_t other = rng.index(candidates.size());
    if (fitness[candidates[other]] > fitness[candidates[best]]) best = other;
  }
  return best;
}

/// Winners of tournaments: each once, or in couples of two that differ.
[[nodiscard]] Indices winners(std::span<const double> fitness, std::size_t count, std::size_t size, bool in_couples, Rng& rng) {
  Indices candidates = all_of(fitness);
  Indices selected;
  while (selected.size() < count) {
    const std::size_t best = tournament(fitness, candidates, size, rng);
    if (in_couples && selected.size() % 2 == 1 && best == selected.back()) continue;
    selected.push_back(candidates[best]);
    if (!in_couples) candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return selected;
}

[[nodiscard]] double steered_score_m(const Fitness& fitness, const TryOut& try_out, double start_turn_rad) {
  double next_decision_s = 0.0;
  double target_angle_rad = 0.0;
  const Track track = try_out(
      [&](double time_s, const GroundPose& now) {
        if (time_s >= next_decision_s - 1e-9) {
          target_angle_rad = bearing_of_minus_x_rad(now) < 0.0 ? -fitness.turn_angle_rad : fitness.turn_angle_rad;
          next_decision_s += fitness.decision_s;
        }
        return target_angle_rad;
      },
      start_turn_rad);
  const auto facing = std::ranges::count_if(
      track.poses, [](const GroundPose& pose) { return std::abs(bearing_of_minus_x_rad(pose)) < std::numbers::pi / 2.0; });
  return track.displacement_minus_x_m() * static_cast<double>(facing) / static_cast<double>(track.poses.size());
}

}  // namespace

std::vector<std::size_t> Selection::select(std::span<const double> fitness, std::size_t count, Rng& rng) const {
  const auto refuse = [&](const std::string& what) { throw std::invalid_argument{std::string{enum_name(rule)} + ": " + what}; };
  if (rule == SelectionRule::tournament_couples) {
    if (fitness.size() < 2) refuse(std::to_string(fitness.size()) + " individuals: must be >= 2");
    if (count % 2 != 0) refuse(std::to_string(count) + " parents: must be even");
  } else if (count > fitness.size()) {
    refuse(std::to_string(count) + " distinct individuals wanted: must be <= " + std::to_string(fitness.size()));
  }
  if (rule == SelectionRule::round_robin) return round_robin(fitness, count, opponents, rng);
  return winners(fitness, count, size, rule == SelectionRule::tournament_couples, rng);
}

double Fitness::score(const TryOut& try_out) const {
  if (rule == FitnessRule::steered_displacement) {
    return std::min(steered_score_m(*this, try_out, start_turn_rad), steered_score_m(*this, try_out, -start_turn_rad));
  }
  const auto steered = [](double, const GroundPose& now) { return bearing_of_minus_x_rad(now); };
  return try_out(aim == Aim::none ? steady(0.0) : Pilot{steered}, 0.0).displacement_minus_x_m();
}

Params params_of(Table table, FitnessRule fitness) {
  Params params{.table = table};
  if (table == Table::released) {
    params = {.table = table,
              .robot = "spider_released",
              .plan = {.parents = 40},
              .parent_selection = {.rule = SelectionRule::tournament_couples},
              .survivor_selection = {.rule = SelectionRule::tournament},
              .fitness = {.aim = Aim::minus_x},
              .steering = {.exponent = 4.0},
              .trial = {.duration_s = 20.0, .idle_steps = 1, .facing = Facing::core_x, .cpg_integration = CpgIntegration::rk4},
              .physics = {.timestep_s = 0.0005, .integrator = Integrator::rk4}};
  }
  params.fitness.rule = fitness;
  if (fitness == FitnessRule::steered_displacement) params.trial.facing = Facing::forward_axis;
  return params;
}

ParamRefs param_refs_of(Params& params, BackendChoice& backend) {
  ParamRefs refs = param_refs(params);
  backend.append_param_refs("backend", refs);
  return refs;
}

}  // namespace trophic::gait_evolution
