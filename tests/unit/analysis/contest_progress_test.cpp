// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <optional>
#include <support/temporary_folder.hpp>
#include <tools/analysis/report/contest_progress.hpp>
#include <vector>

using namespace trophic::analysis;
using trophic::test::message_of;

namespace {

/// Contests of a run whose contact times are 100 s, less `hunters_s` and more `victims_s` of the epoch.
void add_run(std::vector<ContestRow>& rows, const std::string& run, bool shadow, const std::vector<double>& epochs_s,
             const std::vector<double>& hunters_s, const std::vector<double>& victims_s) {
  for (const std::size_t team : {0U, 1U}) {
    for (std::size_t p = 0; p < epochs_s.size(); ++p) {
      for (std::size_t q = 0; q < epochs_s.size(); ++q) {
        rows.push_back({.shadow = shadow,
                        .hunters_run = run,
                        .victims_run = run,
                        .team = team,
                        .hunter = "predator",
                        .victim = "prey",
                        .hunter_epoch_s = epochs_s[p],
                        .victim_epoch_s = epochs_s[q],
                        .contact_s = 100.0 - hunters_s[p] + victims_s[q] + (team == 0 ? 5.0 : -5.0)});
      }
    }
  }
}

const std::vector<double> epochs{0.0, 1000.0, 2000.0, 3000.0};

}  // namespace

TEST_CASE("contest matrix: progress -> mean over opponents of the change in contact time, sooner for hunters") {
  ContestMatrix matrix{2};
  CHECK_FALSE(matrix.hunters_progress(0, 1));
  matrix.add(0, 0, 100.0);
  matrix.add(0, 1, 120.0);
  matrix.add(1, 0, 90.0);
  matrix.add(1, 1, 80.0);
  matrix.add(1, 1, 90.0);  // of a second team
  CHECK(matrix.at(1, 1) == 85.0);
  CHECK(matrix.hunters_progress(0, 1) == 22.5);  // (100 - 90 + 120 - 85) / 2
  CHECK(matrix.victims_progress(0, 1) == 7.5);   // (120 - 100 + 85 - 90) / 2
  CHECK(matrix.victims_progress(1, 0) == -7.5);
}

TEST_CASE("progress: runs over their shadow -> early and late, of both roles, with Holm over the two") {
  std::vector<ContestRow> rows;
  for (int run = 0; run < 8; ++run) {
    const double noise = run - 3.5;
    add_run(rows, "run" + std::to_string(run), false, epochs, {0.0, 40.0, 50.0, 60.0 + noise}, {0.0, noise, 0.0, 0.0});
    add_run(rows, "shadow" + std::to_string(run), true, epochs, {0.0, 0.0, 0.0, 5.0 - noise}, {0.0, 0.0, 0.0, -noise});
  }
  const auto progress = progress_of(rows);
  REQUIRE(progress.size() == 4);
  const Progress& early = progress[0];
  CHECK(early.species() == "predator");
  CHECK(early.period == Period::early);
  CHECK((early.from_s == 0.0 && early.to_s == 1000.0));
  CHECK(early.ours.runs == 8);
  CHECK(early.ours.mean == doctest::Approx(40.0));
  CHECK(early.over_shadow.value == doctest::Approx(40.0));
  CHECK(progress[1].species() == "prey");
  CHECK(progress[1].ours.mean == doctest::Approx(0.0));
  CHECK_FALSE(progress[1].over_shadow.differs());
  const Progress& late = progress[2];
  CHECK(late.period == Period::late);
  CHECK((late.from_s == 1000.0 && late.to_s == 3000.0));
  CHECK(late.ours.mean == doctest::Approx(20.0));
  CHECK(late.over_shadow.value == doctest::Approx(15.0));
  CHECK(late.over_shadow.differs());
  REQUIRE(late.over_shadow.p);
  CHECK(*late.over_shadow.adjusted == doctest::Approx(2.0 * *late.over_shadow.p));
  CHECK_FALSE(progress[3].over_shadow.differs());
}

TEST_CASE("progress: partners of other replicates -> hunters' and victims' runs are each counted by their own") {
  std::vector<ContestRow> rows;
  for (const auto& [hunters, victims, contact_s] : {std::tuple{"a", "b", 100.0}, std::tuple{"b", "a", 50.0}}) {
    for (const double p : {0.0, 10.0}) {
      for (const double q : {0.0, 10.0}) {
        const double sooner_s = p > 0.0 && std::string{hunters} == "a" ? 30.0 : 0.0;
        const double later_s = q > 0.0 && std::string{victims} == "a" ? 8.0 : 0.0;
        rows.push_back({.against = Against::others,
                        .hunters_run = hunters,
                        .victims_run = victims,
                        .hunter = "predator",
                        .victim = "prey",
                        .hunter_epoch_s = p,
                        .victim_epoch_s = q,
                        .contact_s = contact_s - sooner_s + later_s});
      }
    }
  }
  const auto progress = progress_of(rows, 0.0);
  REQUIRE(progress.size() == 2);  // a split at the first epoch leaves the late period
  CHECK(progress[0].period == Period::late);
  CHECK(progress[0].ours.mean == doctest::Approx(15.0));
  CHECK(progress[1].ours.mean == doctest::Approx(4.0));
  CHECK(progress[0].shadow.runs == 0);
  CHECK_FALSE(progress[0].over_shadow.value);
}

TEST_CASE("progress: fewer than six replicates -> numbers without interval and test") {
  std::vector<ContestRow> rows;
  for (int run = 0; run < 5; ++run) {
    add_run(rows, "run" + std::to_string(run), false, epochs, {0.0, 40.0 + run, 50.0, 60.0}, {0.0, 0.0, 0.0, 0.0});
    add_run(rows, "shadow" + std::to_string(run), true, epochs, {0.0, 1.0 * run, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0});
  }
  for (const Progress& one : progress_of(rows)) {
    CHECK(one.ours.mean);
    CHECK(one.over_shadow.value);
    CHECK_FALSE(one.over_shadow.interval);
    CHECK_FALSE(one.over_shadow.adjusted);
  }
}

TEST_CASE("progress: split between epochs, or a single epoch -> error") {
  std::vector<ContestRow> rows;
  add_run(rows, "run", false, epochs, {0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0});
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(progress_of(rows, 1500.0)); }) ==
        "--split 1500: must be one of the epochs, 0, 1000, 2000, 3000 s");
  std::vector<ContestRow> one;
  add_run(one, "run", false, {0.0}, {0.0}, {0.0});
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(progress_of(one)); }) ==
        "contests of 1 epochs: must be of at least two");
  CHECK(default_split_s(epochs) == 1000.0);
  CHECK(default_split_s(std::vector{0.0, 5.0, 9.0}) == 5.0);
}
