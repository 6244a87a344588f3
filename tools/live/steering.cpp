// SPDX-License-Identifier: MIT
// Definitions of steering.hpp.
#include <algorithm>
#include <chrono>
#include <tools/live/steering.hpp>
#include <tools/replicates/stop_on_signal.hpp>
#include <utility>

namespace trophic::live {

namespace {

/// A signal's handler cannot notify, so that who waits looks this often.
constexpr std::chrono::milliseconds glance{50};

}  // namespace

void Steering::begin(double tick_s, const observe::RunDescription& run) {
  describe(run);
  const std::lock_guard lock{mutex_};
  tick_s_ = tick_s;
  due_at_s_ = watch_.elapsed_s();
  is_visible_ = false;  // wishes stay: a page may be faster than the start of its run
}

void Steering::describe(const observe::RunDescription& run) {
  const std::lock_guard lock{mutex_};
  name_ = observe::short_name(run);
  made_ = run.changes;
}

void Steering::set_visible() {
  const std::lock_guard lock{mutex_};
  is_visible_ = true;
}

void Steering::set_pages(std::size_t pages) {
  const std::lock_guard lock{mutex_};
  pages_ = pages;
  had_page_ = had_page_ || pages > 0;
  changed_.notify_all();
}

void Steering::pause() {
  const std::lock_guard lock{mutex_};
  pace_.is_paused = true;
  steps_ = 0;
  changed_.notify_all();
}

void Steering::play() {
  const std::lock_guard lock{mutex_};
  pace_.is_paused = false;
  due_at_s_ = watch_.elapsed_s();
  changed_.notify_all();
}

void Steering::step() {
  const std::lock_guard lock{mutex_};
  pace_.is_paused = true;
  ++steps_;
  changed_.notify_all();
}

void Steering::set_speed(double speed) {
  const std::lock_guard lock{mutex_};
  pace_.speed = speed;
  due_at_s_ = watch_.elapsed_s();
  changed_.notify_all();
}

void Steering::change(changes::Change change) {
  const std::lock_guard lock{mutex_};
  wishes_.push_back(std::move(change));
  changed_.notify_all();
}

void Steering::restart(std::uint64_t seed, std::string rule_table) {
  const std::lock_guard lock{mutex_};
  restart_ = command::Restart{.seed = seed, .rule_table = std::move(rule_table), .made = {}};
  changed_.notify_all();
}

Pace Steering::pace() const {
  const std::lock_guard lock{mutex_};
  return pace_;
}

std::pair<std::string, std::vector<observe::ParameterChange>> Steering::rules() const {
  const std::lock_guard lock{mutex_};
  return {name_, made_};
}

bool Steering::is_paced() const {
  const std::lock_guard lock{mutex_};
  return pace_.is_paused || pace_.speed > 0.0;
}

/// Whether the next tick may be made now; if so, when the one after it is due.
bool Steering::is_released(double now_s) {
  if (!is_visible_) return true;
  if (!had_page_) return false;
  if (pace_.is_paused) return steps_ > 0 && steps_-- > 0;
  if (!(pace_.speed > 0.0)) return true;
  if (now_s < due_at_s_) return false;
  const double gap_s = tick_s_ / pace_.speed;
  due_at_s_ = std::max(due_at_s_, now_s - gap_s) + gap_s;
  return true;
}

std::vector<changes::Change> Steering::due(double) {
  std::unique_lock lock{mutex_};
  while (replicates::StopOnSignal::caught() == 0 && !restart_) {
    if (!wishes_.empty()) return std::exchange(wishes_, {});
    const double now_s = watch_.elapsed_s();
    if (is_released(now_s)) break;
    const bool is_timed = had_page_ && !pace_.is_paused && pace_.speed > 0.0;
    const std::chrono::duration<double> left{due_at_s_ - now_s};
    changed_.wait_for(lock, is_timed ? std::min<std::chrono::duration<double>>(left, glance) : glance);
  }
  return {};
}

bool Steering::ends() const {
  const std::lock_guard lock{mutex_};
  return restart_.has_value() || replicates::StopOnSignal::caught() != 0;
}

void Steering::refused(const changes::Change&, const std::string& why) {
  listener_.refused(why);
}

std::optional<command::Restart> Steering::wait_for_restart(double grace_s) {
  std::unique_lock lock{mutex_};
  double alone_since_s = watch_.elapsed_s();
  while (!restart_) {
    if (replicates::StopOnSignal::caught() != 0) return std::nullopt;
    const double now_s = watch_.elapsed_s();
    if (pages_ > 0) alone_since_s = now_s;
    if (now_s - alone_since_s >= grace_s) return std::nullopt;
    changed_.wait_for(lock, glance);
  }
  restart_->made = made_;
  steps_ = 0;
  wishes_.clear();
  return std::exchange(restart_, std::nullopt);
}

}  // namespace trophic::live
