// SPDX-License-Identifier: MIT
// Counts of births and deaths.
#pragma once

#include <numeric>
#include <trophic/observe/event.hpp>
#include <trophic/population/view.hpp>

namespace trophic::observe {

/// Counts so far. Founders count as births.
class Tally {
 public:
  void on_event(const Event& event, const View&) {
    if (event.kind == EventKind::birth) ++births_.at(static_cast<std::size_t>(event.individual.origin));
    if (event.kind == EventKind::death && event.cause) ++deaths_.at(static_cast<std::size_t>(*event.cause));
  }

  [[nodiscard]] std::size_t births() const { return births_[0] + births_[1]; }
  [[nodiscard]] std::size_t births(Origin origin) const { return births_.at(static_cast<std::size_t>(origin)); }
  [[nodiscard]] std::size_t deaths() const { return std::accumulate(deaths_.begin(), deaths_.end(), std::size_t{0}); }
  [[nodiscard]] std::size_t deaths(Cause cause) const { return deaths_.at(static_cast<std::size_t>(cause)); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(births_, deaths_);
  }

 private:
  std::array<std::size_t, enum_names(Origin{}).size()> births_{};
  std::array<std::size_t, enum_names(Cause{}).size()> deaths_{};
};

}  // namespace trophic::observe
