// SPDX-License-Identifier: MIT
// Definitions of pre_experiment.hpp.
#include <tools/gait_evolution/pre_experiment.hpp>

#include <algorithm>
#include <atomic>
#include <functional>
#include <stdexcept>
#include <trophic/habitat/validate_robot.hpp>
#include <trophic/support/thread_pool.hpp>

namespace trophic::gait_evolution {

namespace {

[[nodiscard]] std::vector<double> fitness_of(const Lineage& lineage, std::span<const std::size_t> ids) {
  std::vector<double> fitness;
  for (const std::size_t id : ids) fitness.push_back(lineage.individuals[id].fitness);
  return fitness;
}

}  // namespace

std::vector<std::size_t> Lineage::living() const {
  std::vector<std::size_t> ids;
  for (std::size_t id = 0; id < individuals.size(); ++id) {
    if (!individuals[id].died) ids.push_back(id);
  }
  return ids;
}

std::size_t Lineage::champion() const {
  return static_cast<std::size_t>(std::ranges::max_element(individuals, {}, &Individual::fitness) - individuals.begin());
}

bool Lineage::has_champion() const {
  return !individuals.empty() && std::isfinite(individuals[champion()].fitness);
}

std::vector<double> Lineage::fitness_after(std::size_t generation) const {
  std::vector<double> fitness;
  for (const Individual& individual : individuals) {
    if (individual.survived(generation)) fitness.push_back(individual.fitness);
  }
  std::ranges::sort(fitness, std::greater{});
  return fitness;
}

PreExperiment::PreExperiment(Params params, BackendChoice backend, RobotModel robot)
    : params_{std::move(params)}, backend_{std::move(backend)}, robot_{std::move(robot)} {
  trophic::validate(params_, "");
  backend_.validate("backend");
  trophic::validate(robot_);
  if (robot_.hinges.empty()) throw std::invalid_argument{"robot " + robot_.name + " has no hinges: no gait can move it"};
  if (params_.trial.control_hz * params_.physics.timestep_s > 1.0) {
    throw std::invalid_argument{"physics.timestep_s = " + number_text(params_.physics.timestep_s) +
                                ": must be <= " + number_text(1.0 / params_.trial.control_hz) + ", the control period"};
  }
  if (params_.trial.steps() <= params_.trial.idle_steps) {
    throw std::invalid_argument{"trial.duration_s = " + number_text(params_.trial.duration_s) + ": must have more than " +
                                std::to_string(params_.trial.idle_steps) + " control steps, trial.idle_steps"};
  }
  Rng rng{params_.seed, Stream::gait_selection};
  const std::vector<double> equals(params_.plan.population);
  static_cast<void>(params_.parent_selection.select(equals, params_.plan.parents, rng));
}

void PreExperiment::replay(std::span<const double> fitness) {
  Lineage lineage;
  while (lineage.individuals.size() < fitness.size() && lineage.generations <= params_.plan.generations) {
    const std::size_t first = lineage.individuals.size();
    breed(lineage);
    for (std::size_t id = first; id < std::min(lineage.individuals.size(), fitness.size()); ++id) {
      lineage.individuals[id].fitness = fitness[id];
    }
    survive(lineage);
  }
  if (lineage.individuals.size() != fitness.size()) {
    throw std::invalid_argument{std::to_string(fitness.size()) + " candidates: must be those of whole generations, " +
                                number_text(params_.plan.population) + " founders and " + number_text(params_.plan.children) +
                                " in each of up to " + number_text(params_.plan.generations)};
  }
  lineage_ = std::move(lineage);
}

bool PreExperiment::next_generation(std::size_t threads, const std::function<bool()>& keep_running) {
  Lineage next = lineage_;
  breed(next);
  const std::span newborn = std::span{next.individuals}.subspan(lineage_.individuals.size());
  std::atomic<bool> stopped = false;
  ThreadPool{std::clamp<std::size_t>(threads, 1, newborn.size())}.run(newborn.size(), [&](std::size_t i, std::size_t) {
    if (!keep_running()) stopped = true;
    if (!stopped) newborn[i].fitness = evaluate(newborn[i].genome);
  });
  if (stopped) return false;
  survive(next);
  lineage_ = std::move(next);
  return true;
}

double PreExperiment::evaluate(const Genome& genome) const {
  const Gait gait = genome.network().gait_of(robot_);
  const control::steering::TargetedSteering steering{params_.steering};
  try {
    const double fitness = params_.fitness.score([&](const Pilot& pilot, double start_turn_rad) {
      return try_out(robot_, gait, steering, params_.trial, params_.physics, backend_, pilot, start_turn_rad);
    });
    return std::isfinite(fitness) ? fitness : -std::numeric_limits<double>::infinity();
  } catch (const Diverged&) {
    return -std::numeric_limits<double>::infinity();
  }
}

void PreExperiment::breed(Lineage& lineage) const {
  if (lineage.generations == 0) {
    for (std::size_t id = 0; id < params_.plan.population; ++id) {
      Rng rng{params_.seed, Stream::gait_founder, id};
      lineage.individuals.push_back({.genome = random_genome(params_.variation, lineage.innovations, rng)});
    }
    return;
  }
  const std::vector<std::size_t> living = lineage.living();
  Rng rng{params_.seed, Stream::gait_selection, 0, lineage.generations};
  auto parents = params_.parent_selection.select(fitness_of(lineage, living), params_.plan.parents, rng);
  if (params_.parent_selection.rule != SelectionRule::tournament_couples) rng.shuffle(std::span{parents});
  for (std::size_t child = 0; child < params_.plan.children; ++child) {
    const std::size_t first = living[parents[(2 * child) % parents.size()]];
    const std::size_t second = living[parents[(2 * child + 1) % parents.size()]];
    lineage.individuals.push_back(offspring(lineage, first, second));
  }
}

Individual PreExperiment::offspring(Lineage& lineage, std::size_t first, std::size_t second) const {
  Rng rng{params_.seed, Stream::gait_variation, lineage.individuals.size()};
  const Individual& one = lineage.individuals[first];
  const Individual& two = lineage.individuals[second];
  Individual child{.parents = {first}, .born = lineage.generations, .genome = one.genome};
  if (first != second && rng.chance(params_.variation.crossover_probability)) {
    child.parents.push_back(second);
    const bool second_is_fitter = two.fitness > one.fitness;
    child.genome = second_is_fitter ? crossover(two.genome, one.genome, rng) : crossover(one.genome, two.genome, rng);
  }
  mutate(child.genome, params_.variation, lineage.innovations, rng);
  return child;
}

void PreExperiment::survive(Lineage& lineage) const {
  const std::size_t generation = lineage.generations++;
  if (generation == 0) return;
  const std::vector<std::size_t> living = lineage.living();
  Rng rng{params_.seed, Stream::gait_selection, 1, generation};
  const auto survivors =
      params_.survivor_selection.select(fitness_of(lineage, living), std::min(params_.plan.population, living.size()), rng);
  for (std::size_t i = 0; i < living.size(); ++i) {
    if (std::ranges::find(survivors, i) == survivors.end()) lineage.individuals[living[i]].died = generation;
  }
}

}  // namespace trophic::gait_evolution
