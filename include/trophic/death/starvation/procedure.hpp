// SPDX-License-Identifier: MIT
// Starvation by procedures: from time to time the hungriest hunter dies, unless it is exempt.
#pragma once

#include <trophic/death/starvation/choice/contract.hpp>
#include <trophic/death/starvation/choice/hungriest_nonexempt.hpp>
#include <trophic/death/starvation/contract.hpp>
#include <trophic/death/starvation/exemption/contract.hpp>
#include <trophic/death/starvation/exemption/no_exemption.hpp>
#include <trophic/death/starvation/interval/contract.hpp>
#include <trophic/death/starvation/interval/never_due.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::death::starvation {

/// Rule: `Interval` decides when a starvation procedure takes place, `Choice` which hunters die in it, `Exemption` which of the
/// hunters that it considers are exempt (Sec. "Predator Death"). A number is set by its part:
/// `rules.starvation.interval.base_ticks`. `with_starvation_interval`, `with_starvation_exemption` or `with_starvation_choice`
/// (rules/with_part.hpp) swap one part.   Reads: what its parts read, its own clock.   Random draws: 0.
template <class IntervalPart, class ExemptionPart, class ChoicePart>
struct Procedure : Parts<IntervalPart, ExemptionPart, ChoicePart> {
  struct Names {
    static constexpr std::array<std::string_view, 3> part_names{"interval", "exemption", "choice"};
  };
  static constexpr auto& part_names = Names::part_names;
  static constexpr bool parts_fit = Interval<IntervalPart> && Exemption<AnswersForSpecies<ExemptionPart>> && Choice<ChoicePart>;
  /// "interval: never_due, exemption: no_exemption, choice: hungriest_nonexempt".
  static constexpr std::string_view name =
      JoinedText<trophic::detail::PartWords<void, Names, IntervalPart, ExemptionPart, ChoicePart>>::view;
  static constexpr std::string_view source =
      JoinedText<trophic::detail::PartSources<void, IntervalPart, ExemptionPart, ChoicePart>>::view;

  struct Params {
    ParamsOf<IntervalPart> interval{};
    ParamsOf<ExemptionPart> exemption{};
    ParamsOf<ChoicePart> choice{};
    static constexpr auto fields() {
      return std::tuple{field("interval", &Params::interval), field("exemption", &Params::exemption),
                        field("choice", &Params::choice)};
    }
  };
  Params params;

  using Clock = StarvationClock;
  using States = std::tuple<AllStates<IntervalPart>, AllStates<ExemptionPart>, AllStates<ChoicePart>>;

  explicit Procedure(const Params& given = {}) : Procedure::Parts{given}, params{given} {}

  [[nodiscard]] Clock start(const View& view) const {
    return {.last_tick = view.tick, .interval_ticks = this->template part<0>().interval_ticks(view)};
  }

  [[nodiscard]] Starving starving(const View& view, const perception::Perceives& perceives, const States& states,
                                  const Clock& clock) const {
    if (!this->template part<0>().due(clock, view)) return {};
    Starving result{.victims = {}, .exempt = {}, .restarts_clock = true};
    const IsExempt is_exempt = [&](BodyIndex hunter) {
      const bool exempt =
          ask::is_exempt(this->template part<1>(), state_of_body(std::get<1>(states), hunter), hunter, view, perceives);
      if (exempt) result.exempt.push_back(hunter);
      return exempt;
    };
    result.victims = this->template part<2>().victims(view, is_exempt);
    return result;
  }
};
static_assert(Starvation<Procedure<interval::NeverDue, exemption::NoExemption, choice::HungriestNonexempt>>);

}  // namespace trophic::death::starvation
