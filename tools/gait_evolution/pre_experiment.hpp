// SPDX-License-Identifier: MIT
// The pre-experiment: generations of CPPNs, tried out one robot at a time.
#pragma once

#include <algorithm>
#include <atomic>
#include <tools/gait_evolution/cppn_gait.hpp>
#include <tools/gait_evolution/lineage.hpp>
#include <tools/gait_evolution/tables.hpp>
#include <tools/gait_evolution/trial.hpp>
#include <tools/gait_evolution/variation.hpp>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/habitat/validate_robot.hpp>
#include <trophic/rules/table.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/thread_pool.hpp>

namespace trophic::gait_evolution {

/// Evolves a robot's gait in advance (Sec. "Targeted Steering"). Founders first; then, each generation: parents are selected
/// among the living and, unless they are couples, shuffled; child i has parents 2i and 2i + 1 counted round that list, is their
/// crossover with crossover_probability, else a copy of the first, then mutates; all children are tried out; the survivors are
/// selected among the living and the children. Every evaluation has a backend with one robot of its own, so that results are the
/// same for any number of threads. Random streams: gait_founder by id, gait_selection by generation, gait_variation by child's
/// id.
template <class Table>
class PreExperiment {
 public:
  /// Throws std::invalid_argument naming field, value and bound.
  PreExperiment(Params<Table> params, BackendChoice backend, RobotModel robot)
      : params_{std::move(params)}, backend_{std::move(backend)}, robot_{std::move(robot)} {
    trophic::validate(params_, "");
    backend_.validate("backend");
    trophic::validate(robot_);
    if (robot_.hinges.empty()) throw std::invalid_argument{"robot " + robot_.name + " has no hinges: no gait can move it"};
    const Plan& plan = params_.plan;
    if (params_.trial.control_hz * params_.physics.timestep_s > 1.0) {
      throw std::invalid_argument{"physics.timestep_s = " + number_text(params_.physics.timestep_s) +
                                  ": must be <= " + number_text(1.0 / params_.trial.control_hz) + ", the control period"};
    }
    if (params_.trial.steps() <= params_.trial.idle_steps) {
      throw std::invalid_argument{"trial.duration_s = " + number_text(params_.trial.duration_s) + ": must have more than " +
                                  std::to_string(params_.trial.idle_steps) + " control steps, trial.idle_steps"};
    }
    Rng rng{params_.seed, Stream::gait_selection};
    const auto parents = make_policy<typename Table::ParentSelection>(params_.parent_selection);
    static_cast<void>(parents.select(std::vector<double>(plan.population), plan.parents, rng));
  }

  /// Resumes from a stored state of the same pre-experiment.
  void restore(Lineage lineage) { lineage_ = std::move(lineage); }

  [[nodiscard]] const Params<Table>& params() const { return params_; }
  [[nodiscard]] const BackendChoice& backend() const { return backend_; }
  /// All parameters, those of the backend last.
  [[nodiscard]] NamedParams named_params() const { return named_params_of(params_, backend_); }
  [[nodiscard]] const RobotModel& robot() const { return robot_; }
  [[nodiscard]] const Lineage& lineage() const { return lineage_; }
  [[nodiscard]] bool done() const { return lineage_.generations > params_.plan.generations; }

  /// Makes, tries out and selects one generation, the founders if there are none yet. `keep_running`, called from several threads
  /// at once, may end it early: false then, and nothing has changed. Throws what a backend throws, but for Diverged, which gives
  /// a candidate the fitness -infinity.
  bool next_generation(
      std::size_t threads = 1, const std::function<bool()>& keep_running = [] { return true; }) {
    Lineage next = lineage_;
    const std::size_t first = next.individuals.size();
    if (next.generations == 0) {
      found(next);
    } else {
      breed(next);
    }
    const std::span newborn = std::span{next.individuals}.subspan(first);
    std::atomic<bool> stopped = false;
    ThreadPool{std::clamp<std::size_t>(threads, 1, newborn.size())}.run(newborn.size(), [&](std::size_t i, std::size_t) {
      if (!keep_running()) stopped = true;
      if (!stopped) newborn[i].fitness = evaluate(newborn[i].genome);
    });
    if (stopped) return false;
    if (next.generations > 0) survive(next);
    ++next.generations;
    lineage_ = std::move(next);
    return true;
  }

  /// The fitness of a genome; -infinity where a trial diverges or it is none. May be called from several threads at once.
  [[nodiscard]] double evaluate(const Genome& genome) const {
    const Gait gait = cppn_gait(genome, robot_);
    const auto steering = make_policy<typename Table::Steering>(params_.steering);
    const TryOut try_gait = [&](const Pilot& pilot, double start_turn_rad) {
      return try_out(robot_, gait, steering, params_.trial, params_.physics, backend_, pilot, start_turn_rad);
    };
    try {
      const double fitness = make_policy<typename Table::Fitness>(params_.fitness).fitness(try_gait);
      return std::isfinite(fitness) ? fitness : -std::numeric_limits<double>::infinity();
    } catch (const Diverged&) {
      return -std::numeric_limits<double>::infinity();
    }
  }

 private:
  void found(Lineage& lineage) const {
    for (std::size_t id = 0; id < params_.plan.population; ++id) {
      Rng rng{params_.seed, Stream::gait_founder, id};
      lineage.individuals.push_back({.genome = random_genome(params_.variation, lineage.innovations, rng)});
    }
  }

  void breed(Lineage& lineage) const {
    const std::vector<std::size_t> living = lineage.living();
    Rng rng{params_.seed, Stream::gait_selection, 0, lineage.generations};
    std::vector<std::size_t> parents = make_policy<typename Table::ParentSelection>(params_.parent_selection)
                                           .select(fitness_of(lineage, living), params_.plan.parents, rng);
    if constexpr (!Couples<typename Table::ParentSelection>) rng.shuffle(std::span{parents});
    for (std::size_t child = 0; child < params_.plan.children; ++child) {
      const std::size_t first = living[parents[(2 * child) % parents.size()]];
      const std::size_t second = living[parents[(2 * child + 1) % parents.size()]];
      lineage.individuals.push_back(offspring(lineage, first, second));
    }
  }

  [[nodiscard]] Individual offspring(Lineage& lineage, std::size_t first, std::size_t second) const {
    const Variation& variation = params_.variation;
    Rng rng{params_.seed, Stream::gait_variation, lineage.individuals.size()};
    const Individual& one = lineage.individuals[first];
    const Individual& two = lineage.individuals[second];
    Individual child{.parents = {first}, .born = lineage.generations, .genome = one.genome};
    if (first != second && rng.chance(variation.crossover_probability)) {
      child.parents.push_back(second);
      const bool second_is_fitter = two.fitness > one.fitness;
      child.genome = second_is_fitter ? crossover(two.genome, one.genome, rng) : crossover(one.genome, two.genome, rng);
    }
    mutate(child.genome, variation, lineage.innovations, rng);
    return child;
  }

  void survive(Lineage& lineage) const {
    const std::vector<std::size_t> living = lineage.living();
    Rng rng{params_.seed, Stream::gait_selection, 1, lineage.generations};
    const auto survivors = make_policy<typename Table::SurvivorSelection>(params_.survivor_selection)
                               .select(fitness_of(lineage, living), std::min(params_.plan.population, living.size()), rng);
    std::vector<bool> lives(living.size());
    for (const std::size_t survivor : survivors) lives[survivor] = true;
    for (std::size_t i = 0; i < living.size(); ++i) {
      if (!lives[i]) lineage.individuals[living[i]].died = lineage.generations;
    }
  }

  [[nodiscard]] static std::vector<double> fitness_of(const Lineage& lineage, std::span<const std::size_t> ids) {
    std::vector<double> fitness;
    for (const std::size_t id : ids) fitness.push_back(lineage.individuals[id].fitness);
    return fitness;
  }

  Params<Table> params_;
  BackendChoice backend_;
  RobotModel robot_;
  Lineage lineage_;
};

}  // namespace trophic::gait_evolution
