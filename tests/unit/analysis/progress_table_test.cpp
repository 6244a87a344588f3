// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <sstream>
#include <support/temporary_folder.hpp>
#include <tools/analysis/report/progress_table.hpp>
#include <trophic/support/whole_file.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;

namespace {

Progress late_hunters(std::size_t runs) {
  Progress one{.against = Against::others,
               .hunter = "predator",
               .victim = "prey",
               .of_hunters = true,
               .period = Period::late,
               .from_s = 2000.0,
               .to_s = 6000.0};
  one.ours = {.runs = runs, .mean = 12.0, .deviation = 3.0, .interval = {}};
  one.shadow = {.runs = runs, .mean = 2.0, .deviation = 3.0, .interval = {}};
  one.over_shadow.value = 10.0;
  if (runs >= 6) {
    one.over_shadow.interval = Interval{4.0, 16.0};
    one.over_shadow.p = 0.001;
    one.over_shadow.adjusted = 0.002;
  }
  return one;
}

std::string printed(const Progress& one) {
  std::ostringstream text;
  print_progress(text, std::vector{one});
  return text.str();
}

}  // namespace

TEST_CASE("progress table: six replicates -> interval, p and conclusion, fewer -> numbers and no conclusion") {
  const std::string six = printed(late_hunters(6));
  CHECK(six.find("predator") != std::string::npos);
  CHECK(six.find("others' prey") != std::string::npos);
  CHECK(six.find("+10.0 [+4.0, +16.0]") != std::string::npos);
  CHECK(six.find("above the shadow") != std::string::npos);
  const std::string five = printed(late_hunters(5));
  CHECK(five.find("not tested") != std::string::npos);
  CHECK(five.find("5 replicates: no intervals and no conclusions; a test needs 6") != std::string::npos);
  Progress alone = late_hunters(6);
  alone.shadow = {};
  alone.over_shadow = {};
  CHECK(printed(alone).find("no shadow") != std::string::npos);
}

TEST_CASE("progress table: files -> a row for each, empty cells for what is missing") {
  const test::TemporaryFolder folder;
  write_progress(folder.path() / "progress.csv", std::vector{late_hunters(5)});
  const std::string text = read_whole_file(folder.path() / "progress.csv");
  CHECK(text.find("against,species,role,opponent,period,from_s,to_s,runs,mean_s,") == 0);
  CHECK(text.find("\nothers,predator,hunter,prey,late,2000,6000,5,12,,,5,2,10,,,,\n") != std::string::npos);
  write_contests(folder.path() / "contests.csv", std::vector{ContestRow{.shadow = true, .hunters_run = "a", .contact_s = 7.5}});
  CHECK(read_whole_file(folder.path() / "contests.csv").find("\n1,own,a,,0,,,0,0,7.5,0\n") != std::string::npos);
}
