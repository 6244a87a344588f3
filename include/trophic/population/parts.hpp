// SPDX-License-Identifier: MIT
// A policy composed of policies.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <trophic/params/policy.hpp>
#include <tuple>
#include <utility>

namespace trophic {

/// Base class of a policy that is composed of policies. Such a policy is a template with the types of its parts as its only
/// parameters. It has `static constexpr std::array<std::string_view, N> part_names` and Params with one member for each part,
/// both in the same order, and `static constexpr bool parts_fit`: whether each part satisfies its contract. Parts have their own
/// states: the population treats each part as a separate rule under the name SLOT.PART. `with_part` (rules/with_part.hpp) swaps
/// one part.
template <class... Ps>
class Parts {
 public:
  static_assert((detail::CheckHeld<Ps>::ok && ...));
  static constexpr std::size_t part_count = sizeof...(Ps);
  template <std::size_t place>
  using Part = std::tuple_element_t<place, std::tuple<Ps...>>;

  template <std::size_t place>
  [[nodiscard]] const Part<place>& part() const {
    return std::get<place>(parts_);
  }

 protected:
  /// Constructs the parts from their parameters in `Params`.
  template <class Params>
  explicit Parts(const Params& given) : Parts{given, std::index_sequence_for<Ps...>{}} {}

 private:
  template <class Params, std::size_t... place>
  Parts(const Params& given, std::index_sequence<place...>)
      : parts_{make_policy<Ps>(given.*(std::get<place>(Params::fields()).member))...} {}

  std::tuple<Ps...> parts_;
};

/// A policy that derives from Parts.
template <class P>
concept MadeOfParts = requires {
  P::part_names;
  { P::part_count } -> std::convertible_to<std::size_t>;
};

namespace detail {

template <template <class...> class Whole, class... Ps>
requires MadeOfParts<Whole<Ps...>>
struct held_by<Whole<Ps...>> {
  using type = HeldWithParams<Parts<Ps...>, ParamsOf<Whole<Ps...>>>;
};

/// Joins three words per part, in order, for parts that are not of the type `LeftOut`.
template <class LeftOut, class... Ps>
constexpr auto part_words(std::string_view between, const std::array<std::array<std::string_view, 3>, sizeof...(Ps)>& words) {
  std::array<std::string_view, 4 * sizeof...(Ps)> all;
  auto end = all.begin();
  auto next = words.begin();
  const auto add = [&](bool is_named) {
    const auto& [first, second, third] = *next++;
    if (!is_named) return;
    for (const std::string_view word : {end == all.begin() ? "" : between, first, second, third}) *end++ = word;
  };
  (add(!std::same_as<Ps, LeftOut>), ...);
  return all;
}

/// "PART: POLICY, PART: POLICY" for those parts.
template <class LeftOut, class Names, class... Ps>
struct PartWords {
  static constexpr auto words = [] {
    auto name = Names::part_names.begin();
    return part_words<LeftOut, Ps...>(", ", {std::array<std::string_view, 3>{*name++, ": ", policy_name<Ps>()}...});
  }();
  static constexpr std::string_view separator{};
};

/// "SOURCE + SOURCE" for those parts.
template <class LeftOut, class... Ps>
struct PartSources {
  static constexpr auto words = part_words<LeftOut, Ps...>(" + ", {std::array<std::string_view, 3>{"", "", source_of<Ps>()}...});
  static constexpr std::string_view separator{};
};

}  // namespace detail

}  // namespace trophic
