// SPDX-License-Identifier: MIT
// A parent rule for each cause of death.
#pragma once

#include <trophic/params/policy.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/reproduction/parent/no_parent.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::reproduction::parent {

/// Rule: the parent is chosen by the rule for this cause of death; after a cause without a rule, or if a body diverges, there is
/// no parent. The path of a parameter includes its cause: `rules.parent.starved.range_m`. `with_parent_after<Rules,
/// Cause::starved, Policy>` (rules/with_part.hpp) swaps one rule.   Reads: what the rule for the cause reads.   Random draws:
/// those of that rule.
template <class Caught, class Starved = NoParent, class Sacrificed = NoParent, class Senescence = NoParent>
struct ByCause : Parts<Caught, Starved, Sacrificed, Senescence> {
  struct Names {
    static constexpr std::array<std::string_view, 4> part_names{enum_names(Cause{})[0], enum_names(Cause{})[1],
                                                                enum_names(Cause{})[2], enum_names(Cause{})[3]};
  };
  static constexpr auto& part_names = Names::part_names;
  static constexpr bool parts_fit = Parent<AnswersForSpecies<Caught>> && Parent<AnswersForSpecies<Starved>> &&
                                    Parent<AnswersForSpecies<Sacrificed>> && Parent<AnswersForSpecies<Senescence>>;
  /// "caught: killer, starved: nearest_victim".
  static constexpr std::string_view name =
      JoinedText<trophic::detail::PartWords<NoParent, Names, Caught, Starved, Sacrificed, Senescence>>::view;
  static constexpr std::string_view source =
      JoinedText<trophic::detail::PartSources<NoParent, Caught, Starved, Sacrificed, Senescence>>::view;

  struct Params {
    ParamsOf<Caught> caught{};
    ParamsOf<Starved> starved{};
    ParamsOf<Sacrificed> sacrificed{};
    ParamsOf<Senescence> senescence{};
    static constexpr auto fields() {
      return std::tuple{field("caught", &Params::caught), field("starved", &Params::starved),
                        field("sacrificed", &Params::sacrificed), field("senescence", &Params::senescence)};
    }
  };
  Params params;

  using States = std::tuple<AllStates<Caught>, AllStates<Starved>, AllStates<Sacrificed>, AllStates<Senescence>>;

  explicit ByCause(const Params& given = {}) : ByCause::Parts{given}, params{given} {}

  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng& rng, const States& states) const {
    const auto asked = [&]<Cause cause>() {
      constexpr auto place = static_cast<std::size_t>(cause);
      return ask::parent(this->template part<place>(), std::get<place>(states), vacancy, view, rng);
    };
    switch (vacancy.cause) {
      case Cause::caught:
        return asked.template operator()<Cause::caught>();
      case Cause::starved:
        return asked.template operator()<Cause::starved>();
      case Cause::sacrificed:
        return asked.template operator()<Cause::sacrificed>();
      case Cause::diverged:
        return std::nullopt;
      case Cause::senescence:
        break;
    }
    return asked.template operator()<Cause::senescence>();
  }
};
static_assert(Parent<ByCause<NoParent>>);

}  // namespace trophic::reproduction::parent
