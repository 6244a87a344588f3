// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/reading/met_inputs.hpp>
#include <vector>

using namespace trophic;
using namespace trophic::analysis;
using test::message_of;

namespace {

/// A run whose brains have two inputs.
RunManifest with_senses(const std::filesystem::path& folder) {
  std::ofstream{folder / "senses.csv"} << "species,input0,input1\nprey,1,0.5\nprey,,\nprey,1,0.5\npredator,-1,0.25\nprey,0,1\n";
  RunManifest run;
  run.folder = folder;
  run.web = FoodWeb{{"prey", "predator"}, {{.hunter = 1, .victim = 0}}};
  return run;
}

}  // namespace

TEST_CASE("met inputs: rows of two species -> each once, by species, without ticks at which the brain was not asked") {
  const test::TemporaryFolder folder;
  const std::vector runs{with_senses(folder.path())};
  const auto met = met_inputs(runs, 24);
  REQUIRE(met.size() == 2);
  CHECK(met[0].size() == 2);
  CHECK(met[1] == std::vector<Inputs>{{-1.0, 0.25}});
  CHECK(met_inputs(runs, 1)[0].size() == 1);
  std::filesystem::remove(folder.path() / "senses.csv");
  CHECK(message_of<std::invalid_argument>([&] { static_cast<void>(met_inputs(runs, 1)); }) ==
        (folder.path() / "senses.csv").string() + ": is missing: lineage measures need it of the first run; run with --senses");
}
