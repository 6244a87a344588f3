// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/pooled_runs.hpp>
#include <trophic/support/checksum.hpp>
#include <unit/reading/run_files.hpp>
#include <utility>
#include <vector>

namespace {

using namespace trophic;
using analysis::pooled_runs;
using test::manifest;
using test::message_of;
using test::TemporaryFolder;
using test::write_run;
using Paths = std::vector<std::filesystem::path>;

}  // namespace

TEST_CASE("pooled runs: runs of two builds -> refused, or pooled with a remark") {
  const TemporaryFolder folder;
  const auto run_by = [&](const char* name, int seed, const std::string& builds) {
    const std::string text = test::manifest("aa", seed);
    return write_run(folder.path() / name, text.substr(0, text.size() - 1) + ", " + builds + "}");
  };
  const auto a = run_by("a", 1, R"("code": "0aaa")");
  const auto b = run_by("b", 2, R"("code": "0bbb")");
  const auto mixed = run_by("mixed", 3, R"("code": "0aaa", "continued": [{"code": "0bbb", "other_build": "accepted"}])");
  const auto unknown = write_run(folder.path() / "unknown", test::manifest("aa", 4));
  const auto refusal = [&](const Paths& paths) {
    return message_of<std::invalid_argument>([&] { static_cast<void>(pooled_runs(paths, false)); });
  };
  CHECK(refusal({a, b}) == b.string() + ": made by 0bbb, but " + a.string() +
                               " by 0aaa; builds of a program may have other rules under the same names: --accept-other-build "
                               "pools them");
  CHECK(refusal({a, mixed}).find("made by 0aaa and 0bbb, but") != std::string::npos);
  CHECK(refusal({a, unknown}).find("made by an unknown build, but") != std::string::npos);
  CHECK(pooled_runs(Paths{a}, false).remarks.empty());
  CHECK(pooled_runs(Paths{mixed}, false).remarks.at(0).starts_with("2 builds of a program made these runs: 0aaa and 0bbb;"));
  CHECK(pooled_runs(Paths{a, b, mixed, unknown}, false, true).remarks.at(0).starts_with("2 builds of a program made these runs"));
}

TEST_CASE("pooled runs: different changes of parameters -> refused, the same, or none -> pooled") {
  const TemporaryFolder folder;
  // A run with these rows in changes.csv, without that table for none.
  using Rows = std::optional<std::vector<std::string>>;
  const auto run_with = [&](const char* name, int seed, const Rows& rows, const std::string& description = "") {
    std::string table = "time_s,tick,number,value,before\n";
    for (const std::string& row : rows.value_or(std::vector<std::string>{})) table += row + "\n";
    const std::string sum = R"("changes.csv": {"rows": )" + std::to_string(rows ? rows->size() : 0) + R"(, "crc32": )" +
                            std::to_string(checksum(table)) + "}";
    const std::string text = test::manifest("aa", seed);
    const auto run = write_run(
        folder.path() / name, text.substr(0, text.size() - 1) + R"(, "tables": {)" + (rows ? sum : "") + "}" + description + "}");
    if (rows) std::ofstream{run / "changes.csv"} << table;
    return run;
  };
  const auto plain = run_with("plain", 1, std::nullopt);
  const auto none = run_with("none", 2, Rows{std::in_place});
  const auto one = run_with("one", 3, {{"5,2,a,2,1"}});
  const auto same = run_with("same", 4, {{"5,2,a,2,1"}});
  const auto other = run_with("other", 5, {{"5,2,a,3,1"}});
  CHECK(pooled_runs(Paths{plain, none}, false).manifests.size() == 2);
  CHECK(pooled_runs(Paths{one, same}, false).manifests.size() == 2);
  // Of the rows of changes.csv, those without an effect are left out of the description.
  const auto described = [](const std::string& changes) { return R"(, "description": {"changes": [)" + changes + "]}"; };
  const std::string change = R"({"time_s": 5, "number": "rules.a", "value": "2", "before": "1"})";
  const auto halved = run_with("halved", 6, {{"5,2,a,2,1", "6,3,b,2,1"}}, described(change));
  const auto again = run_with("again", 7, {{"5,2,a,2,1"}}, described(change));
  const auto in_vain = run_with("in_vain", 8, {{"5,2,a,2,1", "6,3,b,2,1"}}, described(""));
  CHECK(pooled_runs(Paths{halved, again}, false).manifests.size() == 2);
  CHECK(pooled_runs(Paths{plain, in_vain}, false).manifests.size() == 2);
  for (const Paths& mixed : {Paths{plain, one}, Paths{one, other}, Paths{halved, in_vain}}) {
    const std::string why = message_of<std::invalid_argument>([&] { static_cast<void>(pooled_runs(mixed, false)); });
    CHECK(why.find("runs with different changes are not pooled") != std::string::npos);
  }
}

TEST_CASE("pooled runs: other rules, or one run twice -> refused") {
  const TemporaryFolder folder;
  const auto a = write_run(folder.path() / "a", manifest("aa", 1));
  const auto b = write_run(folder.path() / "b", manifest("bb", 2, "released"));
  const auto c = write_run(folder.path() / "c", manifest("aa", 1));
  const std::string mixed = message_of<std::invalid_argument>([&] { static_cast<void>(pooled_runs(Paths{a, b}, false)); });
  CHECK(mixed.starts_with(b.string() + ": fingerprint bb (released on kinematic 1), but " + a.string() + " has aa (paper"));
  CHECK(mixed.ends_with("use --compare"));
  CHECK(message_of<std::invalid_argument>([&] {
          static_cast<void>(pooled_runs(Paths{a, c}, false));
        }).find("seed 1 as in " + a.string()) != std::string::npos);
}

TEST_CASE("pooled runs: other intervals of agents.csv -> refused") {
  const TemporaryFolder folder;
  const std::string text = manifest("aa", 2);
  const auto all = write_run(folder.path() / "all", manifest("aa", 1));
  const auto thinned = write_run(folder.path() / "thinned", text.substr(0, text.size() - 1) + ", \"agents_every_ticks\": 5}");
  for (const bool is_cut : {false, true}) {
    CHECK(message_of<std::invalid_argument>([&] {
            static_cast<void>(pooled_runs(Paths{all, thinned}, is_cut));
          }) == thinned.string() + ": agents_every_ticks 5, but " + all.string() +
                    " has 1; runs that say more and less of their robots are not pooled");
  }
}

TEST_CASE("pooled runs: futures of one moment -> pooled with a remark on their common past, and with no other runs") {
  const TemporaryFolder folder;
  const auto begun = [&](const char* name, int seed, const std::string& at_s) {
    const std::string text = manifest("aa", seed);
    return write_run(folder.path() / name, text.substr(0, text.size() - 1) + R"(, "origin": {"run": "tape", "at_s": ")" + at_s +
                                               R"(", "seed": "7", "fingerprint": "aa"}})");
  };
  const auto first = begun("first", 1, "700");
  const auto second = begun("second", 2, "700");
  const auto later = begun("later", 3, "900");
  const auto other = write_run(folder.path() / "other", manifest("aa", 4));

  CHECK(pooled_runs(Paths{first}, false).remarks.empty());
  const auto set = pooled_runs(Paths{first, second}, false);
  REQUIRE(set.remarks.size() == 1);
  CHECK(set.remarks[0] ==
        "all runs begin at 700 s of tape (seed 7): they share that past, so that intervals are over its futures, not over runs");
  for (const bool is_cut : {false, true}) {
    for (const auto& [stranger, beginning] :
         {std::pair{later, "at 900 s of tape (seed 7)"}, std::pair{other, "at its beginning"}}) {
      CHECK(message_of<std::invalid_argument>([&] {
              static_cast<void>(pooled_runs(Paths{first, stranger}, is_cut));
            }) == stranger.string() + ": begins " + beginning + ", but " + first.string() +
                      " begins at 700 s of tape (seed 7); futures of one moment are not pooled with other runs");
    }
  }
}
