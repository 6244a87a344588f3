// SPDX-License-Identifier: MIT
// One progress line for several runs at once.
#pragma once

#include <cstdio>
#include <map>
#include <mutex>
#include <ostream>
#include <trophic/observe/progress.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/observe/tally.hpp>
#include <trophic/observe/terminal.hpp>
#include <trophic/population/view.hpp>

namespace trophic::replicates {

/// Shows the progress of a set of runs on stderr if that is a terminal, as much of it as fits one line. Writes a line to `out`
/// for each run that ends. May be called from several threads at once.
class JointProgress {
 public:
  /// Watches `runs` runs; `clock_s` is the duration of each.
  JointProgress(std::size_t runs, double clock_s, std::ostream& out, bool show = observe::stderr_is_terminal())
      : runs_{runs}, clock_s_{clock_s}, out_{out}, show_{show} {}

  /// Watches one call of run_until.
  class Part {
   public:
    Part(JointProgress& joint, std::string name) : joint_{&joint}, name_{std::move(name)} {}

    static constexpr std::string_view section = observe::Progress::section;
    template <class Archive>
    void persist(Archive& archive) {
      archive(tally_);
    }

    void on_start(const observe::RunDescription& run, const View& view) {
      clock_scale_ = run.clock_scale;
      from_s_ = view.time_s;
      watch_ = {};
      joint_->advance(name_, 0.0, clock_scale_);
    }
    void on_event(const observe::Event& event, const View& view) { tally_.on_event(event, view); }
    void on_tick(const View& view) {
      tally_.on_tick(view);
      joint_->advance(name_, view.time_s - from_s_, clock_scale_);
    }
    void on_end(const View& view) {
      const double clock_s = view.time_s - from_s_;
      joint_->finish(name_, name_ + "  " + observe::short_text(view.time_s) + " s, " + std::to_string(tally_.deaths()) +
                                " deaths, " + observe::duration_text(watch_.elapsed_s()) + " (" +
                                observe::short_text(clock_s * clock_scale_ / watch_.elapsed_s()) + "x real time)");
    }
    void on_failure(std::string_view what) { joint_->finish(name_, name_ + "  failed: " + std::string{what}); }

    [[nodiscard]] double elapsed_s() const { return watch_.elapsed_s(); }

   private:
    JointProgress* joint_;
    std::string name_;
    double clock_scale_ = 1.0;
    double from_s_ = 0.0;
    observe::Stopwatch watch_;
    observe::Tally tally_;
  };

  /// The observer of the run of this name; must not outlive this object.
  [[nodiscard]] Part watch(std::string name) { return {*this, std::move(name)}; }

 private:
  void advance(const std::string& name, double clock_s, double clock_scale) {
    const std::scoped_lock lock{mutex_};
    clock_scale_ = clock_scale;
    running_s_[name] = clock_s;
    if (!show_ || watch_.elapsed_s() - drawn_s_ < 0.1) return;
    drawn_s_ = watch_.elapsed_s();
    std::fprintf(stderr, "\r%s\033[K", line().c_str());
    std::fflush(stderr);
  }

  void finish(const std::string& name, const std::string& text) {
    const std::scoped_lock lock{mutex_};
    done_s_ += running_s_[name];
    running_s_.erase(name);
    ++done_;
    if (show_) std::fputs("\r\033[K", stderr);
    out_ << text << std::endl;
  }

  [[nodiscard]] std::string line() const {
    double clock_s = done_s_;
    std::string who;
    for (const auto& [name, time_s] : running_s_) {
      clock_s += time_s;
      if (running_s_.size() <= 8) who += (who.empty() ? "" : ", ") + name + " " + observe::short_text(time_s) + " s";
    }
    const double share = clock_s / (clock_s_ * static_cast<double>(runs_));
    const double wall_s = watch_.elapsed_s();
    const std::array parts{std::to_string(done_) + " of " + std::to_string(runs_) + " done",
                           observe::short_text(100.0 * share) + " %",
                           (share > 0.0 ? observe::duration_text(wall_s / share - wall_s) : "?") + " left",
                           std::to_string(running_s_.size()) + " running",
                           observe::short_text(clock_s * clock_scale_ / wall_s) + "x real time",
                           who};
    return observe::fitting_line(parts, observe::terminal_columns());
  }

  std::size_t runs_;
  double clock_s_;
  std::ostream& out_;
  bool show_;
  std::mutex mutex_;
  observe::Stopwatch watch_;
  double drawn_s_ = 0.0;
  double clock_scale_ = 1.0;
  double done_s_ = 0.0;
  std::size_t done_ = 0;
  std::map<std::string, double> running_s_;
};

}  // namespace trophic::replicates
