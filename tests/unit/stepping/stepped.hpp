// SPDX-License-Identifier: MIT
// A run that is decided from outside by the table's own brains, compared with one that is not.
#pragma once

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <support/temporary_folder.hpp>
#include <trophic/ecology/stepped_run.hpp>
#include <trophic/io/run_folder.hpp>

namespace trophic::test {

/// Every table of a run in a folder, with their names, and the ecology's state at its end.
[[nodiscard]] inline std::vector<std::pair<std::string, std::string>> bytes_of(const std::filesystem::path& folder,
                                                                               Simulation& ecology) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& file : std::filesystem::directory_iterator{folder}) {
    if (file.path().extension() != ".csv") continue;  // manifest and recording name the rules, and so who decided
    std::ifstream content{file.path(), std::ios::binary};
    all.emplace_back(file.path().filename().string(), std::string{std::istreambuf_iterator<char>{content}, {}});
  }
  std::ranges::sort(all);
  Archive archive;
  ecology.persist(archive);
  all.emplace_back("state", archive.bytes());
  return all;
}

constexpr io::OutputOptions everything{.senses = true, .states = true};

/// Runs `make()` twice, once decided by its own brains from outside. Both leave the same bytes. Returns the number of times that
/// the second stopped for decisions.
template <class Make>
std::size_t check_same_bytes(const Make& make, double until_s) {
  const TemporaryFolder temporary;
  const auto ordinary = make();
  io::RunFolder whole{temporary.path() / "whole", {}, everything, Opening::created, ordinary->state_columns()};
  ordinary->run_until(until_s, whole);

  const auto stepped = make();
  io::RunFolder steps{temporary.path() / "steps", {}, everything, Opening::created, stepped->state_columns()};
  SteppedRun run{*stepped, until_s, steps};
  std::size_t stops = 0;
  for (; run.sense(); ++stops) {
    const Perceived& now = run.perceived();
    REQUIRE(!now.bodies.empty());
    REQUIRE(now.inputs.size() == now.bodies.size() * now.inputs_each);
    run.decide(run.own_outputs());
  }
  CHECK_FALSE(run.sense());  // it has ended

  const auto there = bytes_of(whole.path(), *ordinary);
  const auto here = bytes_of(steps.path(), *stepped);
  REQUIRE(there.size() == here.size());
  CHECK(there.size() >= 7);
  for (std::size_t i = 0; i < there.size(); ++i) {
    CAPTURE(there[i].first);
    CHECK(there[i].first == here[i].first);
    const bool same = there[i].second == here[i].second;
    CHECK(same);
    CHECK(there[i].second.size() > 10);
  }
  return stops;
}

}  // namespace trophic::test
