// SPDX-License-Identifier: MIT
// All numbers in a value of any type, for the fingerprints of models.
#pragma once

#include <cstddef>
#include <ranges>
#include <trophic/params/params.hpp>

namespace trophic {

namespace detail {

template <class T>
concept MatrixLike = requires(T matrix) {
  matrix.rows();
  matrix.cols();
  matrix.data();
};

/// A quaternion is represented by its coefficients.
template <class T>
concept HasCoefficients = requires(T value) {
  value.coeffs().data();
};

template <class T>
concept OptionalLike = requires(T value) {
  value.has_value();
  *value;
};

}  // namespace detail

/// Calls `visit(number)` for each number in `value`, in a fixed order: structs by their fields(), then optionals, ranges,
/// matrices and quaternions by their elements. The number of elements is visited too, unless it is a constant. Texts and names
/// are skipped, because they do not affect a model's motion.
template <class T, class Visitor>
void for_each_number(T& value, Visitor&& visit) {
  using Plain = std::remove_const_t<T>;
  const auto count = [&](auto size) {
    const auto number = static_cast<std::size_t>(size);
    visit(number);
  };
  if constexpr (std::is_arithmetic_v<Plain>) {
    visit(value);
  } else if constexpr (std::convertible_to<Plain, std::string_view>) {
    return;
  } else if constexpr (HasFields<Plain>) {
    for_each_field(value, [&](const auto&, auto& member) { for_each_number(member, visit); });
  } else if constexpr (detail::OptionalLike<Plain>) {
    count(value.has_value() ? 1 : 0);
    if (value) for_each_number(*value, visit);
  } else if constexpr (detail::HasCoefficients<Plain>) {
    for (int i = 0; i < 4; ++i) visit(value.coeffs().data()[i]);
  } else if constexpr (detail::MatrixLike<Plain>) {
    count(value.rows());
    count(value.cols());
    for (decltype(value.size()) i = 0; i < value.size(); ++i) visit(value.data()[i]);
  } else {
    static_assert(std::ranges::sized_range<Plain>, "a struct needs fields() so that its parameters can be found");
    count(std::ranges::size(value));
    for (auto& element : value) for_each_number(element, visit);
  }
}

/// All numbers in a value as text: equal texts mean bitwise equal numbers, except for NaN.
template <class T>
[[nodiscard]] std::string numbers_text(const T& value) {
  std::string text;
  for_each_number(value, [&](const auto& number) { text += number_text(number) + " "; });
  return text;
}

}  // namespace trophic
