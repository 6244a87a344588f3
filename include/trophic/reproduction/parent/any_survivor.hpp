// SPDX-License-Identifier: MIT
// A random individual reproduces instead of the one that another rule names, so only viability selection acts.
#pragma once

#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::reproduction::parent {

/// Rule: if `Rule` names a parent, the parent is a random living individual of the same species, each equally likely. If only the
/// dying one is left, it is the parent that `Rule` names. There is no fecundity selection by the parent rule, but full viability
/// selection: individuals that live longer are drawn more often. This is not a null model of selection (`--neutral` makes one);
/// the difference between a table and this rule is the effect of the parent rule. Set each part of a ByCause:
/// `with_parent_after<Paper, Cause::caught, AnySurvivor<Killer>>`.   Not in the paper.   Reads: species, what Rule reads. Random
/// draws: 1 if Rule names a parent, after Rule's.
template <class Rule>
struct AnySurvivor : Rule {
  static_assert(Parent<Rule> && !MadeOfParts<Rule>, "parent::AnySurvivor takes a parent rule without parts");
  static constexpr std::string_view name = prefixed_name<"any_survivor", Rule>;
  static constexpr std::string_view source = "control";

  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng& rng) const
      requires(!Stateful<Rule>) {
    return instead_of(Rule::parent(vacancy, view, rng), vacancy, view, rng);
  }
  [[nodiscard]] std::optional<Ancestor> parent(const Vacancy& vacancy, const View& view, Rng& rng,
                                               AllStates<Rule> states) const requires Stateful<Rule> {
    return instead_of(ask::parent(static_cast<const Rule&>(*this), states, vacancy, view, rng), vacancy, view, rng);
  }

 private:
  [[nodiscard]] static std::optional<Ancestor> instead_of(std::optional<Ancestor> named, const Vacancy& vacancy, const View& view,
                                                          Rng& rng) {
    if (!named) return named;
    std::vector<BodyIndex> possible;
    for (BodyIndex body = 0; body < view.robots.size(); ++body) {
      if (body != vacancy.body && view.robots[body].species == named->species) possible.push_back(body);
    }
    std::ranges::sort(possible, {}, [&](BodyIndex body) { return view.robots[body].id; });
    const std::size_t drawn = rng.index(possible.empty() ? 1 : possible.size());
    return possible.empty() ? named : view.robots[possible[drawn]].as_ancestor();
  }
};

}  // namespace trophic::reproduction::parent
