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

/// Rule: `Interval` decides when a starvation procedure takes place, `Choice` decides which hunters die in it, and `Exemption`
/// which of the considered hunters are exempt (Sec. "Predator Death"). The path of a parameter includes its part:
/// `rules.starvation.interval.base_ticks`. `with_starvation_interval`, `with_starvation_exemption` or `with_starvation_choice`
/// (rules/with_part.hpp) swap one part. If the interval or the choice differs by species, each hunting species has its own
/// procedures: with `with_starvation_interval<Paper, by_species<DelayedCrowdingInterval>>`, a species' interval depends on its
/// own number of members.   Reads: what its parts read, its own clock.   Random draws: 0.
template <class IntervalPart, class ExemptionPart, class ChoicePart>
struct Procedure : Parts<IntervalPart, ExemptionPart, ChoicePart> {
  struct Names {
    static constexpr std::array<std::string_view, 3> part_names{"interval", "exemption", "choice"};
  };
  static constexpr auto& part_names = Names::part_names;
  using OneInterval = AnswersForSpecies<IntervalPart>;
  using OneChoice = AnswersForSpecies<ChoicePart>;
  /// Whether each species has its own procedures.
  static constexpr bool is_apart = !std::same_as<OneInterval, IntervalPart> || !std::same_as<OneChoice, ChoicePart>;
  static constexpr bool parts_fit = Interval<OneInterval> && Exemption<AnswersForSpecies<ExemptionPart>> && Choice<OneChoice> &&
                                    (!is_apart || (Interval<OneInterval, OneSpecies> && Choice<OneChoice, OneSpecies>));
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

  struct Clocks {  ///< one clock per species
    std::vector<StarvationClock> of;
    static constexpr auto saved() { return std::tuple{&Clocks::of}; }
  };
  using Clock = std::conditional_t<is_apart, Clocks, StarvationClock>;
  using States = std::tuple<AllStates<IntervalPart>, AllStates<ExemptionPart>, AllStates<ChoicePart>>;

  explicit Procedure(const Params& given = {}) : Procedure::Parts{given}, params{given} {}

  [[nodiscard]] Clock start(const View& view, Clock clock = {}, std::span<const Species> due = {}) const {
    const std::int64_t now = view.tick;
    if constexpr (is_apart) {
      clock.of.resize(view.web.size());
      for (Species species = 0; species < view.web.size(); ++species) {
        if (!due.empty() && std::ranges::find(due, species) == due.end()) continue;
        clock.of[species] = {.last_tick = now, .interval_ticks = interval_of(species).interval_ticks(view, species)};
      }
      return clock;
    } else {
      return {.last_tick = now, .interval_ticks = this->template part<0>().interval_ticks(view)};
    }
  }

  [[nodiscard]] Starving starving(const View& view, const perception::Perceives& perceives, const States& states,
                                  const Clock& clock) const {
    if constexpr (!is_apart) {
      if (!this->template part<0>().due(clock, view)) return {};
    }
    Starving result{.victims = {}, .exempt = {}, .restarts_clock = true};
    const IsExempt is_exempt = [&](BodyIndex hunter) {
      const bool exempt =
          ask::is_exempt(this->template part<1>(), state_of_body(std::get<1>(states), hunter), hunter, view, perceives);
      if (exempt) result.exempt.push_back(hunter);
      return exempt;
    };
    if constexpr (is_apart) {
      for (Species species = 0; species < view.web.size(); ++species) {
        if (!view.web.hunts(species) || !interval_of(species).due(clock.of.at(species), view, species)) continue;
        const auto victims = for_species(this->template part<2>(), species).victims(view, is_exempt, species);
        result.victims.insert(result.victims.end(), victims.begin(), victims.end());
        result.due.push_back(species);
      }
      result.restarts_clock = !result.due.empty();
    } else {
      result.victims = this->template part<2>().victims(view, is_exempt);
    }
    return result;
  }

 private:
  [[nodiscard]] const OneInterval& interval_of(Species species) const { return for_species(this->template part<0>(), species); }
};
static_assert(Starvation<Procedure<interval::NeverDue, exemption::NoExemption, choice::HungriestNonexempt>>);

}  // namespace trophic::death::starvation
