// SPDX-License-Identifier: MIT
// An act, a rule that needs it, and a brain that has an output for it.
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/reproduction/heredity/crossover_by_neuron.hpp>
#include <trophic/rules/paper.hpp>

struct GivesUp {
  static constexpr std::string_view name = "gives_up";
  static constexpr std::string_view unit{};
  static constexpr std::size_t outputs = 1;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;
  static constexpr bool by_default = false;
  static bool value(std::span<const double, 1> out) { return out[0] > 0.9; }
};

struct DiesIfItGivesUp {
  static constexpr std::string_view name = "dies_if_it_gives_up";
  using ReadsActs = trophic::control::acts::List<GivesUp>;
  bool dies(const trophic::Individual&, const trophic::View& view, trophic::Rng&) const { return view.act<GivesUp>(0); }
};

struct Constant {
  static constexpr std::string_view name = "constant";
  std::size_t genome_size(std::size_t, std::size_t outputs) const { return outputs; }
  std::vector<int> tags() const { return {-1, 1}; }
  void evaluate(std::span<const double>, std::span<const double> weights, std::span<double> outputs) const {
    for (std::size_t i = 0; i < outputs.size(); ++i) outputs[i] = weights[i];
  }
};

int main() {
  using Acts = trophic::control::acts::List<trophic::control::acts::Turn, trophic::control::acts::Tag, GivesUp>;
  using Giving = trophic::with_acts<trophic::with_brain<trophic::rules::Paper, Constant>, Acts>;
  trophic::Ecology<trophic::with_senescence<Giving, DiesIfItGivesUp>> ecology{{}, trophic::backend::Kinematic::Params{}};
  ecology.run_until(10.0);
}
