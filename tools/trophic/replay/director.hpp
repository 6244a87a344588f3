// SPDX-License-Identifier: MIT
// The director of page, film and the strip of `trophic plot`: what they show of a catch, from where, and the catch that they
// choose.
#pragma once

#include <tools/trophic/replay/shot.hpp>
#include <trophic/population/individual.hpp>
#include <trophic/support/json.hpp>

namespace trophic::command::replay {

struct RecordedRun;
struct Window;

/// An individual of a catch.
struct Partner {
  IndividualId id = 0;
  std::size_t body = 0;
  std::string species;
  std::string origin = {};
  double born_s = 0.0;
};

/// A catch from some seconds before it, at the ecology's own speed, by a camera that stands still; the catch itself stands still
/// for a moment. It begins later if one of the two is born later.
struct Scene {
  static constexpr double before_s = 8.0;  ///< of the ecology's clock
  static constexpr double after_s = 3.0;
  static constexpr double still_s = 1.2;  ///< of the viewer's time

  /// Shortcomings of a scene, the worst last. The sum of a scene's flaws is smaller than one that is worse.
  enum Flaw : unsigned {
    random_hunter = 1,  ///< the hunter inherited no genome
    much_outside = 2,   ///< more than a quarter of the picture is outside the arena
    wall_in_front = 4,  ///< no camera inside the arena sees both
    other_catches = 8,  ///< in the picture
    cut = 16,           ///< the recording, or the shown stretch, begins or ends too late or too early
    newborn = 32        ///< the hunter or its victim is younger than `before_s`
  };

  double time_s = 0.0;
  double begins_s = 0.0;
  double ends_s = 0.0;
  Partner hunter;
  Partner victim;
  double x_m = 0.0;  ///< of the catch
  double y_m = 0.0;
  std::string sentence;                ///< "predator 19 catches prey 4: inherited, lived 92 s"
  std::optional<double> reach_m = {};  ///< how close a victim must be, if a parameter says so
  unsigned flaws = 0;
  std::string remark = {};  ///< flaws in words, except of genomes; empty if there is none
  Shot shot = {};

  /// Adds a flaw, with words for the remark.
  void add(Flaw flaw, const std::string& words);
};

/// A catch whose camera is not chosen yet.
[[nodiscard]] Scene scene_of(double time_s, const Partner& hunter, const Partner& victim);

/// Chooses the camera. The tracks are those of hunter and victim.
void frame(Scene& scene, std::span<const Track> tracks, const Arena& arena);

/// The catches of a run, in the order of its events, without cameras.
[[nodiscard]] std::vector<Scene> catches_of(const RecordedRun& run);

/// Gives one of a run's catches its camera, and the flaws that it has within a stretch of the run.
void stage(Scene& scene, const std::vector<Scene>& catches, const RecordedRun& run, const Window& window);

/// The scenes of a stretch.
[[nodiscard]] std::vector<Scene> scenes_of(const RecordedRun& run, const Window& window);

/// The scene that page and strip show: the first of those with the fewest flaws. If all have some, those of genomes are given up
/// first, and those of newborns last. Null for no scenes.
[[nodiscard]] const Scene* best_of(const std::vector<Scene>& scenes);

/// A scene as a page plays it: times of the ecology's clock, individuals and bodies, the camera, the sentence.
[[nodiscard]] Json json_of(const Scene& scene);

/// The scenes of a stretch as a page plays them. The one at which a page opens says so.
[[nodiscard]] Json json_of_scenes(const RecordedRun& run, const Window& window);

}  // namespace trophic::command::replay
