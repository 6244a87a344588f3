// SPDX-License-Identifier: MIT
// A progress line with rate and remaining time, and the closing summary. The only reader of the wall clock, except for
// FasterMode.
#pragma once

#include <chrono>
#include <cstdio>
#include <ostream>
#include <trophic/observe/event.hpp>
#include <trophic/observe/print_remarks.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/observe/tally.hpp>
#include <trophic/observe/terminal.hpp>
#include <trophic/population/view.hpp>

namespace trophic::observe {

/// Wall time since construction, seconds.
class Stopwatch {
 public:
  [[nodiscard]] double elapsed_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A human-readable duration: "45 s", "3 min 20 s", "2 h 5 min".
[[nodiscard]] inline std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

/// A number with one decimal, or without decimals from 100 on.
[[nodiscard]] inline std::string short_text(double number) {
  std::string text(32, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), number < 100.0 ? "%.1f" : "%.0f", number)));
  return text;
}

/// Prints the remarks on the run to stderr and, if that is a terminal, its progress, as much of it as fits one line. Always
/// counts for the summary.
class Progress {
 public:
  explicit Progress(bool show = stderr_is_terminal()) : show_{show} {}

  static constexpr std::string_view section = "progress";  ///< name of its section in a checkpoint
  template <class Archive>
  void persist(Archive& archive) {
    archive(tally_);
  }

  void on_start(const RunDescription& run, const View& view) {
    run_ = run;
    from_s_ = view.time_s;
    watch_ = {};
    drawn_s_ = 0.0;
    print_remarks(run.remarks);
  }
  void on_change(const RunDescription& run, const View&) {
    clear();
    print_remarks(run.remarks);
  }
  void on_event(const Event& event, const View& view) { tally_.on_event(event, view); }
  void on_tick(const View& view) {
    tally_.on_tick(view);
    if (!show_ || watch_.elapsed_s() - drawn_s_ < 0.1) return;
    drawn_s_ = watch_.elapsed_s();
    const std::string text = line(view);
    std::fprintf(stderr, "\r%s\033[K", text.c_str());
    std::fflush(stderr);
  }
  void on_end(const View&) { clear(); }
  void on_failure(std::string_view) { clear(); }

  /// Prints the ratio of simulated to wall time, the engine's remarks, births, deaths by cause, living individuals, and species
  /// that died out.
  void summary(std::ostream& out, const View& view) const {
    const double wall_s = watch_.elapsed_s();
    const double simulated_s = (view.time_s - from_s_) * run_.clock_scale;
    out << run_.rules << " on " << run_.backend << ", seed " << run_.seed << ": " << short_text(view.time_s - from_s_)
        << " s of the ecology's clock, " << short_text(simulated_s) << " simulated s in " << duration_text(wall_s) << " ("
        << short_text(simulated_s / wall_s) << " simulated s per wall s)\n";
    out << "births  " << tally_.births() << " (" << view.robots.size() - run_.spare_bodies << " founders; "
        << tally_.births(Origin::inherited) << " inherited)\n";
    out << "deaths  " << tally_.deaths();
    bool is_first = true;
    for (const auto& [cause, deaths] : tally_.deaths_by_cause()) {
      if (deaths == 0 && !can_happen(cause)) continue;
      out << (std::exchange(is_first, false) ? " (" : ", ") << deaths << " " << cause;
    }
    out << (is_first ? "\n" : ")\n");
    if (view.refused_births > 0) out << "remark  " << view.refused_births << " births found no free body or no room\n";
    if (view.is_over)
      out << "ended   at " << short_text(view.time_s) << " of " << short_text(run_.until_s) << " s; " << end_text(view) << "\n";
    out << "alive  ";
    for (Species species = 0; species < view.web.size(); ++species)
      out << " " << view.count(species) << " " << view.web.name(species);
    out << "\n";
    for (Species species = 0; species < tally_.gone_s().size(); ++species)
      if (tally_.gone_s()[species] >= 0.0)
        out << "gone    " << view.web.name(species) << " since " << short_text(tally_.gone_s()[species]) << " s\n";
  }

  [[nodiscard]] double elapsed_s() const { return watch_.elapsed_s(); }

 private:
  /// Whether the rule table has a rule by which individuals die of this cause.
  [[nodiscard]] bool can_happen(std::string_view cause) const {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> rules{{{"caught", "capture"},
                                                                                  {"starved", "starvation"},
                                                                                  {"starved", "metabolism"},
                                                                                  {"sacrificed", "minimum_predators"},
                                                                                  {"senescence", "senescence"}}};
    return std::ranges::any_of(rules, [&](const auto& rule) {
      return rule.first == cause && std::ranges::any_of(run_.slots, [&](const auto& slot) { return slot.first == rule.second; });
    });
  }

  [[nodiscard]] std::string line(const View& view) const {
    const double done = (view.time_s - from_s_) / (run_.until_s - from_s_);
    const double wall_s = watch_.elapsed_s();
    const double rate = (view.time_s - from_s_) * run_.clock_scale / wall_s;
    std::string counts;
    for (Species species = 0; species < view.web.size(); ++species) {
      counts += (species == 0 ? "" : " ") + std::to_string(view.count(species)) + " " + std::string{view.web.name(species)};
    }
    const std::array parts{short_text(view.time_s) + " of " + short_text(run_.until_s) + " s",
                           short_text(100.0 * done) + " %",
                           (done > 0.0 ? duration_text(wall_s / done - wall_s) : "?") + " left",
                           short_text(rate) + "x real time",
                           counts,
                           std::to_string(tally_.deaths()) + " deaths"};
    return fitting_line(parts, terminal_columns());
  }

  void clear() const {
    if (show_) std::fputs("\r\033[K", stderr);
  }

  bool show_;
  RunDescription run_;
  double from_s_ = 0.0;
  Stopwatch watch_;
  double drawn_s_ = 0.0;
  Tally tally_;
};

}  // namespace trophic::observe
