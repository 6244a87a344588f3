// SPDX-License-Identifier: MIT
// A catch of a recorded run: who caught whom, when, and what the victim's life was.
#pragma once

#include <tools/trophic/replay/recorded_run.hpp>
#include <trophic/population/individual.hpp>

namespace trophic::command::replay {

struct CatchScene {
  double time_s = 0.0;
  IndividualId hunter = 0;
  IndividualId victim = 0;
  std::size_t hunter_body = 0;
  std::size_t victim_body = 0;
  std::string sentence;  ///< "predator 19 catches prey 4: inherited, lived 92 s"

  /// How much of the ecology's clock a film shows before and after, and for how long of its own time the moment stands still.
  static constexpr double before_s = 8.0;
  static constexpr double after_s = 3.0;
  static constexpr double still_s = 1.2;
};

/// Number `number` of the run's catches, from 1. Throws std::invalid_argument for a run with fewer.
[[nodiscard]] CatchScene find_catch(const RecordedRun& run, std::uint64_t number);

}  // namespace trophic::command::replay
