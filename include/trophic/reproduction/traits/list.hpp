// SPDX-License-Identifier: MIT
// A list of heritable traits.
#pragma once

#include <algorithm>
#include <concepts>
#include <stdexcept>
#include <trophic/params/group.hpp>
#include <trophic/reproduction/traits/contract.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::reproduction::traits {

/// A trait with a mutation of its own, such as Sex: its Params have `first`, `least`, `most` and `double next(double x, Rng&)
/// const`, the value of a newborn whose parent has x, or that has no parent and begins with `first`.
template <class T>
concept OwnTrait = requires(const typename T::Params params, double x, Rng& rng) {
  { T::name } -> std::convertible_to<std::string_view>;
  { params.first + params.least + params.most } -> std::convertible_to<double>;
  { params.next(x, rng) } -> std::same_as<double>;
};

/// A trait is a type with a name and the defaults of its parameters:
///   struct Sight {
///     static constexpr std::string_view name = "sight_m";
///     static constexpr double first = 8.0, least = 1.0, most = 20.0, sd = 0.5;
///   };
template <class T>
concept Trait = OwnTrait<T> || requires {
  { T::name } -> std::convertible_to<std::string_view>;
  { T::first + T::least + T::most + T::sd } -> std::convertible_to<double>;
};

template <Trait T>
struct TraitParams {
  double first = T::first;
  double least = T::least;
  double most = T::most;
  double sd = T::sd;
  static constexpr auto fields() {
    return std::tuple{field("first", &TraitParams::first, any_number(), "value of individuals without a parent, before mutation")
                          .read_for_newcomers(),
                      field("least", &TraitParams::least, any_number(), "lower bound"),
                      field("most", &TraitParams::most, any_number(), "upper bound"),
                      field("sd", &TraitParams::sd, at_least(0.0), "standard deviation of mutations")};
  }
  [[nodiscard]] double next(double x, Rng& rng) const { return std::clamp(x + rng.normal(0.0, sd), least, most); }
  friend bool operator==(const TraitParams&, const TraitParams&) = default;
};

namespace detail {

template <class T>
struct ParamsOfTrait {
  using type = TraitParams<T>;
  static constexpr bool fit = T::least <= T::first && T::first <= T::most && T::sd >= 0.0;
};
template <OwnTrait T>
struct ParamsOfTrait<T> {
  using type = typename T::Params;
  static constexpr bool fit = true;
};

}  // namespace detail

/// Rule, for each trait x in the list:
///   x <- clip(x + N(0, sd), least, most)
/// at each birth, from the parent's x or, without a parent, from `first`; an OwnTrait has its own rule. Not in the paper; all
/// parameters are free.   Reads: the traits.   Random draws: 2 per trait, or those of an OwnTrait.
template <Trait... Traits>
struct List {
  struct Names {
    static constexpr std::array<std::string_view, sizeof...(Traits)> names{Traits::name...};
    static constexpr const auto& words = names;
    static constexpr std::string_view separator = " + ";
  };
  static constexpr const auto& trait_names = Names::names;
  static constexpr std::string_view name = JoinedText<Names>::view;
  static constexpr std::string_view source = "not in the paper";
  static_assert(((std::ranges::count(Names::names, Traits::name) == 1) && ...), "two traits of a list have one name");

  using Params = GroupOf<Names, typename detail::ParamsOfTrait<Traits>::type...>;
  Params params;

  explicit List(const Params& given = {}) : params{given} {
    static_assert((detail::ParamsOfTrait<Traits>::fit && ...),
                  "a trait's first must be >= its least and <= its most, and its sd >= 0");
    each([](std::size_t place, const auto& trait) {
      if (trait.least <= trait.first && trait.first <= trait.most) return;
      throw std::invalid_argument{"rules.traits." + std::string{trait_names[place]} + ".first = " + number_text(trait.first) +
                                  ": must be >= least, " + number_text(trait.least) + ", and <= most, " +
                                  number_text(trait.most)};
    });
  }

  [[nodiscard]] std::vector<double> draw(Rng& rng) const {
    std::vector<double> traits;
    each([&](std::size_t, const auto& trait) { traits.push_back(trait.first); });
    mutate(traits, rng);
    return traits;
  }
  void mutate(std::span<double> traits, Rng& rng) const {
    each([&](std::size_t place, const auto& trait) { traits[place] = trait.next(traits[place], rng); });
  }
  [[nodiscard]] std::optional<BeyondBound> beyond(std::span<const double> traits) const {
    std::optional<BeyondBound> found;
    each([&](std::size_t place, const auto& trait) {
      const double value = traits[place];
      if (found || (trait.least <= value && value <= trait.most)) return;
      const bool below = value < trait.least;
      found = {std::string{trait_names[place]} + (below ? ".least" : ".most"), below ? trait.least : trait.most, value};
    });
    return found;
  }

 private:
  /// Calls `visit(place, parameters)` for each trait.
  void each(const auto& visit) const {
    [&]<std::size_t... place>(std::index_sequence<place...>) {
      (visit(place, params.template get<place>()), ...);
    }
    (std::index_sequence_for<Traits...>{});
  }
};
static_assert(TraitRule<List<>>);

}  // namespace trophic::reproduction::traits
