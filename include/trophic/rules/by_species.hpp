// SPDX-License-Identifier: MIT
// A rule whose numbers differ by species.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <trophic/death/floor/contract.hpp>
#include <trophic/death/reprieve/contract.hpp>
#include <trophic/death/senescence/contract.hpp>
#include <trophic/initialization/community/contract.hpp>
#include <trophic/params/group.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/perception/visibility/contract.hpp>
#include <trophic/population/state.hpp>
#include <trophic/reproduction/mutation/contract.hpp>
#include <trophic/reproduction/parent/contract.hpp>
#include <trophic/support/joined_text.hpp>
#include <utility>

namespace trophic::rules {

namespace detail {

template <class Policy>
struct BySpeciesWords {
  static constexpr std::array<std::string_view, 2> words{Policy::name, "by_species"};
  static constexpr std::string_view separator = "_";
};
template <class Community>
struct SpeciesNames {
  static constexpr const auto& names = Community::species_names;
};
template <class Policy, class Community, class Indices>
struct by_species_params;
template <class Policy, class Community, std::size_t... species>
struct by_species_params<Policy, Community, std::index_sequence<species...>> {
  template <std::size_t>
  using One = ParamsOf<Policy>;
  using type = GroupOf<SpeciesNames<Community>, One<species>...>;
};

/// State and hooks of the policy, where it has them; the species of `self` says whose numbers count.
template <class Self, class Policy>
struct StateBySpecies {};
template <class Self, Stateful Policy>
struct StateBySpecies<Self, Policy> {
  using State = typename Policy::State;
  [[nodiscard]] State born(const Individual& newborn, const State* parent, const State& body) const {
    return static_cast<const Self&>(*this).of(newborn.species).born(newborn, parent, body);
  }
};
#define TROPHIC_HOOK_BY_SPECIES(hook, Happened, signature)                                          \
  template <class Self, class Policy>                                                               \
  struct BySpecies_##hook {};                                                                       \
  template <class Self, class Policy>                                                               \
  requires trophic::detail::StateTakes_##hook<Policy> struct BySpecies_##hook<Self, Policy> {       \
    void hook(typename Policy::State& own, BodyIndex self, Happened what, const View& view) const { \
      static_cast<const Self&>(*this).of(view.robots[self].species).hook(own, self, what, view);    \
    }                                                                                               \
  };
TROPHIC_STATE_HOOKS(TROPHIC_HOOK_BY_SPECIES)
#undef TROPHIC_HOOK_BY_SPECIES

template <class Community>
concept NamesSpecies = requires {
  { Community::species_names[0] } -> std::convertible_to<std::string_view>;
  std::tuple_size<std::remove_cvref_t<decltype(Community::species_names)>>::value;
};

#define TROPHIC_BASE_BY_SPECIES(hook, Happened, signature) \
  , public detail::BySpecies_##hook<by_species<Policy, Community>, Policy>
}  // namespace detail

/// A policy with numbers for each species of a community: `with_mutation<Paper, by_species<NormalMutation>>` has
/// `rules.mutation.prey.sd` and `rules.mutation.predator.sd`. For the slots that ask about one individual or species: Mutation
/// (the offspring's), Senescence, Visibility (who looks), Reprieve (the hunter's), Floor, and the parents (the dying one's). The
/// community lists its species' names: `static constexpr std::array<std::string_view, N> species_names`. Reads and random draws:
/// the policy's.
template <class Policy, class Community>
class by_species : public detail::StateBySpecies<by_species<Policy, Community>, Policy> TROPHIC_STATE_HOOKS(
                       TROPHIC_BASE_BY_SPECIES) {
#undef TROPHIC_BASE_BY_SPECIES
 public:
  static_assert(detail::NamesSpecies<Community>,
                "rules::by_species needs a community that lists static constexpr std::array<std::string_view, N> species_names");
  static constexpr std::size_t count = Community::species_names.size();
  static constexpr std::string_view name = JoinedText<detail::BySpeciesWords<Policy>>::view;
  using Own = StateOf<Policy>;

  using Params = typename detail::by_species_params<Policy, Community, std::make_index_sequence<count>>::type;
  Params params;

  explicit by_species(const Params& numbers = {}) : by_species{numbers, std::make_index_sequence<count>{}} {}

  /// The policy with the numbers of a species.
  [[nodiscard]] const Policy& of(Species species) const {
    return policies_.at(species);
  }

  void mutate(std::span<double> weights, const Individual& offspring, Rng& rng,
              Own& own) const requires reproduction::Mutation<Policy> {
    reproduction::ask::mutate(of(offspring.species), own, weights, offspring, rng);
  }
  [[nodiscard]] bool dies(const Individual& one, const View& view, Rng& rng,
                          const Own& own) const requires death::Senescence<Policy> {
    return death::ask::dies(of(one.species), own, one, view, rng);
  }
  [[nodiscard]] bool perceives(BodyIndex self, BodyIndex other, const View& view, Rng& rng,
                               const Own& own) const requires perception::Visibility<Policy> {
    return perception::ask::perceives(of(view.robots[self].species), own, self, other, view, rng);
  }
  [[nodiscard]] perception::Horizon horizon(const Individual& self) const requires perception::Visibility<Policy> {
    return perception::ask::horizon(of(self.species), self);
  }
  [[nodiscard]] bool spared(BodyIndex hunter, const View& view, const perception::Perceives& perceives,
                            const Own& own) const requires death::Reprieve<Policy> {
    return death::ask::spared(of(view.robots[hunter].species), own, hunter, view, perceives);
  }
  [[nodiscard]] bool may_die(Species species, const View& view) const requires death::Floor<Policy> {
    return of(species).may_die(species, view);
  }
  [[nodiscard]] std::optional<Ancestor> parent(const reproduction::Vacancy& vacancy, const View& view, Rng& rng,
                                               const Own& own) const requires reproduction::Parent<Policy> {
    return reproduction::ask::parent(of(view.robots[vacancy.body].species), own, vacancy, view, rng);
  }

 private:
  template <std::size_t... species>
  by_species(const Params& numbers, std::index_sequence<species...>)
      : params{numbers}, policies_{make_policy<Policy>(numbers.template get<species>())...} {}

  std::array<Policy, count> policies_;
};

}  // namespace trophic::rules
