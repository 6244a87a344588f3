// SPDX-License-Identifier: MIT
// Pictures of a recorded run at any moment. Empty for who does not link trophic::film.
#pragma once

#ifdef TROPHIC_WITH_FILM
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <tools/film/picture.hpp>
#include <tools/trophic/replay/recorded_agents.hpp>
#include <tools/trophic/replay/recorded_run.hpp>
#include <tuple>
#include <vector>

namespace trophic::command::replay {

/// Time for which a ring round a death is visible where `pace` ecology seconds pass in a second of the viewer's: that second, but
/// at least 6 s and at most 1000 s, as more rings hide the robots.
[[nodiscard]] inline double flash_at(double pace) {
  return std::clamp(pace, 6.0, 1000.0);
}

/// The visible parts of a moment other than its robots.
struct Sights {
  std::optional<IndividualId> marked = {};  ///< highlighted individual
  /// The moment whose occupants are shown, if it is not the picture's: at the tick of a catch its victim is gone.
  std::optional<double> rows_s = {};
  std::vector<IndividualId> named = {};     ///< whose names are written
  bool has_lines = true;                    ///< trails, and who perceives whom
  std::optional<IndividualId> victim = {};  ///< the one whose death is marked alone
  std::optional<IndividualId> hunter = {};  ///< the one whose reach is marked
  std::optional<double> reach_m = {};
};

/// A stretch of a recorded run.
class Footage {
 public:
  /// `flash_s`: how long a death is visible. Throws std::invalid_argument for tables that are not the run's.
  Footage(const RecordedRun& run, double from_s, double to_s, double flash_s);

  /// The picture of a moment, without title, caption and legend.
  [[nodiscard]] film::Picture picture(double time_s, const Sights& sights) const;
  /// Names every mark of that picture, and counts who lives at its moment.
  [[nodiscard]] std::vector<film::LegendEntry> legend(double time_s, const Sights& sights) const;
  /// How many of each species lived in the stretch until a moment; none where numbers do not change.
  void add_curves(film::Picture& picture, double time_s) const;

  [[nodiscard]] Pose root(double time_s, std::size_t body) const { return root(time_s, body, agents_.find(time_s, body)); }
  [[nodiscard]] const io::RecordingHead& head() const { return recording_.head(); }
  /// The body in which an individual lives. Throws std::invalid_argument for one that does not live in the stretch.
  [[nodiscard]] std::size_t body_of(IndividualId id) const;

 private:
  struct Death {
    double time_s = 0.0;
    double x_m = 0.0;
    double y_m = 0.0;
    bool is_catch = false;
    IndividualId id = 0;
  };

  [[nodiscard]] Pose root(double time_s, std::size_t body, const io::AgentRow* row) const;
  [[nodiscard]] film::RobotLook look(double time_s, const io::AgentRow& row) const;
  void add_trail(film::Picture& picture, double time_s, const io::AgentRow& row) const;
  /// The frames before and after a moment, and how far it is between them; the same one before a newborn's body is set down.
  [[nodiscard]] std::tuple<std::size_t, std::size_t, double> around(double time_s, std::size_t body) const;

  const io::RecordingReader& recording_;
  RecordedAgents agents_;
  RecordedFood food_;
  double from_s_;
  double to_s_;
  double flash_s_;
  std::vector<int> tags_;
  Json rules_;  ///< the policy of each slot that the table fills
  std::vector<std::string> species_;
  std::vector<Death> deaths_;
  std::vector<film::Curve> curves_ = {};  ///< of the whole stretch
  double most_ = 0.0;                     ///< of one species at once
};

}  // namespace trophic::command::replay
#endif
