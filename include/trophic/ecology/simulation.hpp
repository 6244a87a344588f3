// SPDX-License-Identifier: MIT
// An ecology whose rules and backend one need not know.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <trophic/observe/audience.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/params/archive.hpp>
#include <trophic/population/view.hpp>
#include <type_traits>

namespace trophic::io {
struct StateColumns;
}

namespace trophic {

/// An ecology as those see it who run it, watch it or keep checkpoints of it, whatever its rule table and its backend are.
class Simulation {
 public:
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;
  virtual ~Simulation() = default;

  /// Runs until the clock reaches `until_s` (rounded up to whole ticks) or an observer says stop. May be called again to go on.
  /// An observer that gives up a tick leaves everything as it was before that tick.
  /// If anything throws, the observers are told and the exception goes on.
  template <class... Observers>
  void run_until(double until_s, Observers&&... observers) {
    observe::AudienceOf<std::remove_reference_t<Observers>...> audience{observers...};
    run(until_s, audience);
  }

  /// Writes everything that decides how the run goes on to an archive, or reads it: then an ecology of the same numbers goes on
  /// from that moment to the same bytes. Between ticks only. Reading throws std::invalid_argument for what is no such moment; the
  /// ecology is then good for nothing.
  virtual void persist(Archive& archive) = 0;

  [[nodiscard]] virtual double time_s() const = 0;
  [[nodiscard]] virtual std::int64_t tick() const = 0;
  /// The world as rules see it now. Valid as long as the ecology lives and does not run.
  [[nodiscard]] virtual View view() const = 0;
  /// What determines this run, for observers.
  [[nodiscard]] virtual observe::RunDescription describe(double until_s) const = 0;
  /// What rules with a State keep, for states.csv (trophic/io/state_log.hpp). Refers to the ecology.
  [[nodiscard]] virtual io::StateColumns state_columns() const = 0;

 protected:
  Simulation() = default;

 private:
  virtual void run(double until_s, observe::Audience& audience) = 0;
};

/// Makes the ecology of one experiment with the seed of one run or another.
using MakeSimulation = std::function<std::unique_ptr<Simulation>(std::uint64_t seed)>;

}  // namespace trophic
