// SPDX-License-Identifier: MIT
// An ecology whose parameters change while it runs.
#pragma once

#include <map>
#include <tools/changes/change.hpp>
#include <trophic/ecology/simulation.hpp>
#include <trophic/io/own_table.hpp>
#include <trophic/io/state_columns.hpp>

namespace trophic::changes {

/// Decides about changes during a run, such as a person at a live page.
class Conductor {
 public:
  Conductor() = default;
  Conductor(const Conductor&) = delete;
  Conductor& operator=(const Conductor&) = delete;
  virtual ~Conductor() = default;

  /// Returns the changes to make now, each tried alone; their times are ignored. Called between two ticks, before the bodies
  /// move, and again after changes. May wait.
  [[nodiscard]] virtual std::vector<Change> due(double time_s) = 0;
  /// Whether the run ends at the moment of the last call of `due`.
  [[nodiscard]] virtual bool ends() const = 0;
  virtual void made(const observe::ParameterChange& row) = 0;
  /// The experiment does not accept a change; the run continues without it.
  virtual void refused(const Change& change, const std::string& why) = 0;
};

/// Makes the ecology of an experiment in which these changes, one of each number, were made before its start. Throws
/// std::invalid_argument for a number that is unknown or out of its bounds.
using MakeChanged = std::function<std::unique_ptr<Simulation>(const std::vector<Change>& made)>;

/// Runs the ecology of an experiment and replaces it, between two ticks, by one with other rule parameters in the same state. So
/// a run with changes is the same to the byte whether they are scheduled or made by a conductor. Its description is that of the
/// first parameters, with the changes that were made. A checkpoint contains the changes that were made and those that are still
/// to come.
class ChangingSimulation final : public Simulation {
 public:
  /// `schedule` is in the order of time. Throws std::invalid_argument for a change that the experiment does not accept, as it
  /// does for parameters that no run can change: all but those of rules. `conductor` may be null.
  ChangingSimulation(MakeChanged make, std::vector<Change> schedule, Conductor* conductor = nullptr);
  ~ChangingSimulation() override;

  void persist(Archive& archive) override;
  [[nodiscard]] double time_s() const override { return current_->time_s(); }
  [[nodiscard]] std::int64_t tick() const override { return current_->tick(); }
  [[nodiscard]] View view() const override { return current_->view(); }
  [[nodiscard]] const AnyBackend& backend() const override { return current_->backend(); }
  [[nodiscard]] observe::RunDescription describe(double until_s) const override;
  [[nodiscard]] io::StateColumns state_columns() const override;

  /// Makes changes.csv in the folder of this ecology's run.
  [[nodiscard]] io::MakeOwnTable table() const;

 private:
  class Relay;
  struct Journal;
  using Values = std::map<std::string, std::string>;  ///< by their numbers

  void run(double until_s, observe::Audience& audience) override;
  [[nodiscard]] std::vector<Change> scheduled_until(double time_s);
  [[nodiscard]] std::unique_ptr<Simulation> changed(Values values, std::span<const Change> more) const;
  void make(std::span<const Change> changes, observe::Audience& audience, double until_s);
  [[nodiscard]] bool are_scheduled(const std::vector<observe::ParameterChange>& made, const std::vector<Change>& to_come) const;

  MakeChanged make_;
  Conductor* conductor_;
  std::vector<Change> schedule_;  ///< changes still to come
  std::vector<observe::ParameterChange> made_;
  Values values_;  ///< after the changes that were made
  std::shared_ptr<Journal> journal_;
  std::unique_ptr<Simulation> current_;
  observe::RunDescription first_;  ///< of the first parameters
};

/// Adds changes.csv to the tables of each ecology whose parameters may change.
[[nodiscard]] io::OwnTablesOf with_changes(const io::OwnTables& own_tables);

}  // namespace trophic::changes
