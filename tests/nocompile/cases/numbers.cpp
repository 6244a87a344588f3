// SPDX-License-Identifier: MIT
// Numbers that are checked, written to a manifest and saved.
#include <trophic/params/archive.hpp>
#include <trophic/params/named_params.hpp>

struct Numbers {
  double length_m = 1.0;
  std::string label = "none";
  static constexpr auto fields() {
    return std::tuple{trophic::field("length_m", &Numbers::length_m, trophic::above(0.0)),
                      trophic::field("label", &Numbers::label)};
  }
};

struct Checked {
  double max_age_s = 600.0;
  static constexpr auto fields() { return std::tuple{trophic::field("max_age_s", &Checked::max_age_s, trophic::above(0.0))}; }
};

struct State {
  int steps = 0;
  std::vector<double> joints;
  static constexpr auto saved() { return std::tuple{&State::steps, &State::joints}; }
};

int main() {
  trophic::validate(Checked{}, "death");
  trophic::Archive archive;
  State state;
  archive(state);
  return static_cast<int>(trophic::named_params_of(Numbers{}).size());
}
