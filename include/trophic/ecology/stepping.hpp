// SPDX-License-Identifier: MIT
// The steps of a run whose decisions come from outside the ecology.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <trophic/observe/audience.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/population/individual.hpp>
#include <vector>

namespace trophic {

/// What robots that wait for a decision perceive. Valid until the next step.
struct Perceived {
  std::vector<BodyIndex> bodies;  ///< ascending
  std::size_t inputs_each = 0;    ///< numbers in a row of `inputs`: those of the species with the most
  std::size_t outputs_each = 0;   ///< numbers in a row of outputs, those of the table's acts
  std::vector<double> inputs;     ///< a row for each of `bodies`; 0 beyond the inputs of its species
};

/// One number that robots perceive, or that is decided for them.
struct Channel {
  std::string name;
  std::string unit = {};
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};

/// The meaning of the rows of Perceived::inputs and of outputs.
struct Spaces {
  std::vector<std::vector<Channel>> inputs = {};  ///< of each species
  std::vector<Channel> outputs = {};
};

/// The steps of a run, which trophic/ecology/stepped_run.hpp takes in their order.
class Stepping {
 public:
  Stepping() = default;
  Stepping(const Stepping&) = delete;
  Stepping& operator=(const Stepping&) = delete;
  virtual ~Stepping() = default;

  /// The description of a run whose decisions come from outside: its rule Brain is "outside".
  [[nodiscard]] virtual observe::RunDescription describe_outside(double until_s) const = 0;

  [[nodiscard]] virtual Spaces spaces() const = 0;

  /// Throws std::logic_error if an earlier run stopped between sensing and deciding.
  virtual void begin(double until_s, observe::Audience& audience) = 0;
  /// Runs until robots wait for decisions. Returns false at the end of the run, of which observers are then notified.
  [[nodiscard]] virtual bool sense(double until_s, observe::Audience& audience) = 0;
  [[nodiscard]] virtual const Perceived& perceived() const = 0;
  /// The outputs of the brains of their genomes, row by row. Each brain is asked once, as a State may change.
  [[nodiscard]] virtual std::span<const double> own_outputs() = 0;
  /// Throws std::invalid_argument for outputs that are not a decision of each of `perceived`, and changes nothing then.
  virtual void check(std::span<const double> outputs) const = 0;
  /// Ends the tick unless other robots of it still have to decide.
  virtual void decide(std::span<const double> outputs, observe::Audience& audience) = 0;
  /// Whether robots wait for decisions.
  [[nodiscard]] virtual bool is_in_tick() const = 0;
  /// Ends the run between two ticks. Observers are notified.
  virtual void stop(observe::Audience& audience) = 0;
};

}  // namespace trophic
