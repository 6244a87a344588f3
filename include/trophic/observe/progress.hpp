// SPDX-License-Identifier: MIT
// A progress line with rate and remaining time, and the closing summary. The only reader of the wall clock, except for
// FasterMode.
#pragma once

#include <chrono>
#include <iosfwd>
#include <trophic/observe/event.hpp>
#include <trophic/observe/run_description.hpp>
#include <trophic/observe/tally.hpp>
#include <trophic/observe/terminal.hpp>
#include <trophic/population/view.hpp>
#include <trophic/support/linkage.hpp>

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

/// A duration for readers: "45 s", "3 min 20 s", "2 h 5 min".
[[nodiscard]] std::string duration_text(double seconds);

/// A number with one decimal, or none from 100 on.
[[nodiscard]] std::string short_text(double number);

/// Shows the progress of the run on stderr if that is a terminal, as much of it as fits one line. Always counts for the
/// summary.
class Progress {
 public:
  explicit Progress(bool show = stderr_is_terminal()) : show_{show} {}

  static constexpr std::string_view section = "progress";  ///< of a checkpoint
  template <class Archive>
  void persist(Archive& archive) {
    archive(tally_);
  }

  void on_start(const RunDescription& run, const View& view);
  void on_event(const Event& event, const View& view) { tally_.on_event(event, view); }
  void on_tick(const View& view);
  void on_end(const View&) { clear(); }
  void on_failure(std::string_view) { clear(); }

  /// Simulated over wall time, the engine's remarks, births, deaths by cause, living individuals.
  void summary(std::ostream& out, const View& view) const;

  [[nodiscard]] double elapsed_s() const { return watch_.elapsed_s(); }

 private:
  [[nodiscard]] std::string line(const View& view) const;

  void clear() const;

  bool show_;
  RunDescription run_;
  double from_s_ = 0.0;
  Stopwatch watch_;
  double drawn_s_ = 0.0;
  Tally tally_;
};

}  // namespace trophic::observe

#if TROPHIC_HEADER_ONLY
#include <trophic/observe/progress.ipp>
#endif
