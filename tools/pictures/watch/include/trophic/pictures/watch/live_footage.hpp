// SPDX-License-Identifier: MIT
// The part of a live run that a window needs: its last moments, from the shown one on.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <trophic/habitat/arena.hpp>
#include <trophic/habitat/robot_model.hpp>
#include <trophic/io/agent_log.hpp>
#include <trophic/io/tables.hpp>
#include <trophic/observe/event.hpp>
#include <trophic/observe/frame.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/pictures/drawing/footage.hpp>
#include <trophic/pictures/watch/catch_scene.hpp>
#include <trophic/population/phenotype.hpp>
#include <trophic/population/view.hpp>
#include <utility>
#include <vector>

namespace trophic::watch {

/// Facts of an individual that are not in agents.csv.
struct Ancestry {
  std::optional<IndividualId> parent;
  double age_s = 0.0;  ///< since birth
};

/// Filled by a run, tick by tick; read as drawing::Footage. Not for two threads at once.
class LiveFootage {
 public:
  void start(const observe::RunDescription& run, const View& view) {
    if (!run.tags.empty()) filled_tag_ = *std::ranges::max_element(run.tags);
    until_s_ = run.until_s;
    tick_s_ = view.tick_s;
    for (Species species = 0; species < view.web.size(); ++species) species_.push_back(view.web.name(species));
    first_s_ = view.time_s;
    add_tick(view);
  }
  void add_frame(const observe::Frame& frame) {
    if (!robot_) {
      robot_ = frame.robot;
      arena_ = frame.arena;
    }
    Moment& moment = frames_.emplace_back();
    moment.time_s = frame.time_s;
    moment.roots.assign(frame.roots.begin(), frame.roots.end());
    moment.bodies.assign(frame.phenotypes.begin(), frame.phenotypes.end());
    for (std::size_t body = 0; body < frame.roots.size(); ++body) {
      const auto own = frame.joint_angles(body);
      moment.angles_rad.emplace_back(own.begin(), own.end());
    }
  }
  void add_death(const View& view, BodyIndex body, bool is_catch) {
    deaths_.push_back({.time_s = view.time_s, .x_m = view.poses[body].x_m, .y_m = view.poses[body].y_m, .is_catch = is_catch});
  }
  void add_catch(Catch one) { catches_.push_back(std::move(one)); }
  void add_tick(const View& view) {
    if (!ticks_.empty() && ticks_.back().time_s >= view.time_s) ticks_.pop_back();
    Tick& tick = ticks_.emplace_back();
    tick.time_s = view.time_s;
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      tick.rows.push_back(io::agent_row(view, body));
      tick.ancestries.push_back({.parent = view.robots[body].parent, .age_s = view.time_s - view.robots[body].born_s});
    }
  }
  /// Drops frames that no picture from `time_s` on needs, and deaths that no picture shows for `flash_s`.
  void forget_before(double time_s, double flash_s = drawing::flash_s) {
    std::erase_if(catches_, [&](const Catch& one) { return one.time_s < time_s; });
    while (frames_.size() > 2 && frames_[1].time_s <= time_s) frames_.pop_front();
    while (ticks_.size() > 2 && ticks_[1].time_s <= time_s - drawing::trail_s - 2.0 * tick_s_) ticks_.pop_front();
    std::erase_if(deaths_, [&](const drawing::Death& death) { return death.time_s < time_s - flash_s; });
  }

  /// Whether there is a frame to show.
  [[nodiscard]] bool is_ready() const { return !frames_.empty(); }
  /// All moments from the first to the newest are kept. Ecology seconds.
  [[nodiscard]] double newest_s() const { return ticks_.back().time_s; }
  [[nodiscard]] double first_s() const { return first_s_; }
  [[nodiscard]] double until_s() const { return until_s_; }  ///< when the run will end
  [[nodiscard]] double tick_s() const { return tick_s_; }

  [[nodiscard]] std::span<const io::AgentRow> rows_at(double time_s) const { return tick_at(time_s).rows; }
  [[nodiscard]] const Ancestry& ancestry(double time_s, std::size_t body) const { return tick_at(time_s).ancestries.at(body); }
  [[nodiscard]] Pose root(double time_s, std::size_t body) const {
    const auto [before, after] = frames_at(time_s, body);
    return drawing::between(before->roots[body], after->roots[body], part(*before, *after, time_s));
  }
  [[nodiscard]] std::vector<double> joint_angles_rad(double time_s, std::size_t body) const {
    const auto [before, after] = frames_at(time_s, body);
    const double way = part(*before, *after, time_s);
    std::vector<double> angles = before->angles_rad[body];
    for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = std::lerp(angles[i], after->angles_rad[body][i], way);
    return angles;
  }
  /// A robot's own body; null if all have the same.
  [[nodiscard]] std::shared_ptr<const RobotModel> body_of_robot(double time_s, std::size_t body) const {
    const Moment& moment = *frames_at(time_s, body).first;
    return moment.bodies.empty() ? nullptr : moment.bodies[body].robot;
  }
  [[nodiscard]] std::span<const drawing::Death> deaths() const { return deaths_; }
  /// The kept catches, in the order of time.
  [[nodiscard]] std::span<const Catch> catches() const { return catches_; }
  [[nodiscard]] const RobotModel& robot() const { return *robot_; }
  [[nodiscard]] const Arena& arena() const { return arena_; }
  [[nodiscard]] int filled_tag() const { return filled_tag_; }
  [[nodiscard]] std::span<const std::string> species() const { return species_; }
  [[nodiscard]] const std::string& species(Species species) const { return species_.at(species); }

  /// Number of kept frames.
  [[nodiscard]] std::size_t frames() const { return frames_.size(); }
  [[nodiscard]] std::size_t ticks() const { return ticks_.size(); }

 private:
  struct Moment {
    double time_s = 0.0;
    std::vector<Pose> roots;
    std::vector<std::vector<double>> angles_rad;  ///< of each robot
    std::vector<Phenotype> bodies;                ///< of each robot, if they differ
  };
  struct Tick {
    double time_s = 0.0;
    std::vector<io::AgentRow> rows;
    std::vector<Ancestry> ancestries;
  };

  [[nodiscard]] const Tick& tick_at(double time_s) const {
    const auto after = std::ranges::upper_bound(ticks_, time_s + 1e-9, {}, &Tick::time_s);
    return after == ticks_.begin() ? ticks_.front() : *std::prev(after);
  }
  /// The frames before and after a moment; the same one outside of the kept frames, and before a newborn's body is set down.
  [[nodiscard]] std::pair<const Moment*, const Moment*> frames_at(double time_s, std::size_t body) const {
    const auto after = std::ranges::upper_bound(frames_, time_s, {}, &Moment::time_s);
    if (after == frames_.begin()) return {&frames_.front(), &frames_.front()};
    if (after == frames_.end()) return {&frames_.back(), &frames_.back()};
    const auto before = std::prev(after);
    const bool jumps = !before->bodies.empty() && before->bodies[body].individual != after->bodies[body].individual;
    return {&*before, jumps ? &*before : &*after};
  }
  [[nodiscard]] static double part(const Moment& before, const Moment& after, double time_s) {
    const double gap_s = after.time_s - before.time_s;
    return gap_s > 0.0 ? (time_s - before.time_s) / gap_s : 0.0;
  }

  std::optional<RobotModel> robot_;
  Arena arena_;
  std::vector<std::string> species_;
  std::deque<Moment> frames_;
  std::deque<Tick> ticks_;
  std::vector<drawing::Death> deaths_;
  std::vector<Catch> catches_;
  double first_s_ = 0.0;
  double until_s_ = 0.0;
  double tick_s_ = 1.0;
  int filled_tag_ = 1;
};
static_assert(drawing::Footage<LiveFootage>);

}  // namespace trophic::watch
