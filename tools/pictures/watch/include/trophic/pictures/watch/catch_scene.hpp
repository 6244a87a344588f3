// SPDX-License-Identifier: MIT
// A catch as a window plays it: from some seconds before it, at the ecology's own speed; the moment itself stands still for a
// second.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <trophic/observe/event.hpp>
#include <trophic/population/view.hpp>
#include <utility>

namespace trophic::watch {

struct Catch {
  double time_s = 0.0;
  IndividualId hunter = 0;
  IndividualId victim = 0;
  std::size_t hunter_body = 0;
  std::size_t victim_body = 0;
  std::string sentence;  ///< "predator 19 catches prey 4: inherited, lived 92 s"
};

/// The catch of an event, whose victim still lives in the view.
[[nodiscard]] inline Catch catch_of(const observe::Event& event, const View& view) {
  Catch one{.time_s = view.time_s,
            .hunter = event.individual.id,
            .victim = *event.other,
            .hunter_body = event.body,
            .victim_body = event.body,
            .sentence = {}};
  const auto name = [&](const Individual& individual) {
    return view.web.name(individual.species) + " " + std::to_string(individual.id);
  };
  const auto victim = std::ranges::find(view.robots, one.victim, &Individual::id);
  if (victim == view.robots.end()) return one;
  one.victim_body = static_cast<std::size_t>(victim - view.robots.begin());
  one.sentence = name(event.individual) + " catches " + name(*victim) + ": " + std::string{enum_name(victim->origin)} +
                 ", lived " + std::to_string(static_cast<long>(view.time_s - victim->born_s + 0.5)) + " s";
  return one;
}

class CatchScene {
 public:
  static constexpr double before_s = 8.0;  ///< of the ecology's clock
  static constexpr double after_s = 4.0;
  static constexpr double still_s = 1.2;  ///< of the viewer's time

  explicit CatchScene(Catch one) : catch_{std::move(one)} {}

  [[nodiscard]] const Catch& shown() const { return catch_; }
  [[nodiscard]] double begins_s() const { return catch_.time_s - before_s; }
  [[nodiscard]] double ends_s() const { return catch_.time_s + after_s; }
  /// Whether the moment of the catch is shown: both still live in their bodies.
  [[nodiscard]] bool is_held(double time_s) const { return time_s == catch_.time_s && held_s_ < still_s; }

  /// The moment after `elapsed_s` of the viewer's time, at most the newest.
  [[nodiscard]] double advance(double time_s, double elapsed_s, double newest_s) {
    if (time_s < catch_.time_s) return std::min({catch_.time_s, time_s + elapsed_s, newest_s});
    if (is_held(time_s)) {
      held_s_ += elapsed_s;
      return time_s;
    }
    return std::max(time_s, std::min(time_s + elapsed_s, newest_s));
  }

  /// The sentence, with the seconds that are left.
  [[nodiscard]] std::string text(double time_s) const {
    const double left_s = catch_.time_s - time_s;
    return catch_.sentence + (left_s > 0.0 ? " (in " + std::to_string(static_cast<int>(std::ceil(left_s))) + " s)" : "");
  }

 private:
  Catch catch_;
  double held_s_ = 0.0;
};

}  // namespace trophic::watch
