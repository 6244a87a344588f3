// SPDX-License-Identifier: MIT
// A row of contests.csv.
#pragma once

#include <array>
#include <trophic/io/column.hpp>

namespace trophic::contest {

/// Origin of the opponents in a contest: the same run, another replicate, which they never met, or a panel that all runs meet.
enum class Against { own, others, panel_victims, panel_hunters };
[[nodiscard]] constexpr std::array<std::string_view, 4> enum_names(Against) {
  return {"own", "others", "panel_victims", "panel_hunters"};
}

/// contests.csv: one row per contest of a team of hunters and a team of victims.
struct ContestRow {
  bool shadow = false;
  Against against = Against::own;
  std::string hunters_run = {};
  std::string victims_run = {};
  std::size_t team = 0;
  std::string hunter = {};
  std::string victim = {};
  double hunter_epoch_s = 0.0;
  double victim_epoch_s = 0.0;
  double contact_s = 0.0;
  double contacted = 0.0;

  static constexpr auto columns() {
    using io::column;
    return std::tuple{column("shadow", &ContestRow::shadow, "", "whether both teams are from the neutral shadow"),
                      column("against", &ContestRow::against, "",
                             "own: both teams are from one run; others: from two replicates; panel_victims or panel_hunters: "
                             "these are the panel's"),
                      column("hunters_run", &ContestRow::hunters_run, "", "folder of the run of the hunters"),
                      column("victims_run", &ContestRow::victims_run, "", "folder of the run of the victims"),
                      column("team", &ContestRow::team, "", "number of both teams, from 0"),
                      column("hunter", &ContestRow::hunter, "", "species of the hunters"),
                      column("victim", &ContestRow::victim, "", "species of the victims"),
                      column("hunter_epoch_s", &ContestRow::hunter_epoch_s, "s", "time of the run at which the hunters lived"),
                      column("victim_epoch_s", &ContestRow::victim_epoch_s, "s", "time of the run at which the victims lived"),
                      column("contact_s", &ContestRow::contact_s, "s",
                             "mean over victims of the time until a hunter is within reach, at most the contest's length"),
                      column("contacted", &ContestRow::contacted, "1", "share of the victims that a hunter reached")};
  }
};

}  // namespace trophic::contest
