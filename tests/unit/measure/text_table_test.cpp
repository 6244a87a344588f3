// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <sstream>
#include <string>
#include <support/temporary_folder.hpp>
#include <trophic/measure/text_table.hpp>
#include <unit/measure/run_files.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::measure;

RunSet two_runs(const test::TemporaryFolder& folder) {
  return read_set(std::vector{test::write_run(folder.path() / "a", test::manifest("aa", 1)),
                              test::write_run(folder.path() / "b", test::manifest("aa", 2))});
}

}  // namespace

TEST_CASE("the table shows ours with its interval, the paper's value, each baseline and what is missing") {
  const test::TemporaryFolder folder;
  const RunSet set = two_runs(folder);
  const auto rows = summarize(set.runs);
  std::ostringstream out;
  print_table(out, set, rows);
  CHECK(out.str().find("attribution_caught prey                   1.000 [1.000, 1.000]          0.650\n") != std::string::npos);
  CHECK(out.str().find(
            "    * two_thirds                          0.667                                     +0.333 [+0.333, +0.333] "
            "    above\n") != std::string::npos);
  CHECK(
      out.str().find("share_alive                         1.000                                     +0.000 [+0.000, +0.000]     "
                     "not distinguishable  <-\n") != std::string::npos);
  CHECK(out.str().find("velocity prey, cm/s                       missing                       -0.67\n") != std::string::npos);
  CHECK(out.str().find("nan") == std::string::npos);
  CHECK(out.str().find("senescence") == std::string::npos);
}

TEST_CASE("the conclusions that change are said in a sentence") {
  const test::TemporaryFolder folder;
  std::ostringstream out;
  print_conclusions(out, summarize(two_runs(folder).runs));
  CHECK(out.str().find("attribution_caught prey: above two_thirds, but not distinguishable from share_alive\n") !=
        std::string::npos);
  std::ostringstream nothing;
  print_conclusions(nothing, {});
  CHECK(nothing.str().starts_with("No conclusion changes"));
}

TEST_CASE("differences of two sets") {
  const test::TemporaryFolder folder;
  const RunSet a = two_runs(folder);
  const RunSet b = read_set(std::vector{test::write_run(folder.path() / "c", test::manifest("bb", 1, "other"), "random"),
                                        test::write_run(folder.path() / "d", test::manifest("bb", 2, "other"), "random")});
  std::ostringstream out;
  print_differences(out, a, b, compare_sets(a.runs, b.runs));
  CHECK(out.str().find(
            "attribution_catches predator              1.000       0.000       -1.000 [-1.000, -1.000]       differs\n") !=
        std::string::npos);
  CHECK(out.str().find("velocity prey, cm/s                       missing     missing     missing") != std::string::npos);
}
