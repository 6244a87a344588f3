// SPDX-License-Identifier: MIT
// Three hand-written robots for observers to be told of, and the text of what they wrote.
#pragma once

#include <iterator>
#include <support/hand_population.hpp>
#include <support/temporary_folder.hpp>
#include <trophic/observe/run_description.hpp>

namespace trophic::test {

/// A predator in body 0, an active prey in body 1 that it sees, a newborn prey in body 2; tick 3, 6 s.
[[nodiscard]] inline HandPopulation three_robots() {
  HandPopulation robots{{{.species = predator, .x_m = 1.5, .y_m = -2.0, .tag = -1, .fed_tick = 1, .id = 7},
                         {.species = prey, .x_m = 0.25, .heading_rad = 0.5, .tag = -1, .id = 8},
                         {.species = prey, .y_m = 4.0, .active = false, .id = 9}}};
  robots.individuals[0].adversary = 1;
  robots.individuals[0].adversary_distance_m = 2.5;
  robots.individuals[0].target_angle_rad = 0.7;
  robots.individuals[2].parents = {8};
  robots.individuals[2].origin = Origin::inherited;
  robots.individuals[2].born_s = 6.0;
  robots.individuals[2].mutation_distance = 0.125;
  return robots.at_tick(3);
}

/// A run of 10 s of the rules "hand-written".
[[nodiscard]] inline observe::RunDescription short_run() {
  observe::RunDescription run;
  run.rules = "hand_written";
  run.slots = {{"floor", "no_floor"}};
  run.tags = {-1, 1};
  run.brain_weights = 1;
  run.backend = "paper 1";
  run.seed = 5;
  run.tick_s = 2.0;
  run.until_s = 10.0;
  run.fingerprint = "0123456789abcdef";
  return run;
}

[[nodiscard]] inline std::string content(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

}  // namespace trophic::test
