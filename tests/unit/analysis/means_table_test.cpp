// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/analysis/report/means_table.hpp>
#include <trophic/support/whole_file.hpp>
#include <unit/reading/run_files.hpp>
#include <vector>

namespace {

using namespace trophic;
using namespace trophic::analysis;

RunSet runs_of(const test::TemporaryFolder& folder, const std::string& name, const std::string& hunter) {
  std::vector<std::filesystem::path> paths;
  for (int i = 0; i < 6; ++i)
    paths.push_back(test::write_run(folder.path() / (name + std::to_string(i)), test::manifest(name, i), hunter));
  return read_set(paths);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("means.csv: each metric with its null, difference, p and runs") {
  const test::TemporaryFolder folder;
  const ShadowedSet set{runs_of(folder, "aa", "inherited"), runs_of(folder, "bb", "random")};
  const std::vector<SummarizedSet> sets{{&set, summarize(set.ours.runs, set.shadow_runs())}};
  write_means(folder.path() / "means.csv", sets);
  const std::string text = read_whole_file(folder.path() / "means.csv");
  CHECK(
      text.starts_with("set,metric,species,group,unit,n,mean,deviation,lower,upper,published,null,null_n,null_mean,difference,"));
  CHECK(has(text, "\npaper,attribution_catches,predator,all,1,6,1,0,1,1,,shadow,6,0,1,1,1,0,0,,\n"));
  CHECK(has(text, "\npaper,velocity_stored,prey,all,m/s,0,,,,,-0.0067,shadow,0,,,,,,,,velocity:prey:all\n"));
  const std::string tex = means_tex(sets[0]);
  CHECK(has(tex,
            "attribution\\_\\allowbreak{}catches predator & $1.000\\ [1.000,\\ 1.000]$ & $0.000$ & "
            "$+1.000\\ [+1.000,\\ +1.000]$ & $<0.001$ & $6{+}6$ \\\\\n"));
  CHECK_FALSE(has(tex, "velocity"));
}

TEST_CASE("differences.csv: two sets -> raw and over the shadows, the LaTeX table with the answer alone") {
  const test::TemporaryFolder folder;
  const ShadowedSet a{runs_of(folder, "aa", "inherited"), runs_of(folder, "bb", "random")};
  const ShadowedSet b{runs_of(folder, "cc", "random"), runs_of(folder, "dd", "random")};
  const auto differences = compare_sets(a, b);
  write_differences(folder.path() / "differences.csv", differences);
  const std::string text = read_whole_file(folder.path() / "differences.csv");
  CHECK(has(text,
            "\nattribution_catches,predator,all,1,over_shadow,6,6,1,0,-1,-1,-1,0,0,,\n"
            "attribution_catches,predator,all,1,raw,6,6,1,0,-1,-1,-1,0,0,,\n"));
  CHECK(has(differences_tex(a, b, differences), "over shadows [95\\,\\%]"));
  CHECK(has(differences_tex({a.ours, {}}, b, compare_sets({a.ours, {}}, b)), "& difference [95\\,\\%]"));
}
