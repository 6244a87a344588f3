// SPDX-License-Identifier: MIT
// Pause, speed, single ticks, changes and restarts: pages ask for them in one thread, the run follows in another.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <tools/changes/changing_simulation.hpp>
#include <tools/live/live_server.hpp>
#include <trophic/observe/progress.hpp>
#include <vector>

namespace trophic::live {

/// Hears of what the run made of a page's wishes. Called in the thread of the run.
class Listener {
 public:
  Listener() = default;
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  virtual ~Listener() = default;
  virtual void refused(const std::string& why) = 0;
};

/// The state that all pages show.
struct Pace {
  bool is_paused = false;
  double speed = 10.0;  ///< ecology seconds a second; 0: as fast as it goes
  friend bool operator==(const Pace&, const Pace&) = default;
};

/// Each member may be called from any thread. A run waits until the first page is open.
class Steering final : public changes::Conductor {
 public:
  explicit Steering(Listener& listener) : listener_{listener} {}

  /// Another run begins, or one that was resumed after changes. Until something of it can be seen, it does not wait.
  void begin(double tick_s, const observe::RunDescription& run);
  void describe(const observe::RunDescription& run);
  void set_visible();

  // For pages.
  void set_pages(std::size_t pages);
  void pause();
  void play();
  /// One tick, then pause.
  void step();
  void set_speed(double speed);
  void change(changes::Change change);
  void restart(std::uint64_t seed, std::string rule_table);
  [[nodiscard]] Pace pace() const;
  /// The short name of the run's rules, and the changes of its parameters.
  [[nodiscard]] std::pair<std::string, std::vector<observe::ParameterChange>> rules() const;

  // For the run.
  [[nodiscard]] std::vector<changes::Change> due(double time_s) override;
  [[nodiscard]] bool ends() const override;
  void made(const observe::ParameterChange&) override {}  // in the description, which follows
  void refused(const changes::Change& change, const std::string& why) override;
  /// Whether ticks come at a speed that people chose, and not as fast as they go.
  [[nodiscard]] bool is_paced() const;

  /// After a run: waits for a restart; `nullopt` if a signal came or no page was open for `grace_s`.
  [[nodiscard]] std::optional<command::Restart> wait_for_restart(double grace_s);

 private:
  [[nodiscard]] bool is_released(double now_s);

  Listener& listener_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  observe::Stopwatch watch_;
  Pace pace_;
  double tick_s_ = 1.0;
  double due_at_s_ = 0.0;  ///< when the next tick is due, by the watch
  std::size_t pages_ = 0;
  std::size_t steps_ = 0;  ///< ticks to make while paused
  bool had_page_ = false;
  bool is_visible_ = false;
  std::vector<changes::Change> wishes_;
  std::string name_;                            ///< of the run's rules
  std::vector<observe::ParameterChange> made_;  ///< changes of the run
  std::optional<command::Restart> restart_;
};

}  // namespace trophic::live
