// SPDX-License-Identifier: MIT
// The contract of every rule of any kind: named, without state, its parameters listed and checked.
#pragma once

#include <doctest/doctest.h>

#include <conformance/policy_states.hpp>
#include <exception>
#include <support/hand_population.hpp>
#include <trophic/rules/table.hpp>

namespace trophic::conformance {

/// Seeds of the populations and streams that each suite goes through.
inline constexpr std::array<std::uint64_t, 8> seeds{1, 2, 3, 4, 5, 6, 7, 8};

/// The same robots with the traits that a policy names in ReadsTraits, if any, drawn for each as for an individual without a
/// parent.
template <class Policy>
[[nodiscard]] test::HandPopulation with_traits_of(test::HandPopulation robots) {
  if constexpr (requires { typename Policy::ReadsTraits; }) {
    using Traits = typename Policy::ReadsTraits;
    robots.traits.assign(Traits::trait_names.begin(), Traits::trait_names.end());
    for (Individual& one : robots.individuals) {
      Rng rng{one.id, Stream::user, 3};
      auto genome = std::make_shared<Genome>(*one.genome);
      genome->traits = Traits{}.draw(rng);
      one.genome = std::move(genome);
    }
  }
  return robots;
}

/// Runs `check` on crowded and on spread populations of two and of three species, and on an empty one. They have the
/// traits of `Policy`.
template <class Policy = void, class Check>
void on_populations(Check&& check) {
  const auto with_traits = [](test::HandPopulation robots) { return with_traits_of<Policy>(std::move(robots)); };
  for (const std::uint64_t seed : seeds) {
    CAPTURE(seed);
    check(with_traits(test::random_population(seed, 30)), seed);
    check(with_traits(test::random_population(seed, 30, test::predator_prey_web(), 2.0)), seed);
    check(with_traits(test::random_population(seed, 30, test::chain_web(), 3.0)), seed);
    check(with_traits(test::random_population(seed, seed, test::chain_web())), seed);
  }
  check(with_traits(test::HandPopulation{{}}), std::uint64_t{1});
}

/// The same robots after a quarter turn of the world; exact, so that no distance changes.
[[nodiscard]] inline test::HandPopulation turned(test::HandPopulation robots) {
  for (GroundPose& pose : robots.poses) {
    pose = {.x_m = -pose.y_m, .y_m = pose.x_m, .heading_rad = wrap_angle(pose.heading_rad + std::numbers::pi / 2.0)};
  }
  return robots;
}

/// The same robots in a mirror.
[[nodiscard]] inline test::HandPopulation mirrored(test::HandPopulation robots) {
  for (GroundPose& pose : robots.poses) pose = {.x_m = pose.x_m, .y_m = -pose.y_m, .heading_rad = -pose.heading_rad};
  return robots;
}

/// The same robots, all distances multiplied by `factor`.
[[nodiscard]] inline test::HandPopulation spread(test::HandPopulation robots, double factor) {
  for (GroundPose& pose : robots.poses)
    pose = {.x_m = factor * pose.x_m, .y_m = factor * pose.y_m, .heading_rad = pose.heading_rad};
  return robots;
}

/// The same robots with other ids, in the same order of birth.
[[nodiscard]] inline test::HandPopulation renamed(test::HandPopulation robots) {
  constexpr IndividualId shift = 5001;  // odd, so that nothing depends on an even id
  for (Individual& one : robots.individuals) {
    one.id += shift;
  }
  return robots;
}

/// Calls `check` with worlds in which a rule must say the same as in `robots`: turned, mirrored, and with other ids.
template <class Check>
void on_same_worlds(const test::HandPopulation& robots, Check&& check) {
  check(turned(robots));
  check(mirrored(robots));
  check(renamed(robots));
}

/// `ask(population, body)` returns the same for each robot in every such world and every body.
template <class Ask>
void check_each_robot(const test::HandPopulation& robots, std::uint64_t seed, Ask&& ask) {
  const std::size_t size = robots.individuals.size();
  const auto order = test::random_order(seed, size);
  const test::HandPopulation moved = robots.reordered(order);
  for (BodyIndex body = 0; body < size; ++body) {
    CHECK(ask(moved, body) == ask(robots, order[body]));
    on_same_worlds(robots, [&](const test::HandPopulation& same) { CHECK(ask(same, body) == ask(robots, body)); });
  }
}

/// `ask(population)` returns the same for all robots in every such world, however they share the bodies.
template <class Ask>
void check_all_robots(const test::HandPopulation& robots, std::uint64_t seed, Ask&& ask) {
  const auto answer = ask(robots);
  CHECK(ask(robots.reordered(test::random_order(seed, robots.individuals.size()))) == answer);
  on_same_worlds(robots, [&](const test::HandPopulation& same) { CHECK(ask(same) == answer); });
}

/// The bodies that `choose(population, rng)` names depend on the individuals in them, not on the bodies: a rule that draws
/// nothing names the same individuals when they have changed places, one that draws names each as often, within 5.5 standard
/// errors.
template <class Choose>
void check_whom(const test::HandPopulation& robots, std::uint64_t seed, Choose&& choose) {
  const std::size_t size = robots.individuals.size();
  const auto order = test::random_order(seed, size);
  const test::HandPopulation moved = robots.reordered(order);
  Rng used{seed, Stream::user};
  static_cast<void>(choose(robots, used));
  const bool draws = used.bits() != Rng{seed, Stream::user}.bits();
  const std::uint64_t times = draws ? 400 : 1;
  std::vector<double> before(size);
  std::vector<double> after(size);
  for (std::uint64_t time = 0; time < times; ++time) {
    Rng first{seed, Stream::user, 0, time};
    Rng second{seed, Stream::user, 1, time};
    for (const BodyIndex body : choose(robots, first)) ++before[body];
    for (const BodyIndex body : choose(moved, second)) ++after[order[body]];
  }
  for (BodyIndex body = 0; body < size; ++body) {
    CAPTURE(body);
    const double sum = before[body] + after[body];
    const double variance = sum * (1.0 - sum / (2.0 * static_cast<double>(times)));
    CHECK(std::abs(before[body] - after[body]) <= 5.5 * std::sqrt(draws ? variance : 0.0));
  }
}

/// `ask(rng)` gives the same from equal streams and again: nothing else counts, no other source of randomness.
template <class Ask>
auto asked_twice(std::uint64_t seed, Ask&& ask) {
  Rng first{seed, Stream::user};
  Rng second{seed, Stream::user};
  const auto answer = ask(first);
  CHECK((answer == ask(second)));
  CHECK(first.bits() == second.bits());
  return answer;
}

/// A policy with its default parameters.
template <class Policy>
[[nodiscard]] const Policy defaulted() {
  return make_policy<Policy>({});
}

/// Another value within a field's bound; the same value where there is none to be found.
template <class T>
[[nodiscard]] T changed(const T& value, const Bound& bound) {
  if constexpr (std::same_as<T, bool>) {
    return !value;
  } else if constexpr (std::is_arithmetic_v<T>) {
    for (const double other : {static_cast<double>(value) / 2.0, static_cast<double>(value) + 1.0, bound.upper, bound.lower}) {
      const auto candidate = static_cast<T>(std::isfinite(other) ? other : static_cast<double>(value));
      const auto number = static_cast<double>(candidate);
      const bool inside = (bound.lower_excluded ? number > bound.lower : number >= bound.lower) && number <= bound.upper;
      if (inside && candidate != value) return candidate;
    }
    return value;
  } else if constexpr (NamedEnum<T>) {
    return static_cast<T>((static_cast<std::size_t>(value) + 1) % enum_names(value).size());
  } else {
    return value;
  }
}

/// Changes every number, those of parts included.
template <class Params>
void change_all(Params& params) {
  for_each_field(params, []<class T>(const auto& f, T& value) {
    if constexpr (HasFields<T>) {
      change_all(value);
    } else if constexpr (!std::is_empty_v<T>) {
      value = changed(value, f.bound);
    }
  });
}

/// Made from numbers that are all changed, a policy with a public member `params` holds them. Whether a policy without one uses
/// what it was made from cannot be seen from outside.
template <class Policy>
void check_kept() {
  ParamsOf<Policy> params{};
  change_all(params);
  CHECK_NOTHROW(static_cast<void>(make_policy<Policy>(params)));
  if constexpr (requires(const Policy& policy) { first_difference(policy.params, params); }) {
    CHECK(first_difference(make_policy<Policy>(params).params, params) == "");
    CHECK(first_difference(make_policy<Policy>({}).params, ParamsOf<Policy>{}) == "");
  }
}

/// All that a policy says, number by number, so that two policies can be distinguished.
class Answers {
 public:
  template <class T>
  void add(const T& said) {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      numbers_.push_back(static_cast<double>(said));
    } else if constexpr (std::same_as<T, Ancestor>) {
      add(said.id);
    } else if constexpr (HasFields<T>) {
      for_each_field(said, [&](const auto&, const auto& member) { add(member); });
    } else if constexpr (requires { said.has_value(); }) {
      add(said.has_value());
      if (said) add(*said);
    } else if constexpr (requires { said.begin(); }) {
      add(said.size());
      for (const auto& one : said) add(one);
    } else if constexpr (requires { said.first; }) {
      add(said.first);
      add(said.second);
    }
  }
  friend bool operator==(const Answers&, const Answers&) = default;

 private:
  std::vector<double> numbers_;
};

/// States that a policy keeps for individuals that are born, walk, catch, are caught and see others.
template <class Policy>
void add_states(Answers& answers, const Policy& policy, const test::HandPopulation& robots) {
  if constexpr (Stateful<Policy>) {
    const View view = robots.view();
    const std::array apart{robots, spread(robots, 2.0), spread(robots, 3.0)};
    for (BodyIndex body = 0; body < robots.individuals.size(); ++body) {
      auto own = policy.born(robots.individuals[body], nullptr, StateOf<Policy>{});
      answers.add(own);
      if constexpr (requires { policy.on_walk(own, body, 1.0, view); }) {
        for (const test::HandPopulation& walked : apart) policy.on_walk(own, body, 1.0, walked.view());
      }
      answers.add(own);
      if constexpr (requires { policy.on_catch(own, body, body, view); }) policy.on_catch(own, body, body, view);
      if constexpr (requires { policy.on_caught(own, body, body, view); }) policy.on_caught(own, body, body, view);
      if constexpr (requires { policy.on_offspring(own, body, body, view); }) policy.on_offspring(own, body, body, view);
      const Vacancy death{.body = 0, .cause = Cause::starved};
      if constexpr (requires { policy.on_other_death(own, body, death, view); }) policy.on_other_death(own, body, death, view);
      const std::optional<Sighting> seen = Sighting{.self = body, .adversary = 0, .distance_m = 2.0, .bearing_rad = 0.5};
      if constexpr (requires { policy.on_sighting(own, body, seen, view); }) policy.on_sighting(own, body, seen, view);
      answers.add(own);
    }
  }
}

/// Other values of a number, near and far, within its bound.
template <class T>
[[nodiscard]] std::vector<T> other_values(const T& value, const Bound& bound) {
  std::vector<T> others;
  if constexpr (std::same_as<T, bool>) {
    others.push_back(!value);
  } else if constexpr (std::is_arithmetic_v<T>) {
    const auto number = static_cast<double>(value);
    for (const double other : {number / 2.0, number * 2.0, number + 1.0, number - 1.0, number / 10.0, number * 10.0,
                               number + 100.0, -number, bound.upper, bound.lower}) {
      const bool inside = (bound.lower_excluded ? other > bound.lower : other >= bound.lower) && other <= bound.upper;
      if (std::isfinite(other) && inside && std::abs(other) < 1e6 && static_cast<T>(other) != value) {
        others.push_back(static_cast<T>(other));
      }
    }
  } else if constexpr (NamedEnum<T>) {
    for (std::size_t one = 0; one < enum_names(value).size(); ++one) {
      if (static_cast<T>(one) != value) others.push_back(static_cast<T>(one));
    }
  }
  return others;
}

namespace detail {

/// Each number of `part`, which is `params` or a part of it, changes what the policy says.
template <class Policy, class Part, class AnswersOf>
void check_numbers_used(ParamsOf<Policy>& params, Part& part, const Answers& usual, AnswersOf& answers_of) {
  for_each_field(part, [&](const auto& f, auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (HasFields<T>) {
      CAPTURE(f.name);
      return check_numbers_used<Policy>(params, value, usual, answers_of);
    } else if constexpr (!std::is_empty_v<T>) {
      const T before = value;
      const std::vector<T> others = other_values(before, f.bound);
      bool used = others.empty();
      for (auto other = others.begin(); !used && other != others.end(); ++other) {
        value = *other;
        try {
          used = !(answers_of(make_policy<Policy>(params)) == usual);
        } catch (const std::exception&) {  // a value that does not go with the others is used, too, but shows no answer
        }
      }
      value = before;
      CAPTURE(f.name);
      CHECK(used);
    }
  });
}

}  // namespace detail

/// Each number of a policy changes what it says, for some other value: a manifest names none on which nothing depends.
/// `answers_of(policy)`: all that it says.
template <class Policy, class AnswersOf>
void check_params_used(AnswersOf&& answers_of) {
  const Answers usual = answers_of(defaulted<Policy>());
  CHECK((answers_of(defaulted<Policy>()) == usual));  // and another one of the same parameters says the same
  ParamsOf<Policy> params{};
  detail::check_numbers_used<Policy>(params, params, usual, answers_of);
}

/// The same for a policy that is asked about populations: `ask(answers, policy, robots, seed)` adds what it says of one. Its
/// states are answers, too.
template <class Policy, class Ask>
void check_params_used_on_populations(Ask&& ask) {
  check_params_used<Policy>([&](const Policy& made) {
    Answers answers;
    on_populations<Policy>([&](const test::HandPopulation& robots, std::uint64_t seed) {
      add_states(answers, made, robots);
      ask(answers, made, robots, seed);
    });
    return answers;
  });
}

/// Its name is written as in configuration files, it lists all its numbers and holds those it is made from, its default numbers
/// are within their bounds, and each number that is not finite or below its bound is an error that names it.
template <class Policy>
void check_policy() {
  const std::string_view name = Policy::name;
  CHECK_FALSE(name.empty());
  constexpr bool names_foods = requires {
    Policy::food_names;
  };
  const std::string_view between_parts = MadeOfParts<Policy> || names_foods ? ":, " : "";
  CHECK(std::ranges::all_of(name, [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || between_parts.find(c) != std::string_view::npos;
  }));

  using Params = ParamsOf<Policy>;
  static_assert(Parameters<Params>);
  static_assert(trophic::detail::members_of<Params> == trophic::detail::fields_of<Params> &&
                trophic::detail::listed_once<Params>());
  check_kept<Policy>();
  check_state<Policy>();
  CHECK_NOTHROW(validate(Params{}, name));
  Params params{};
  for_each_field(params, [&](const auto& f, auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    CAPTURE(f.name);
    if constexpr (std::floating_point<T>) {
      const T before = std::exchange(value, std::numeric_limits<T>::quiet_NaN());
      CHECK_THROWS_AS(validate(params, name), std::invalid_argument);
      if (std::isfinite(f.bound.lower)) {
        value = static_cast<T>(f.bound.lower - 1.0);
        CHECK_THROWS_AS(validate(params, name), std::invalid_argument);
      }
      value = before;
    } else if constexpr (std::signed_integral<T> && !std::same_as<T, bool>) {
      if (!std::isfinite(f.bound.lower)) return;
      const T before = std::exchange(value, static_cast<T>(f.bound.lower - 1.0));
      CHECK_THROWS_AS(validate(params, name), std::invalid_argument);
      value = before;
    }
  });
}

}  // namespace trophic::conformance
