// SPDX-License-Identifier: MIT
// First of two translation units that include everything public: the program links and finds the models.
#include <filesystem>
#include <iostream>
#include <trophic/trophic.hpp>
#ifdef CONSUMER_HAS_mujoco
#include <trophic/backend/mujoco.hpp>
#endif

double first_draw_of_other_unit();

int main() {
  if (trophic::Rng{42, trophic::Stream::user}.uniform() != first_draw_of_other_unit()) {
    std::cerr << "two translation units draw different numbers\n";
    return 1;
  }
  if (!std::filesystem::is_directory(TROPHIC_MODEL_DIR)) {
    std::cerr << "no models in " << TROPHIC_MODEL_DIR << '\n';
    return 1;
  }
#ifdef CONSUMER_HAS_mujoco
  std::cout << trophic::backend::Mujoco::name << ' ' << trophic::backend::Mujoco::version() << '\n';
#endif
}
