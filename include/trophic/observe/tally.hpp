// SPDX-License-Identifier: MIT
// Counts of births and deaths, and when species died out.
#pragma once

#include <trophic/observe/event.hpp>
#include <trophic/population/view.hpp>

namespace trophic::observe {

/// The extinct species of a run that is over, "gone: prey, predator", or "no spare body"; else empty.
[[nodiscard]] inline std::string end_text(const View& view) {
  std::string text;
  for (Species species = 0; view.is_over && species < view.web.size(); ++species) {
    if (view.count(species) == 0) text.append(text.empty() ? "gone: " : ", ").append(view.web.name(species));
  }
  return view.is_over && text.empty() ? "no spare body" : text;
}

/// Counts so far. Founders count as births.
class Tally {
 public:
  void on_event(const Event& event, const View&) {
    if (event.kind == EventKind::birth) ++births_.at(static_cast<std::size_t>(event.individual.origin));
    if (event.kind == EventKind::death && event.cause) ++count_of(*event.cause);
  }
  void on_tick(const View& view) {
    gone_s_.resize(view.web.size(), -1.0);
    for (Species species = 0; species < view.web.size(); ++species) {
      if (view.count(species) > 0) gone_s_[species] = -1.0;
      if (view.count(species) == 0 && gone_s_[species] < 0.0) gone_s_[species] = view.time_s;
    }
  }

  [[nodiscard]] std::size_t births() const { return births_[0] + births_[1]; }
  [[nodiscard]] std::size_t births(Origin origin) const { return births_.at(static_cast<std::size_t>(origin)); }
  [[nodiscard]] std::size_t deaths() const {
    std::size_t sum = 0;
    for (const auto& [cause, deaths] : deaths_) sum += deaths;
    return sum;
  }
  /// (name of the cause, deaths), the library's causes first; `diverged` only if there was any.
  [[nodiscard]] std::vector<std::pair<std::string, std::size_t>> deaths_by_cause() const {
    auto all = deaths_;
    std::erase_if(all, [](const auto& one) { return one.first == enum_name(Cause::diverged) && one.second == 0; });
    return all;
  }
  [[nodiscard]] std::size_t deaths(Cause cause) const {
    const auto found = std::ranges::find(deaths_, enum_name(cause), &std::pair<std::string, std::size_t>::first);
    return found == deaths_.end() ? 0 : found->second;
  }

  /// The time at which each species died out; negative for one that lives.
  [[nodiscard]] const std::vector<double>& gone_s() const { return gone_s_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(births_, deaths_, gone_s_);
  }

 private:
  [[nodiscard]] std::size_t& count_of(Cause cause) {
    auto found = std::ranges::find(deaths_, enum_name(cause), &std::pair<std::string, std::size_t>::first);
    if (found == deaths_.end()) found = deaths_.emplace(deaths_.end(), enum_name(cause), 0);
    return found->second;
  }

  std::array<std::size_t, enum_names(Origin{}).size()> births_{};
  std::vector<std::pair<std::string, std::size_t>> deaths_ = [] {
    std::vector<std::pair<std::string, std::size_t>> all;
    for (const std::string_view cause : enum_names(Cause{})) all.emplace_back(cause, 0);
    return all;
  }();
  std::vector<double> gone_s_;
};

}  // namespace trophic::observe
