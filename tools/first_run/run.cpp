// SPDX-License-Identifier: MIT
// What scripts/quickstart compiles: 300 simulated seconds of the paper's rules with 30 robots in MuJoCo, in a new folder, and a
// page of the run.
#include <exception>
#include <iostream>
#include <trophic/rules/paper.hpp>
#include <trophic/run.hpp>

#include "parts.hpp"

int main() {
  try {
    trophic::Ecology<trophic::rules::Paper> ecology({.seed = 1}, trophic::first_run::mujoco());
    const auto folder = trophic::run_in_new_folder(ecology, 300.0, "runs/quickstart");
    const auto page = folder.string() + ".html";
    trophic::first_run::write_page(folder, page);
    std::cout << "\ntables  " << folder.string() << "\npage    " << page << ": open it in a browser; it begins with a catch\n";
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "quickstart: " << error.what() << "\n";
    return 1;
  }
}
