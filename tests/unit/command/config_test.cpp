// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <tools/command/config.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/rules/paper.hpp>

namespace {

using namespace trophic;
using namespace trophic::command;
using Numbers = Experiment<rules::Paper>;

Config config_of(const std::string& text, std::vector<std::string> assignments = {}) {
  const test::TemporaryFolder folder;
  Config config = read_config(folder.file("numbers.toml", text), std::move(assignments));
  config.file = "numbers.toml";
  return config;
}

std::string message(const Config& config) {
  return test::message_of<std::invalid_argument>([&] {
    Numbers numbers;
    apply_config(param_refs(numbers), config);
  });
}

TEST_CASE("the file comes first, then each assignment in turn") {
  Numbers numbers;
  apply_config(param_refs(numbers),
               config_of("engine = 'kinematic'\nseed = 3\n[ecology]\nrobots = 20\n", {"ecology.robots=22", "ecology.robots=24"}));
  CHECK(numbers.seed == 3);
  CHECK(numbers.ecology.robots == 24);
}

TEST_CASE("an unknown key names its file and what was meant") {
  CHECK(message(config_of("[rules.mutation]\nsdd = 1\n")) ==
        "numbers.toml: rules.mutation.sdd: unknown key; did you mean rules.mutation.sd?");
  CHECK(message(config_of("", {"mutation.sd=1"})) == "--set mutation.sd: unknown key; did you mean rules.mutation.sd?");
  CHECK(message(config_of("", {"sead=1"})) == "--set sead: unknown key; did you mean seed?");
  CHECK(message(config_of("seed = 'x'\n")).starts_with("numbers.toml: seed = "));
}

TEST_CASE("a key that is near to nothing lists what there is") {
  CHECK(message(config_of("", {"rules.mutation.colour=1"})) == "rules.mutation.colour: unknown key; known here: sd");
}

TEST_CASE("a path without its beginning is known where it is the end of one number alone") {
  const ParamRefs named_params{{.path = "a.x.sd"}, {.path = "b.x.sd"}, {.path = "b.y.range_m"}};
  CHECK(nearest_path("y.range_m", named_params) == "b.y.range_m");
  CHECK(nearest_path("range_m", named_params) == "b.y.range_m");
  CHECK(nearest_path("sd", named_params) == std::nullopt);
  CHECK(nearest_path("", named_params) == std::nullopt);
  CHECK(nearest_path(".", named_params) == std::nullopt);
  CHECK(nearest_path("b.y.rang_m", named_params) == "b.y.range_m");
  CHECK(nearest_path("b.y.colour", named_params) == std::nullopt);
}

TEST_CASE("a file of another backend or table is refused only for the numbers that it has of it") {
  const Config full = config_of("engine = 'mujoco'\nrule_table = 'paper'\n[backend]\nthreads = 2\n[rules.mutation]\nsd = 0.1\n");
  CHECK_NOTHROW(check_made_for(full, "paper", "mujoco"));
  CHECK(test::message_of<std::invalid_argument>([&] { check_made_for(full, "paper", "kinematic"); }) ==
        "numbers.toml: is for engine = \"mujoco\", whose parameters are in [backend], not for kinematic; use --backend mujoco, "
        "or a file without engine and [backend]");
  CHECK(test::message_of<std::invalid_argument>([&] {
          check_made_for(full, "released", "mujoco");
        }).find("rule_table = \"paper\"") != std::string::npos);
  const Config world = config_of("engine = 'mujoco'\nrule_table = 'paper'\n[ecology]\nrobots = 20\n");
  CHECK_NOTHROW(check_made_for(world, "released", "kinematic"));
  CHECK_NOTHROW(check_made_for(config_of("[backend]\nthreads = 2\n"), "paper", "kinematic"));
}

}  // namespace
