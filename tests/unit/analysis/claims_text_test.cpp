// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <sstream>
#include <support/temporary_folder.hpp>
#include <tools/analysis/report/claims_text.hpp>
#include <unit/reading/run_files.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

TEST_CASE("print_claims: runs -> a summary for each claim, and for each reading value, margin, origin, ours, conclusion") {
  const test::TemporaryFolder folder;
  std::vector<std::filesystem::path> paths;
  for (int run = 0; run < 6; ++run) {
    paths.push_back(test::write_run(folder.path() / std::to_string(run), test::manifest("aa", run), "inherited"));
  }
  const RunSet set = read_set(paths);
  std::ostringstream out;
  print_claims(out, set, judge_claims(set.runs));
  std::string text;
  for (const char letter : out.str()) {
    if (letter != ' ' || !text.ends_with(' ')) text += letter;
  }
  const auto has = [](const std::string& whole, const std::string& part) { return whole.find(part) != std::string::npos; };
  CHECK(has(text, "these are points without bodies, so velocities and walls compare the rules only\n"));
  CHECK(has(text, "\nattribution of prey: not reproduced under any reading\n"));
  CHECK(has(
      text,
      "\n attribution_caught prey 0.650 text 0.037 authors' logs 1.000 [1.000, 1.000] +0.350 [+0.324, +0.376] not reproduced\n"));
  CHECK(has(text, "\n attribution_died prey 0.620 logs 0.028 authors' logs "));
  CHECK(has(text, "\nvelocity of predators: no conclusion under any reading\n"));
  CHECK(has(text, "\n velocity_points predator (inherited), cm/s 1.95 text 0.21 our runs, another reading missing "));
  CHECK(has(text, "Leaving them out (active) is an inference"));
}
