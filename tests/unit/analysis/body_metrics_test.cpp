// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <support/temporary_folder.hpp>
#include <tools/analysis/metrics/body_metrics.hpp>
#include <tools/analysis/metrics/sweep_values.hpp>
#include <unit/reading/run_files.hpp>
#include <utility>

namespace {

using namespace trophic::analysis;
namespace test = trophic::test;

const std::string bodies_header =
    "id,time_s,species,plan,parent_plan,edit_distance,modules_text,modules,hinges,bricks,mass_kg,reach_m,size,proportion,"
    "coverage,"
    "branching,limbs,length_of_limbs,symmetry,joints\n";

std::string born(double time_s, int id, const std::string& species, int body) {
  return std::to_string(time_s) + "," + std::to_string(static_cast<int>(time_s / 2.0)) + ",birth," + std::to_string(id) + "," +
         species + "," + std::to_string(body) + ",1,1,random,,0,,,,1,2\n";
}

std::string row_of_body(int id, const std::string& text, int modules, double symmetry) {
  return std::to_string(id) + ",0,prey,0,,," + text + "," + std::to_string(modules) + ",1,1,0.5,0.2,0.1,1,1,0,1,0," +
         std::to_string(symmetry) + ",0\n";
}

/// 40 s with two prey of one plan; at 10 s the second is followed by one with a module more.
std::filesystem::path write_bodies(const std::filesystem::path& folder) {
  std::string text = test::manifest("a", 1);
  text.replace(text.find("6000"), 4, "40");
  std::filesystem::create_directories(folder);
  std::ofstream{folder / "manifest.json"} << text;
  std::ofstream{folder / "events.csv"} << test::event_header << born(0, 0, "prey", 0) << born(0, 1, "prey", 1)
                                       << "10,5,death,1,prey,1,1,1,random,,0,starved,,,1,2\n"
                                       << born(10, 3, "prey", 1);
  std::ofstream{folder / "agents.csv"} << test::agent_header << "0,0,0,0,prey,random,1,1,1,2,0,0.7,,,\n"
                                       << "2,1,0,0,prey,random,1,1,1.1,2,0,0.7,,,\n"
                                       << "4,2,0,0,prey,random,1,1,1.1,2.3,0,0.7,,,\n";
  std::ofstream{folder / "bodies.csv"} << bodies_header << row_of_body(0, "core[left:hinge0]", 2, 0.0)
                                       << row_of_body(1, "core[left:hinge0]", 2, 0.0)
                                       << row_of_body(3, "core[left:hinge0 right:hinge0]", 3, 1.0);
  std::ofstream{folder / "genes.csv"} << "id,part,index,value\n0,brain,0,1\n0,brain,1,1\n0,gait,0,1\n1,brain,0,1\n1,brain,1,1\n"
                                      << "3,brain,0,1\n3,brain,1,1\n3,brain,2,1\n3,brain,3,1\n";
  return folder;
}

double half_mean(const RunMetrics& metrics, const std::string& metric, const std::string& group) {
  const auto found = std::ranges::find_if(metrics.measurements, [&](const Measurement& each) {
    return each.name.metric == metric && each.name.species == "prey" && each.name.group == group;
  });
  REQUIRE(found != metrics.measurements.end());
  REQUIRE(found->value);
  return *found->value;
}

}  // namespace

TEST_CASE("measure_bodies: plans, shapes, genes and ways -> means over the living in the windows of each half") {
  const test::TemporaryFolder folder;
  const RunMetrics found = measure_bodies(read_run(write_bodies(folder.path() / "run")));
  const struct {
    const char* metric;
    double early;
    double late;
  } expected[]{
      // Four of ten early windows of 2 s end before the death.
      {"body_modules", 2.3, 2.5}, {"body_symmetry", 0.3, 0.5}, {"body_plans", 1.6, 2.0}, {"body_plans_shannon", 1.6, 2.0},
      {"body_change", 0.3, 0.5},  {"brain_genes", 2.6, 3.0},   {"gait_genes", 0.5, 0.5},
  };
  for (const auto& [metric, early, late] : expected) {
    CAPTURE(metric);
    CHECK(half_mean(found, metric, "early") == doctest::Approx(early));
    CHECK(half_mean(found, metric, "late") == doctest::Approx(late));
  }
  CHECK(half_mean(found, "walked", "early") == doctest::Approx(0.1));  // 0.1 m and 0.3 m in 2 s each
  const auto curve =
      std::ranges::find(found.curves, std::string{"body_plans"}, [](const Curve& each) { return each.name.metric; });
  REQUIRE(curve != found.curves.end());
  CHECK(curve->points.size() == 20);
  CHECK(*curve->points[3].value == 1.0);
  CHECK(*curve->points[4].value == 2.0);
}

TEST_CASE("measure_bodies: a species without individuals, or only genes -> no value") {
  const test::TemporaryFolder folder;
  const auto path = write_bodies(folder.path() / "run");
  std::filesystem::remove(path / "bodies.csv");
  const RunMetrics found = measure_bodies(read_run(path));
  CHECK(half_mean(found, "brain_genes", "late") == 3.0);
  for (const Measurement& each : found.measurements) {
    if (each.name.metric.starts_with("body_") || each.name.species == "predator") CHECK_FALSE(each.value);
  }
}

TEST_CASE("measure_bodies: missing tables, bad plans and bad cells -> one sentence that names the file") {
  const test::TemporaryFolder folder;
  CHECK_THROWS_WITH_AS(
      static_cast<void>(measure_bodies(read_run(test::write_run(folder.path() / "none", test::manifest("a", 1))))),
      doctest::Contains("has neither bodies.csv nor genes.csv"), std::invalid_argument);
  for (const auto& [row, sentence] :
       {std::pair{"core[left", "bodies.csv: id 0: body plan \"core[left"}, {"core", "modules = \"many\": must be a number"}}) {
    CAPTURE(row);
    const auto path = write_bodies(folder.path() / std::to_string(std::string_view{row}.size()));
    std::string cells = row_of_body(0, row, 2, 0.0);
    if (std::string{row} == "core") cells.replace(cells.find(",2,"), 3, ",many,");
    std::ofstream{path / "bodies.csv"} << bodies_header << cells;
    CHECK_THROWS_WITH_AS(static_cast<void>(measure_bodies(read_run(path))), doctest::Contains(sentence), std::invalid_argument);
  }
}

TEST_CASE("metric names: of bodies -> those that measure_bodies gives, early and late") {
  const trophic::FoodWeb web{{"prey", "predator"}, {{1, 0}}};
  const auto names = metric_names({&web, 1}, true);
  CHECK(names.size() == 2 * 2 * 17);
  CHECK(std::ranges::find(names, MetricName{"body_limbs", "predator", "late", "1"}) != names.end());
}
