// SPDX-License-Identifier: MIT
// A backend's state of which no checkpoint could keep all.
// expect: or a struct that lists every member in saved() or fields(); see trophic/params/archive.hpp
#include <trophic/params/archive.hpp>
#include <tuple>
#include <vector>

struct State {
  int steps = 0;
  std::vector<double> joints;
#ifdef VALID
  static constexpr auto saved() {
    return std::tuple{&State::steps, &State::joints};
  }
#endif
};

int main() {
  trophic::Archive archive;
  State state;
  archive(state);
}
