// SPDX-License-Identifier: MIT
// A share of all predators starves in one procedure: for large ecologies.
#pragma once

#include <trophic/death/starvation/choice/contract.hpp>
#include <trophic/death/starvation/choice/detail/by_hunger.hpp>
#include <trophic/params/params.hpp>

namespace trophic::death::starvation::choice {

/// Rule: the hungriest hunters that are not exempt die, until a share of all hunters has died, rounded up. This is
/// HungriestNonexempt, which kills one hunter, for populations in which one death per tick is too few. The paper's rule kills one
/// of about 14 hunters in a procedure, so the default is 1/14.   Reads: hunger, ids.   Random draws: 0.
struct HungriestShare {
  static constexpr std::string_view name = "hungriest_share";
  static constexpr std::string_view source = "not in the paper";

  struct Params {
    double share = 1.0 / 14.0;
    static constexpr auto fields() {
      return std::tuple{
          field("share", &Params::share, between(0.0, 1.0), "share of all hunters that starve in one procedure, rounded up")};
    }
  };
  Params params;

  [[nodiscard]] std::vector<BodyIndex> victims(const View& view, const IsExempt& is_exempt, OneSpecies only = {}) const {
    const auto hunters = detail::by_hunger(view, only);
    const auto most = static_cast<std::size_t>(std::ceil(params.share * static_cast<double>(hunters.size())));
    std::vector<BodyIndex> dying;
    for (auto hunter = hunters.begin(); hunter != hunters.end() && dying.size() < most; ++hunter) {
      if (!is_exempt(*hunter)) dying.push_back(*hunter);
    }
    return dying;
  }
};
static_assert(Choice<HungriestShare>);

}  // namespace trophic::death::starvation::choice
