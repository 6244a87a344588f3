// SPDX-License-Identifier: MIT
// A run whose decisions come from outside the ecology.
#pragma once

#include <exception>
#include <memory>
#include <stdexcept>
#include <trophic/ecology/simulation.hpp>
#include <trophic/ecology/stepping.hpp>

namespace trophic {

/// A run that stops between sensing and deciding, so that any program can decide for the robots:
///
///   SteppedRun run{ecology, 6000.0};
///   while (run.sense()) run.decide(my_outputs_for(run.perceived()));
///
/// `decide` takes the outputs that the table's brain would give: those of its acts, in their order, for each robot in
/// `perceived().bodies`. In a table whose brain has no output neurons they are the target angle, rad, and the tag. Births,
/// deaths, genomes and mutation are those of the table. Equal outputs give equal bytes; the outputs of the table's own brains,
/// `own_outputs()`, give the bytes of `run_until`.
///
/// Robots that decide in turn (EcologyParams::decision_order) wait one at a time: `sense` then returns several times in a tick.
/// After `decide`, if none waits any more, the ecology is between two ticks: it can be saved, and the run can be stopped. A run
/// that is destroyed before its end leaves its observers as a program that was killed.
class SteppedRun {
 public:
  /// `until_s` and observers as of Simulation::run_until. `ecology` and `observers` outlive the run. Throws std::logic_error for
  /// a simulation that cannot be stepped.
  template <class... Observers>
  SteppedRun(Simulation& ecology, double until_s, Observers&... observers)
      : SteppedRun{ecology, until_s, std::make_unique<observe::AudienceOf<Observers...>>(observers...)} {}
  /// The same with observers that were gathered before.
  SteppedRun(Simulation& ecology, double until_s, std::unique_ptr<observe::Audience> audience)
      : steps_{ecology.stepping()}, until_s_{until_s}, audience_{std::move(audience)} {
    steps_.begin(until_s_, *audience_);
  }

  /// Runs until robots have perceived and wait for decisions. Returns false at the end of the run. Throws std::logic_error if
  /// they wait already.
  [[nodiscard]] bool sense() {
    if (waits_) throw std::logic_error{"sense: the robots wait for decide(outputs)"};
    if (!has_ended_) attempt([&] { waits_ = steps_.sense(until_s_, *audience_); });
    has_ended_ = !waits_;
    return waits_;
  }
  /// Whether robots wait for decisions.
  [[nodiscard]] bool waits() const { return waits_; }
  /// The robots that wait, and their inputs.
  [[nodiscard]] const Perceived& perceived() const { return steps_.perceived(); }
  /// What the brains of their genomes decide: `perceived().outputs_each` numbers for each robot.
  [[nodiscard]] std::span<const double> own_outputs() {
    check_waits("own_outputs");
    return steps_.own_outputs();
  }

  /// Throws as `decide` does, and changes nothing.
  void check(std::span<const double> outputs) const {
    check_waits("check");
    steps_.check(outputs);
  }
  /// Lets the robots that wait do what these outputs stand for, `perceived().outputs_each` numbers for each. Throws
  /// std::logic_error if none waits, and std::invalid_argument for other numbers than these or one that is not a decision: the
  /// robots then still wait.
  void decide(std::span<const double> outputs) {
    check_waits("decide");
    steps_.check(outputs);
    waits_ = false;
    attempt([&] { steps_.decide(outputs, *audience_); });
  }

  /// Ends the run before its time, as an observer that stops it does. Throws std::logic_error if robots wait for decisions.
  void stop() {
    if (has_ended_) return;
    if (steps_.is_in_tick()) throw std::logic_error{"stop: the robots wait for decide(outputs)"};
    attempt([&] { steps_.stop(*audience_); });
    has_ended_ = true;
  }

 private:
  void check_waits(const char* what) const {
    if (!waits_) throw std::logic_error{std::string{what} + ": no robot waits for a decision; call sense() first"};
  }
  /// Notifies observers of a failure, as Simulation::run_until does.
  void attempt(const auto& step) {
    try {
      step();
    } catch (const std::exception& error) {
      has_ended_ = true;
      audience_->failure(error.what());
      throw;
    }
  }

  Stepping& steps_;
  double until_s_;
  std::unique_ptr<observe::Audience> audience_;
  bool waits_ = false;
  bool has_ended_ = false;
};

}  // namespace trophic
