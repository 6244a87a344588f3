// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <sstream>
#include <support/temporary_folder.hpp>
#include <tools/analysis/report/claims_text.hpp>
#include <tools/analysis/report/text_table.hpp>
#include <unit/reading/run_files.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::analysis;

/// `count` runs whose predators catch one prey each.
RunSet runs_of(const test::TemporaryFolder& folder, const std::string& name, std::size_t count,
               const std::string& hunter = "inherited") {
  std::vector<std::filesystem::path> paths;
  for (std::size_t i = 0; i < count; ++i) {
    paths.push_back(
        test::write_run(folder.path() / (name + std::to_string(i)), test::manifest(name, static_cast<int>(i)), hunter));
  }
  return read_set(paths);
}

template <class Print>
std::string printed(Print&& print) {
  std::ostringstream out;
  print(out);
  return out.str();
}

/// Whether a text has a part, however many blanks there are between its words.
bool has(const std::string& text, const std::string& part) {
  std::string squeezed;
  for (const char letter : text) {
    if (letter != ' ' || !squeezed.ends_with(' ')) squeezed += letter;
  }
  return squeezed.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("print_table: sets -> ours with its interval, the paper's value, nulls with a test, references without") {
  const test::TemporaryFolder folder;
  const ShadowedSet set{runs_of(folder, "aa", 6), runs_of(folder, "bb", 6, "random")};
  const auto rows = summarize(set.ours.runs, set.shadow_runs());
  const std::string text = printed([&](auto& out) { print_table(out, set, rows); });
  CHECK(has(text, "shadow: paper on kinematic 1, 6 runs of 6000 s\n"));
  CHECK(has(text, "attribution_caught prey 1.000 [1.000, 1.000] 0.650\n"));
  CHECK(has(text, " = shadow 1.000 +0.000 [+0.000, +0.000]\n"));
  CHECK(has(text, " * two_thirds 0.667\n"));
  CHECK(has(text, " = shadow 0.000 +1.000 [+1.000, +1.000] <0.001 above\n"));
  CHECK(has(text, "velocity_stored prey, cm/s missing -0.67 same as velocity prey, cm/s\n"));
  CHECK_FALSE(has(text, "nan"));
  CHECK_FALSE(has(text, "senescence"));
  CHECK_FALSE(has(text, "too few"));
}

TEST_CASE("print_findings: sets with a shadow -> what is significant, with effect, interval and runs, and no other metric") {
  const test::TemporaryFolder folder;
  const ShadowedSet set{runs_of(folder, "aa", 6), runs_of(folder, "bb", 6, "random")};
  const std::string text = printed([&](auto& out) { print_findings(out, set, summarize(set.ours.runs, set.shadow_runs())); });
  CHECK(has(text, "comparisons are significant (p <= 0.05, corrected for all of them: Holm)\n"));
  CHECK(has(text, " attribution_catches predator 1.000 [1.000, 1.000] shadow 0.000 6+6 +1.000 [+1.000, +1.000] <0.001\n"));
  CHECK_FALSE(has(text, "attribution_caught prey"));
  const ShadowedSet alone{set.ours, {}};
  const auto rows = summarize(alone.ours.runs);
  CHECK(printed([&](auto& out) { print_findings(out, alone, rows); }) ==
        printed([&](auto& out) { print_table(out, alone, rows); }));
}

TEST_CASE("print_table: one run, two or five -> numbers, no test, and a sentence that says so") {
  for (const std::size_t count : {1UL, 2UL, 5UL}) {
    const test::TemporaryFolder folder;
    const ShadowedSet set{runs_of(folder, "aa", count), {}};
    const std::string text = printed([&](auto& out) { print_table(out, set, summarize(set.ours.runs)); });
    CHECK(has(text, "too few runs for a test: 6 are needed, paper has " + std::to_string(count) + "\n"));
    CHECK(has(text, "no shadow: attribution and velocity have no null"));
    CHECK(has(text, count == 1 ? "attribution_caught prey 1.000 " : "1.000 (sd 0.000)"));
    for (const char* word : {"above", "below", "inconclusive"}) CHECK_FALSE(has(text, word));
    const std::string claims = printed([&](auto& out) { print_claims(out, set.ours, judge_claims(set.ours.runs)); });
    CHECK(has(claims, "no conclusion\n"));
    CHECK(has(claims, "too few runs for a test: 6 are needed"));
    CHECK_FALSE(has(claims, "  reproduced\n"));
    for (const auto& print : {print_differences, print_difference_findings}) {
      const std::string compared = printed([&](auto& out) { print(out, set, set, compare_sets(set, set)); });
      CHECK(has(compared, "too few runs for a test: 6 are needed"));
      CHECK_FALSE(has(compared, "*\n"));
    }
  }
}

TEST_CASE("print_differences: two sets -> raw, over the shadows if both have one, with corrected p values") {
  const test::TemporaryFolder folder;
  ShadowedSet a{runs_of(folder, "aa", 6), {}};
  ShadowedSet b{runs_of(folder, "bb", 6, "random"), {}};
  const std::string raw = printed([&](auto& out) { print_differences(out, a, b, compare_sets(a, b)); });
  CHECK(has(raw, "attribution_catches predator 1.000 0.000 -1.000 [-1.000, -1.000] <0.001 *\n"));
  CHECK(has(raw, "velocity prey, cm/s missing missing missing"));
  const std::string unattributed = "without a shadow of each set no difference can be attributed to inheritance";
  CHECK(has(raw, unattributed));
  CHECK(has(printed([&](auto& out) { print_difference_findings(out, a, b, compare_sets(a, b)); }), unattributed));
  a.shadow = runs_of(folder, "cc", 6);
  b.shadow = runs_of(folder, "dd", 6, "random");
  const auto differences = compare_sets(a, b);
  const std::string over = printed([&](auto& out) { print_differences(out, a, b, differences); });
  CHECK(has(over, "over shadows: (b - shadow) - (a - shadow) [95 %] p"));
  CHECK(has(over, "-1.000 [-1.000, -1.000] <0.001 * +0.000 [+0.000, +0.000]"));
  const std::string findings = printed([&](auto& out) { print_difference_findings(out, a, b, differences); });
  CHECK(has(findings, "the answer is the difference over shadows"));
  CHECK(has(findings, "0 of 0 comparisons are significant"));
}
