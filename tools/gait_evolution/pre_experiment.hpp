// SPDX-License-Identifier: MIT
// The pre-experiment: generations of CPPNs, tried out one robot at a time.
#pragma once

#include <limits>
#include <optional>
#include <tools/gait_evolution/params.hpp>

namespace trophic::gait_evolution {

/// One candidate. Its id is its place in Lineage::individuals.
struct Individual {
  std::vector<std::size_t> parents{};                         ///< ids: none for a founder, else one or two
  std::size_t born = 0;                                       ///< generation
  std::optional<std::size_t> died{};                          ///< generation whose survivor selection it lost; none: it lives
  double fitness = -std::numeric_limits<double>::infinity();  ///< -infinity: its trial diverged
  Genome genome{};

  [[nodiscard]] bool survived(std::size_t generation) const { return born <= generation && (!died || *died > generation); }
  friend bool operator==(const Individual&, const Individual&) = default;
};

/// All individuals that ever lived, between two generations.
struct Lineage {
  std::size_t generations = 0;  ///< done: 0 nothing yet, 1 the founders, ...
  std::vector<Individual> individuals;
  Innovations innovations;
  friend bool operator==(const Lineage&, const Lineage&) = default;

  /// Ids of those alive, ascending.
  [[nodiscard]] std::vector<std::size_t> living() const;

  /// The id of the fittest ever; the oldest among equals. At least one individual.
  [[nodiscard]] std::size_t champion() const;
  /// Whether a candidate has walked: the trials of all others diverged.
  [[nodiscard]] bool has_champion() const;

  /// The fitness of those who survived a generation, highest first.
  [[nodiscard]] std::vector<double> fitness_after(std::size_t generation) const;
};

/// Evolves a robot's gait in advance (Sec. "Targeted Steering"). Founders first; then, each generation: parents are selected
/// among the living and, unless they are couples, shuffled; child i has parents 2i and 2i + 1 counted round that list, is their
/// crossover with crossover_probability, else a copy of the first, then mutates; all children are tried out; the survivors are
/// selected among the living and the children. Every evaluation has a backend with one robot of its own, so that results are the
/// same for any number of threads. Random streams: gait_founder by id, gait_selection by generation, gait_variation by child's
/// id. So all follows from the fitness of the candidates, and that is what a checkpoint holds.
class PreExperiment {
 public:
  /// Throws std::invalid_argument naming field, value and bound.
  PreExperiment(Params params, BackendChoice backend, RobotModel robot);

  /// Makes the generations again whose candidates have this fitness, by id. Throws std::invalid_argument unless they are whole
  /// generations of this pre-experiment.
  void replay(std::span<const double> fitness);

  [[nodiscard]] const Params& params() const { return params_; }
  [[nodiscard]] const BackendChoice& backend() const { return backend_; }
  [[nodiscard]] const RobotModel& robot() const { return robot_; }
  [[nodiscard]] const Lineage& lineage() const { return lineage_; }
  [[nodiscard]] bool done() const { return lineage_.generations > params_.plan.generations; }

  /// Makes, tries out and selects one generation, the founders if there are none yet. `keep_running`, called from several threads
  /// at once, may end it early: false then, and nothing has changed. Throws what a backend throws, but for Diverged, which gives
  /// a candidate the fitness -infinity.
  bool next_generation(
      std::size_t threads = 1, const std::function<bool()>& keep_running = [] { return true; });

  /// The fitness of a genome; -infinity where a trial diverges or it is none. May be called from several threads at once.
  [[nodiscard]] double evaluate(const Genome& genome) const;

 private:
  /// Adds a generation that is not tried out yet.
  void breed(Lineage& lineage) const;
  [[nodiscard]] Individual offspring(Lineage& lineage, std::size_t first, std::size_t second) const;
  /// Selects the survivors of that generation.
  void survive(Lineage& lineage) const;

  Params params_;
  BackendChoice backend_;
  RobotModel robot_;
  Lineage lineage_;
};

}  // namespace trophic::gait_evolution
