// SPDX-License-Identifier: MIT
// A rule table with a rule whose constant is in its code, where no manifest lists it.
#include <trophic/death/senescence/contract.hpp>
#include <trophic/experiment.hpp>
#include <trophic/rules/paper.hpp>

extern const double hidden_factor;  ///< of the program that this is linked into

namespace {

/// Dies at ten times hidden_factor seconds.
struct HiddenFactor {
  static constexpr std::string_view name = "hidden_factor";
  struct Params {
    static constexpr auto fields() { return std::tuple{}; }
  };
  Params params;

  bool dies(const trophic::Individual& individual, const trophic::View& view, trophic::Rng&) const {
    return view.age_s(individual) > 10.0 * hidden_factor;
  }
};
static_assert(trophic::death::Senescence<HiddenFactor>);

using Own = trophic::named<trophic::with_senescence<trophic::rules::Paper, HiddenFactor>, "own">;

}  // namespace

int main(int argc, char** argv) {
  return trophic::experiment<Own>(argc, argv);
}
