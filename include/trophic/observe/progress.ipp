// SPDX-License-Identifier: MIT
// Definitions of progress.hpp.
#pragma once

#include <cmath>
#include <cstdio>
#include <ostream>
#include <trophic/observe/progress.hpp>

namespace trophic::observe {

TROPHIC_INLINE std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

TROPHIC_INLINE std::string short_text(double number) {
  std::string text(32, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), number < 100.0 ? "%.1f" : "%.0f", number)));
  return text;
}

TROPHIC_INLINE void Progress::on_start(const RunDescription& run, const View& view) {
  run_ = run;
  from_s_ = view.time_s;
  watch_ = {};
  drawn_s_ = 0.0;
}

TROPHIC_INLINE void Progress::on_tick(const View& view) {
  if (!show_ || watch_.elapsed_s() - drawn_s_ < 0.1) return;
  drawn_s_ = watch_.elapsed_s();
  const std::string text = line(view);
  std::fprintf(stderr, "\r%s\033[K", text.c_str());
  std::fflush(stderr);
}

TROPHIC_INLINE void Progress::summary(std::ostream& out, const View& view) const {
  const double wall_s = watch_.elapsed_s();
  const double simulated_s = (view.time_s - from_s_) * run_.clock_scale;
  out << run_.rules << " on " << run_.backend << ", seed " << run_.seed << ": " << short_text(view.time_s - from_s_)
      << " s of the ecology's clock, " << short_text(simulated_s) << " simulated s in " << duration_text(wall_s) << " ("
      << short_text(simulated_s / wall_s) << " simulated s per wall s)\n";
  for (const std::string& remark : run_.remarks) out << "remark  " << remark << "\n";
  out << "births  " << tally_.births() << " (" << view.robots.size() - run_.spare_bodies << " founders; "
      << tally_.births(Origin::inherited) << " inherited)\n";
  out << "deaths  " << tally_.deaths();
  for (std::size_t cause = 0; cause < enum_names(Cause{}).size(); ++cause) {
    if (tally_.deaths(static_cast<Cause>(cause)) == 0 && static_cast<Cause>(cause) == Cause::diverged) continue;
    out << (cause == 0 ? " (" : ", ") << tally_.deaths(static_cast<Cause>(cause)) << " " << enum_name(static_cast<Cause>(cause));
  }
  out << ")\nalive  ";
  for (Species species = 0; species < view.web.size(); ++species)
    out << " " << view.count(species) << " " << view.web.name(species);
  out << "\n";
}

TROPHIC_INLINE std::string Progress::line(const View& view) const {
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

TROPHIC_INLINE void Progress::clear() const {
  if (show_) std::fputs("\r\033[K", stderr);
}

}  // namespace trophic::observe
