// SPDX-License-Identifier: MIT
// An ecology whose rules and backend are type-erased.
#pragma once

#include <stdexcept>
#include <trophic/backend/any_backend.hpp>
#include <trophic/observe/audience.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/population/view.hpp>

namespace trophic::io {
struct StateColumns;
}

namespace trophic {

class Stepping;

/// Type-erased interface for running, observing and checkpointing an ecology.
class Simulation {
 public:
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;
  virtual ~Simulation() = default;

  /// Runs until the clock reaches `until_s` (rounded up to whole ticks) or an observer stops the run. May be called again to
  /// continue. An observer that cancels a tick leaves everything as it was before that tick. If an exception is thrown, the
  /// observers are notified and it is rethrown.
  template <class... Observers>
  void run_until(double until_s, Observers&&... observers) {
    observe::AudienceOf<std::remove_reference_t<Observers>...> audience{observers...};
    run(until_s, audience);
  }
  /// The same with observers that were collected before.
  void run_before(observe::Audience& audience, double until_s) { run(until_s, audience); }

  /// Writes the whole state of the run to an archive, or reads it: an ecology with the same parameters then continues from that
  /// moment with bitwise equal results. Only between ticks. Reading throws std::invalid_argument for bytes that are not such a
  /// state, and leaves the ecology in an unspecified state.
  virtual void persist(Archive& archive) = 0;

  [[nodiscard]] virtual double time_s() const = 0;
  [[nodiscard]] virtual std::int64_t tick() const = 0;
  /// The current world as rules see it. Valid during the ecology's lifetime while it does not run.
  [[nodiscard]] virtual View view() const = 0;
  /// The bodies. Valid during the ecology's lifetime.
  [[nodiscard]] virtual const AnyBackend& backend() const = 0;
  /// Everything that determines this run, for observers.
  [[nodiscard]] virtual observe::RunDescription describe(double until_s) const = 0;
  /// The states of rules with a State, for states.csv (trophic/io/state_log.hpp). Refers to the ecology.
  [[nodiscard]] virtual io::StateColumns state_columns() const = 0;
  /// For runs whose decisions come from outside (trophic/ecology/stepped_run.hpp). Throws std::logic_error if there can be none.
  [[nodiscard]] virtual Stepping& stepping() { throw std::logic_error{"this simulation cannot be stepped from outside"}; }

 protected:
  Simulation() = default;

 private:
  virtual void run(double until_s, observe::Audience& audience) = 0;
};

/// Makes an experiment's ecology for a given seed.
using MakeSimulation = std::function<std::unique_ptr<Simulation>(std::uint64_t seed)>;

}  // namespace trophic
