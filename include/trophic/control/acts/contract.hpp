// SPDX-License-Identifier: MIT
// The contract of a slot: what robots can do; each act takes outputs of the brain.
#pragma once

#include <string_view>
#include <trophic/population/view.hpp>

#define TROPHIC_SENTENCE_ActList                                                                                                \
  "to be a control::acts::List<...>; each act needs a name, a unit, static constexpr std::size_t outputs, numbers least and "   \
  "most, by_default and static VALUE value(std::span<const double, outputs>), with VALUE double or bool as by_default has it; " \
  "see trophic/control/acts/contract.hpp"

namespace trophic::control {

/// One act of a robot: a type without data.
///
/// - `name` and `unit` of its value; its outputs are the columns NAME_output in senses.csv
/// - `outputs`: its number of output neurons
/// - `value(out)`: a pure function of these neurons: the value, a double in [least, most] or a bool. Networks return values in
/// (-1, 1), hand-written brains any number
/// - `by_default`: its value before the first decision of a life and in tables without the act
///
/// Rules read the value of the last decision: `view.act<acts::Eat>(body)`. A rule that needs an act declares it: `using ReadsActs
/// = control::acts::List<control::acts::Mate>;`; a table without that act then does not compile.
template <class A>
concept Act = std::is_empty_v<A> && requires(std::span<const double, A::outputs> out) {
  { A::name } -> std::convertible_to<std::string_view>;
  { A::unit } -> std::convertible_to<std::string_view>;
  typename std::bool_constant<(A::outputs > 0 && A::least <= A::by_default && A::by_default <= A::most)>;
  { A::value(out) } -> std::same_as<std::remove_cv_t<decltype(A::by_default)>>;
} &&(std::same_as<const double, decltype(A::by_default)> || std::same_as<const bool, decltype(A::by_default)> ||
     std::same_as<const int, decltype(A::by_default)>);

/// The slot holds an `acts::List<...>`; `outputs` is the number of all its output neurons.
template <class P>
concept ActList = requires {
  requires P::is_act_list;
};

namespace acts {

/// Shared by acts that are either done or not: an act is done if its output is positive.
struct YesOrNo {
  static constexpr std::string_view unit{};
  static constexpr std::size_t outputs = 1;
  static constexpr double least = 0.0;
  static constexpr double most = 1.0;
  [[nodiscard]] static bool value(std::span<const double, outputs> out) { return out[0] > 0.0; }
};

}  // namespace acts

}  // namespace trophic::control
