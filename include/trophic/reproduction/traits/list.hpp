// SPDX-License-Identifier: MIT
// A list of heritable traits.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <trophic/params/group.hpp>
#include <trophic/reproduction/traits/contract.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::reproduction::traits {

/// A trait is a type with a name and the defaults of its parameters:
///   struct Sight {
///     static constexpr std::string_view name = "sight_m";
///     static constexpr double first = 8.0, least = 1.0, most = 20.0, sd = 0.5;
///   };
template <class T>
concept Trait = requires {
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
  friend bool operator==(const TraitParams&, const TraitParams&) = default;
};

/// Rule, for each trait x in the list:
///   x <- clip(x + N(0, sd), least, most)
/// at each birth, from the parent's x or, without a parent, from `first`. Not in the paper; all parameters are free.
/// Reads: the traits.   Random draws: 2 per trait.
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

  using Params = GroupOf<Names, TraitParams<Traits>...>;
  Params params;

  explicit List(const Params& given = {}) : params{given} {
    static_assert(((Traits::least <= Traits::first && Traits::first <= Traits::most && Traits::sd >= 0.0) && ...),
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
    each([&](std::size_t place, const auto& trait) {
      traits[place] = std::clamp(traits[place] + rng.normal(0.0, trait.sd), trait.least, trait.most);
    });
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
