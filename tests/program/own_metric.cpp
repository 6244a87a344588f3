// SPDX-License-Identifier: MIT
// A user's program with metrics of its own, as docs/how-to/my-metric.md has it; the variable METRIC asks for one that goes wrong.
#include <cmath>
#include <cstdlib>
#include <trophic/experiment.hpp>
#include <trophic/rules/paper.hpp>

namespace {

using trophic::io::OwnMetric;
using trophic::io::RunTables;
using trophic::io::Sample;

std::vector<Sample> from_centre(const RunTables& run) {
  std::vector<Sample> samples;
  for (const auto& robot : run.agents) {
    samples.push_back({.value = std::hypot(robot.x_m, robot.y_m), .time_s = robot.time_s, .species = robot.species});
  }
  return samples;
}

/// Goes wrong in the replicate 01.
std::vector<Sample> odd(const RunTables& run) {
  const std::string how = std::getenv("METRIC");
  if (run.folder.filename() != "replicate-01") return {{.value = 1.0}};
  if (how == "throws") throw std::runtime_error{"no robot is there"};
  if (how == "throws_a_number") throw 3;
  if (how == "nan") return {{.value = std::nan("")}};
  if (how == "infinity") return {{.value = std::numeric_limits<double>::infinity()}};
  if (how == "time") return {{.value = 1.0, .time_s = 1e300}};
  if (how == "species") return {{.value = 1.0, .species = trophic::Species{7}}};
  if (how == "group") return {{.value = 1.0, .group = "a,b"}};
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<OwnMetric> metrics{{.name = "from_centre", .unit = "m", .samples = from_centre}};
  const char* how = std::getenv("METRIC");
  if (how != nullptr) {
    const std::string name = how;
    metrics.push_back({.name = name == "taken"     ? "hunger"
                               : name == "twice"   ? "from_centre"
                               : name == "no_word" ? "a:b"
                                                   : "odd",
                       .unit = name == "no_unit" ? "" : "1",
                       .samples = odd});
    if (name == "no_function") metrics.back().samples = {};
  }
  return trophic::experiment<trophic::rules::Paper>(argc, argv, {.metrics = metrics});
}
