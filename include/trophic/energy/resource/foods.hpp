// SPDX-License-Identifier: MIT
// Several foods, each with a rule of its own.
#pragma once

#include <algorithm>
#include <trophic/energy/resource/contract.hpp>
#include <trophic/params/group.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::energy::resource {

/// A food with its name and its rule, which is one of one food.
template <TemplateText text, class Growth>
struct Food {
  static_assert(OneFood<Growth>, "resource::Food needs a rule of one food; see trophic/energy/resource/contract.hpp");
  static_assert(trophic::detail::CheckHeld<Growth>::ok);
  static constexpr std::string_view name = text.view();
  static_assert(!name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string_view::npos,
                "the name of a food is of lower-case letters, digits and _");
  using Rule = Growth;
};

/// Rule: the foods of the list lie on the floor together, and each grows by its own rule on its own grid:
/// `Foods<Food<"grass", LogisticField>, Food<"fruit", LogisticField>>` with `rules.resource.grass.capacity_J_m2`. Who eats which
/// is said by the rule Metabolism.   Reads: what the rules read.   Random draws: those of the rules, in the order of the list.
template <class... List>
struct Foods {
  struct Names {
    static constexpr std::array<std::string_view, sizeof...(List)> names{List::name...};
  };
  struct Words {
    static constexpr std::array<std::string_view, 4 * sizeof...(List)> words = [] {
      std::array<std::string_view, 4 * sizeof...(List)> all;
      auto end = all.begin();
      const auto add = [&](std::string_view name, std::string_view rule) {
        for (const std::string_view word : {end == all.begin() ? std::string_view{} : ", ", name, std::string_view{": "}, rule})
          *end++ = word;
      };
      (add(List::name, List::Rule::name), ...);
      return all;
    }();
    static constexpr std::string_view separator{};
  };
  struct Sources {
    static constexpr std::array<std::string_view, sizeof...(List)> words{source_of<typename List::Rule>()...};
    static constexpr std::string_view separator = " + ";
  };
  static constexpr const auto& food_names = Names::names;
  static constexpr std::string_view name = JoinedText<Words>::view;
  static constexpr std::string_view source = JoinedText<Sources>::view;
  static_assert(sizeof...(List) > 0, "resource::Foods needs a food");
  static_assert(((std::ranges::count(Names::names, List::name) == 1) && ...), "two foods of a list have one name");

  using Params = GroupOf<Names, ParamsOf<typename List::Rule>...>;
  Params params;

  explicit Foods(const Params& given = {}) : params{given} {
    each([&]<class Rule, std::size_t food>() { static_cast<void>(make_policy<Rule>(params.template get<food>(), "resource")); });
  }

  [[nodiscard]] std::string_view why_no_effect(std::string_view number, const FoodWeb& web, OneSpecies species) const {
    std::string_view why;
    each([&]<class Rule, std::size_t food>() {
      if constexpr (requires(const Rule one) { one.why_no_effect(number, web, species); }) {
        const std::string_view own = food_names[food];
        if (number.starts_with(own) && number.substr(own.size()).starts_with('.'))
          why = rule<Rule, food>().why_no_effect(number.substr(own.size() + 1), web, species);
      }
    });
    return why;
  }

  [[nodiscard]] std::vector<ResourceField> start(const Arena& arena, Rng& rng) const {
    std::vector<ResourceField> foods;
    each([&]<class Rule, std::size_t food>() { foods.push_back(rule<Rule, food>().start(arena, rng)); });
    return foods;
  }
  void grow(std::span<ResourceField> foods, const View& view, Rng& rng) const {
    each([&]<class Rule, std::size_t food>() { rule<Rule, food>().grow(foods[food], view, rng); });
  }
  void on_bite(std::span<ResourceField> foods, std::size_t bitten, std::size_t cell, double taken_J, BodyIndex self,
               const View& view) const {
    each([&]<class Rule, std::size_t food>() {
      if constexpr (energy::detail::TakesBites<Rule>) {
        if (food == bitten) rule<Rule, food>().on_bite(foods[food], cell, taken_J, self, view);
      }
    });
  }
  void on_death(std::span<ResourceField> foods, const Vacancy& death, double left_J, const View& view) const {
    each([&]<class Rule, std::size_t food>() {
      if constexpr (energy::detail::TakesDeaths<Rule>) rule<Rule, food>().on_death(foods[food], death, left_J, view);
    });
  }
  void on_birth(std::span<ResourceField> foods, std::span<const BodyIndex> parents, const View& view, Rng& rng) const {
    each([&]<class Rule, std::size_t food>() {
      if constexpr (energy::detail::TakesBirths<Rule>) rule<Rule, food>().on_birth(foods[food], parents, view, rng);
    });
  }

 private:
  /// Calls `visit.template operator()<its rule, its place>()` for each food.
  static void each(const auto& visit) {
    [&]<std::size_t... food>(std::index_sequence<food...>) {
      (visit.template operator()<typename List::Rule, food>(), ...);
    }
    (std::index_sequence_for<List...>{});
  }
  template <class Rule, std::size_t food>
  [[nodiscard]] Rule rule() const {
    if constexpr (trophic::detail::HasParams<Rule>) {
      return Rule{params.template get<food>()};
    } else {
      return Rule{};
    }
  }
};

}  // namespace trophic::energy::resource
