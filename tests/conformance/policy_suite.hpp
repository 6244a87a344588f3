// SPDX-License-Identifier: MIT
// What every rule must be, whatever its kind: named, without state, its numbers listed and checked.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <support/hand_population.hpp>
#include <trophic/params.hpp>
#include <trophic/rng.hpp>
#include <trophic/rules.hpp>
#include <type_traits>
#include <utility>

namespace trophic::conformance {

/// Seeds of the populations and streams that each suite goes through.
inline constexpr std::array<std::uint64_t, 8> seeds{1, 2, 3, 4, 5, 6, 7, 8};

/// Runs `check` on crowded and on spread populations of two and of three species, and on an empty one.
template <class Check>
void on_populations(Check&& check) {
  for (const std::uint64_t seed : seeds) {
    CAPTURE(seed);
    check(test::random_population(seed, 30), seed);
    check(test::random_population(seed, 30, test::predator_prey_web(), 2.0), seed);
    check(test::random_population(seed, 30, test::chain_web(), 3.0), seed);
    check(test::random_population(seed, seed, test::chain_web()), seed);
  }
  check(test::HandPopulation{{}}, std::uint64_t{1});
}

/// `ask(rng)` gives the same from equal streams and again: no state, no other source of randomness.
template <class Ask>
auto asked_twice(std::uint64_t seed, Ask&& ask) {
  Rng first{seed, Stream::user};
  Rng second{seed, Stream::user};
  const auto answer = ask(first);
  CHECK((answer == ask(second)));
  CHECK(first.bits() == second.bits());
  return answer;
}

/// A policy with its default numbers.
template <class Policy>
[[nodiscard]] const Policy defaulted() {
  return make_policy<Policy>({});
}

/// Its name is written as in configuration files, its default numbers are within their bounds, and each number that is not finite
/// or below its bound is an error that names it.
template <class Policy>
void check_policy() {
  const std::string_view name = Policy::name;
  CHECK_FALSE(name.empty());
  CHECK(std::ranges::all_of(name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; }));

  using Params = ParamsOf<Policy>;
  static_assert(Parameters<Params>);
  CHECK_NOTHROW(validate(Params{}, name));
  Params params{};
  for_each_field(params, [&](const auto& f, auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    CAPTURE(f.name);
    CHECK_FALSE(f.help.empty());
    if constexpr (std::floating_point<T>) {
      const T before = std::exchange(value, std::numeric_limits<T>::quiet_NaN());
      CHECK_THROWS_AS(validate(params, name), std::invalid_argument);
      if (std::isfinite(f.bound.lower)) {
        value = static_cast<T>(f.bound.lower - 1.0);
        CHECK_THROWS_AS(validate(params, name), std::invalid_argument);
      }
      value = before;
    } else if constexpr (std::signed_integral<T> && !std::same_as<T, bool>) {
      const T before = std::exchange(value, static_cast<T>(f.bound.lower - 1.0));
      CHECK_THROWS_AS(validate(params, name), std::invalid_argument);
      value = before;
    }
  });
}

}  // namespace trophic::conformance
