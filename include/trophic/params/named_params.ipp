// SPDX-License-Identifier: MIT
// Definitions of named_params.hpp.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <trophic/params/named_params.hpp>
#include <type_traits>
#include <utility>
#include <variant>

namespace trophic {

TROPHIC_INLINE std::string value_text(const NamedParam& param) {
  return std::visit(
      [](const auto& value) -> std::string {
        using T = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::same_as<T, bool>) {
          return value ? "true" : "false";
        } else if constexpr (std::same_as<T, std::string>) {
          return value;
        } else {
          return number_text(value);
        }
      },
      param.value);
}

TROPHIC_INLINE std::string hash_text(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  std::string digits(16, '0');
  for (std::size_t i = digits.size(); i-- > 0; hash >>= 4) digits[i] = "0123456789abcdef"[hash & 15U];
  return digits;
}

namespace detail {

TROPHIC_INLINE void add_named_param(NamedParams& named_params, std::string_view path, const FieldText& field, bool value) {
  named_params.push_back({join_path(path, field.name), value, std::string{field.help}});
}
TROPHIC_INLINE void add_named_param(NamedParams& named_params, std::string_view path, const FieldText& field,
                                    std::int64_t value) {
  named_params.push_back({join_path(path, field.name), value, std::string{field.help}, field.bound});
}
TROPHIC_INLINE void add_named_param(NamedParams& named_params, std::string_view path, const FieldText& field, double value) {
  named_params.push_back({join_path(path, field.name), value, std::string{field.help}, field.bound});
}
TROPHIC_INLINE void add_named_param(NamedParams& named_params, std::string_view path, const FieldText& field,
                                    std::string_view value) {
  named_params.push_back({join_path(path, field.name), std::string{value}, std::string{field.help}});
}

}  // namespace detail

}  // namespace trophic
