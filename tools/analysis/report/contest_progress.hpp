// SPDX-License-Identifier: MIT
// Progress across generations: contests of hunters of one epoch against victims of another, and what they add up to.
#pragma once

#include <array>
#include <span>
#include <tools/analysis/statistics/difference.hpp>
#include <tools/analysis/statistics/estimate.hpp>
#include <trophic/io/column.hpp>

namespace trophic::analysis {

/// Origin of the opponents in a contest: the same run, or another replicate, which they never met.
enum class Against { own, others };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Against) {
  return {"own", "others"};
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
    return std::tuple{
        column("shadow", &ContestRow::shadow, "", "whether both teams are from the neutral shadow"),
        column("against", &ContestRow::against, "", "own: both teams are from one run; others: from two replicates"),
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

/// The mean contact time of each pair of epochs in one replicate.
class ContestMatrix {
 public:
  explicit ContestMatrix(std::size_t epochs) : epochs_{epochs}, sums_(epochs * epochs), counts_(epochs * epochs) {}

  void add(std::size_t hunter_epoch, std::size_t victim_epoch, double contact_s);
  [[nodiscard]] std::optional<double> at(std::size_t hunter_epoch, std::size_t victim_epoch) const;

  /// Mean over the victims of all epochs of how much sooner hunters of `later` reach them than hunters of `earlier`. Empty if a
  /// contest is missing.
  [[nodiscard]] std::optional<double> hunters_progress(std::size_t earlier, std::size_t later) const;
  /// Mean over the hunters of all epochs of how much later they reach victims of `later` than victims of `earlier`.
  [[nodiscard]] std::optional<double> victims_progress(std::size_t earlier, std::size_t later) const;

 private:
  std::size_t epochs_;
  std::vector<double> sums_;
  std::vector<std::size_t> counts_;
};

/// A stretch of a run, by its place among the epochs.
enum class Period { early, late };
[[nodiscard]] constexpr std::array<std::string_view, 2> enum_names(Period) {
  return {"early", "late"};
}

/// Progress of a species against opponents of all epochs, over a period, in seconds of contact time: greater is better for both
/// roles. The tests over the two roles of one link, period and kind of opponents are corrected together (Holm).
struct Progress {
  Against against = Against::own;
  std::string hunter = {};
  std::string victim = {};
  bool of_hunters = true;
  Period period = Period::early;
  double from_s = 0.0;
  double to_s = 0.0;
  Estimate ours = {};
  Estimate shadow = {};
  Difference over_shadow = {};  ///< empty without a shadow, and with fewer runs than a test needs
  [[nodiscard]] const std::string& species() const { return of_hunters ? hunter : victim; }
};

/// The epoch that ends the early period and begins the late one: that in the middle, of an even number the earlier one.
[[nodiscard]] double default_split_s(std::span<const double> epochs_s);

/// The progress that contests show, early from the first epoch to `split_s`, late from there to the last. Throws
/// std::invalid_argument unless there are two epochs and `split_s` is one of them; a split at an end leaves one period.
[[nodiscard]] std::vector<Progress> progress_of(std::span<const ContestRow> contests, std::optional<double> split_s = {});

/// The epochs of contests, ascending.
[[nodiscard]] std::vector<double> epochs_of(std::span<const ContestRow> contests);

}  // namespace trophic::analysis
