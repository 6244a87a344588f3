// SPDX-License-Identifier: MIT
// A rule whose parameters differ by species.
#pragma once

#include <trophic/death/capture/detail/by_species.hpp>
#include <trophic/params/group.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/population/species_names.hpp>
#include <trophic/population/state.hpp>
#include <trophic/rules/check.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::rules {

namespace detail {

template <class Policy>
struct BySpeciesWords {
  static constexpr std::array<std::string_view, 2> words{Policy::name, "by_species"};
  static constexpr std::string_view separator = "_";
};
template <class Policy, class Community, class Indices>
struct by_species_params;
template <class Policy, class Community, std::size_t... species>
struct by_species_params<Policy, Community, std::index_sequence<species...>> {
  template <std::size_t>
  using One = ParamsOf<Policy>;
  using type = GroupOf<trophic::detail::SpeciesNames<Community>, One<species>...>;
};

/// Shared by all forms of by_species: its name, the policy that applies to one species, and that policy's State.
template <class Policy>
struct BySpecies {
  static_assert(!MadeOfParts<Policy>, "rules::by_species takes a policy without parts; apply it to each part");
  static constexpr std::string_view name = JoinedText<BySpeciesWords<Policy>>::view;
  static constexpr std::string_view source = source_of<Policy>();
  using OfOneSpecies = Policy;
};
template <Stateful Policy>
struct BySpecies<Policy> {
  static constexpr std::string_view name = JoinedText<BySpeciesWords<Policy>>::view;
  static constexpr std::string_view source = source_of<Policy>();
  using OfOneSpecies = Policy;
  using State = typename Policy::State;
};

template <class Community>
concept NamesSpecies = requires {
  { Community::species_names[0] } -> std::convertible_to<std::string_view>;
  std::tuple_size<std::remove_cvref_t<decltype(Community::species_names)>>::value;
};

}  // namespace detail

/// A policy with parameters for each species: `with_mutation<Paper, by_species<NormalMutation>>` has `rules.mutation.prey.sd` and
/// `rules.mutation.predator.sd`. In a rule table its species are those of the table's community, which lists their names:
/// `static constexpr std::array<std::string_view, N> species_names`. It is for slots that rules/slots.hpp marks as concerning one
/// individual or species, and for parts of their policies: each individual has the parameters of its species. Reads and random
/// draws: the policy's.
template <class Policy>
class by_species<Policy, void> : public detail::BySpecies<Policy> {};

/// The same in a table of this community.
template <class Policy, class Community>
class by_species : public detail::BySpecies<Policy> {
 public:
  static_assert(trophic::detail::CheckHeld<Policy>::ok);
  static_assert(detail::NamesSpecies<Community>,
                "rules::by_species needs a community that lists static constexpr std::array<std::string_view, N> species_names");
  static constexpr std::size_t count = Community::species_names.size();

  using Params = typename detail::by_species_params<Policy, Community, std::make_index_sequence<count>>::type;
  Params params;

  explicit by_species(const Params& numbers = {}) : by_species{numbers, std::make_index_sequence<count>{}} {}

  /// The policy with the parameters of a species.
  [[nodiscard]] const Policy& of(Species species) const { return policies_.at(species); }

 private:
  template <std::size_t... species>
  by_species(const Params& numbers, std::index_sequence<species...>)
      : params{numbers}, policies_{make_policy<Policy>(numbers.template get<species>())...} {}

  std::array<Policy, count> policies_;
};

}  // namespace trophic::rules

namespace trophic::detail {

template <class Policy, class Community>
struct held_by<rules::by_species<Policy, Community>> {
  using type = rules::by_species<Policy, Community>;
};

}  // namespace trophic::detail
