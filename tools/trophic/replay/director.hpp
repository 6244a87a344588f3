// SPDX-License-Identifier: MIT
// The director of film and page: what they show of a catch, and at which catch a page opens.
#pragma once

#include <trophic/population/individual.hpp>
#include <trophic/support/json.hpp>

namespace trophic::command::replay {

struct RecordedRun;
struct Window;

/// A catch from some seconds before it, at the ecology's own speed, with both robots in the picture; the catch itself stands
/// still for a moment.
struct Scene {
  static constexpr double before_s = 8.0;  ///< of the ecology's clock
  static constexpr double after_s = 3.0;
  static constexpr double still_s = 1.2;  ///< of the viewer's time

  double time_s = 0.0;
  IndividualId hunter = 0;
  IndividualId victim = 0;
  std::size_t hunter_body = 0;
  std::size_t victim_body = 0;
  std::string sentence;              ///< "predator 19 catches prey 4: inherited, lived 92 s"
  bool hunter_is_inherited = false;  ///< whether the hunter's genome is
};

/// An individual of a catch.
struct Partner {
  IndividualId id = 0;
  std::size_t body = 0;
  std::string species;
  std::string origin;
  double born_s = 0.0;
};

[[nodiscard]] Scene scene_of(double time_s, const Partner& hunter, const Partner& victim);

/// The scenes of all catches of a run, in the order of its events.
[[nodiscard]] std::vector<Scene> scenes_of(const RecordedRun& run);

/// A scene as a page plays it: times of the ecology's clock, the bodies that stay in the picture, the sentence.
[[nodiscard]] Json json_of(const Scene& scene);

/// The scenes of a stretch as a page plays them. The one at which a page opens says so: the first with an inherited hunter that
/// has its whole beginning in the stretch; else the first that has.
[[nodiscard]] Json scenes_of(const RecordedRun& run, const Window& window);

}  // namespace trophic::command::replay
