// SPDX-License-Identifier: MIT
// An ecology that a program of another language makes from a description and steps from outside. Link trophic::command, which has
// the definitions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <trophic/ecology/stepped_run.hpp>
#include <trophic/experiment/described_run.hpp>
#include <vector>

namespace trophic {

/// An event of an individual, as events.csv has it.
struct Happened {
  std::int64_t tick = 0;
  double time_s = 0.0;
  observe::EventKind kind = observe::EventKind::birth;
  IndividualId id = 0;
  Species species = 0;
  std::optional<IndividualId> other = {};  ///< catch: the victim; death by being caught: the killer; birth: the first parent
  std::optional<Cause> cause = {};         ///< of a death
};

/// A described run that is decided from outside, and the events since its last decisions.
class SteppedEcology {
 public:
  /// Throws as described_run does.
  SteppedEcology(const Json& description, Offer offer);
  ~SteppedEcology();
  SteppedEcology(const SteppedEcology&) = delete;
  SteppedEcology& operator=(const SteppedEcology&) = delete;

  /// Begins the run, or begins it anew with another seed. `folder`: writes its files into this new folder, or with `resume`
  /// continues the run there from its last checkpoint; empty: no files. The manifest names the brain "outside" and has a hash of
  /// all decisions. Throws as the ecology's constructor, io::RunFolder and checkpoint::run_state_in do.
  void reset(std::optional<std::uint64_t> seed = {}, const std::filesystem::path& folder = {}, bool resume = false);
  /// Ends the run here. Its files are those of a run that was stopped; if robots wait for decisions, those of one that was
  /// killed, which resumes from its last checkpoint.
  void close();

  /// As SteppedRun's. All throw std::logic_error before reset.
  [[nodiscard]] bool sense();
  void check(std::span<const double> outputs) const;
  void decide(std::span<const double> outputs);
  [[nodiscard]] std::span<const double> own_outputs();
  [[nodiscard]] const Perceived& perceived() const;
  /// Lets the brains of the genomes decide until the clock is at `until_s` or later and robots wait; from the time of its end on,
  /// to the end of the run. Returns whether robots wait.
  [[nodiscard]] bool run_until(double until_s);

  [[nodiscard]] bool waits() const;
  [[nodiscard]] const Simulation& simulation() const;
  [[nodiscard]] Spaces spaces() const;
  [[nodiscard]] double until_s() const { return until_s_; }
  /// Describes the run as its manifest does.
  [[nodiscard]] observe::RunDescription description() const;
  /// The events since the last call of decide, or of reset.
  [[nodiscard]] const std::vector<Happened>& events() const;

 private:
  struct Run;
  [[nodiscard]] Run& run() const;

  Offer offer_;
  DescribedRun described_;
  double until_s_;
  std::unique_ptr<Run> run_;
};

}  // namespace trophic
