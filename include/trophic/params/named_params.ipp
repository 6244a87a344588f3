// SPDX-License-Identifier: MIT
// Definitions of named_params.hpp.
#pragma once

#include <cstddef>
#include <trophic/params/named_params.hpp>

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
          std::string text = number_text(value);
          const bool looks_whole = std::floating_point<T> && text.find_first_not_of("-0123456789") == std::string::npos;
          if (looks_whole && (text == "-0" || text.size() > 15)) text += ".0";  // TOML reads -0 as 0, and 64 bits
          return text;
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

TROPHIC_INLINE NamedParams named_params_of(const ParamRefs& params) {
  NamedParams named;
  const auto add = [&](const ParamRef& ref, auto value, Bound bound = {}) {
    named.push_back({ref.path, std::move(value), std::string{ref.help}, bound, ref.read});
  };
  for (const ParamRef& ref : params) {
    if (const auto* flag = std::get_if<bool*>(&ref.target)) add(ref, **flag);
    if (const auto* number = std::get_if<double*>(&ref.target)) add(ref, **number, ref.bound);
    if (const auto* text = std::get_if<std::string*>(&ref.target)) add(ref, **text);
    if (const auto* whole = std::get_if<WholeRef>(&ref.target)) {
      const std::int64_t value = whole->get(whole->value);
      if (whole->names.empty()) {
        add(ref, value, ref.bound);
      } else {
        add(ref, std::string{whole->names[static_cast<std::size_t>(value)]});
      }
    }
  }
  return named;
}

TROPHIC_INLINE void validate(const ParamRefs& params) {
  for (const ParamRef& ref : params) {
    const auto check = [&](auto number) {
      if (detail::within(number, ref.bound)) return;
      const std::size_t dot = ref.path.rfind('.');
      const std::string prefix = dot == std::string::npos ? "" : ref.path.substr(0, dot);
      detail::reject_number(prefix, ref.path.substr(dot + 1), static_cast<double>(number), number_text(number), ref.bound);
    };
    if (const auto* number = std::get_if<double*>(&ref.target)) check(**number);
    if (const auto* whole = std::get_if<WholeRef>(&ref.target); whole != nullptr && whole->names.empty())
      check(whole->get(whole->value));
  }
}

}  // namespace trophic
