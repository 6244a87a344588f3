// SPDX-License-Identifier: MIT
// Numbers as (path, value) pairs: what configuration files set and manifests echo.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <trophic/params/params.hpp>
#include <type_traits>
#include <variant>
#include <vector>

namespace trophic {

/// One number, switch or text of a run with the path by which it is set, e.g. "rules.mutation.sd".
struct Setting {
  std::string path;
  std::variant<bool, std::int64_t, double, std::string> value;
  std::string help;
  friend bool operator==(const Setting&, const Setting&) = default;
};
using Settings = std::vector<Setting>;

/// The value as text: numbers in their shortest exact form, texts as they are.
[[nodiscard]] inline std::string value_text(const Setting& setting) {
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
      setting.value);
}

namespace detail {

template <class P>
void append_settings(const P& params, std::string_view path, Settings& settings) {
  static_assert(OpenParams<P>, "Params must be an aggregate: public numbers, no constructor");
  static_assert(AllListed<members_of<P>, fields_of<P>>,
                "Params must list every number in fields(); see trophic/params/params.hpp");
  static_assert(listed_once<P>(), "Params must list no number and no name twice in fields()");
  for_each_field(params, [&](const auto& f, const auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    const std::string name = join_path(path, f.name);
    const auto add = [&](auto plain) { settings.push_back({name, plain, std::string{f.help}}); };
    if constexpr (std::same_as<T, bool>) {
      add(value);
    } else if constexpr (std::integral<T>) {
      add(static_cast<std::int64_t>(value));
    } else if constexpr (std::floating_point<T>) {
      add(static_cast<double>(value));
    } else if constexpr (NamedEnum<T>) {
      add(std::string{enum_name(value)});
    } else if constexpr (std::convertible_to<T, std::string>) {
      add(std::string{value});
    } else {
      append_settings(value, name, settings);
    }
  });
}

}  // namespace detail

/// Every field of a Params struct, nested ones included, in order.
template <class P>
[[nodiscard]] Settings settings_of(const P& params) {
  Settings settings;
  detail::append_settings(params, "", settings);
  return settings;
}

/// FNV-1a (64 bits) of a text, as 16 hexadecimal digits.
[[nodiscard]] inline std::string hash_text(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  std::string digits(16, '0');
  for (std::size_t i = digits.size(); i-- > 0; hash >>= 4) digits[i] = "0123456789abcdef"[hash & 15U];
  return digits;
}

}  // namespace trophic
