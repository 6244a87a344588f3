// SPDX-License-Identifier: MIT
// Numbers as (path, value) pairs: what configuration files set and manifests echo.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <trophic/params/params.hpp>
#include <trophic/support/linkage.hpp>
#include <type_traits>
#include <utility>
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
[[nodiscard]] std::string value_text(const Setting& setting);

namespace detail {

void add_setting(Settings& settings, std::string_view path, std::string_view name, std::string_view help, bool value);
void add_setting(Settings& settings, std::string_view path, std::string_view name, std::string_view help, std::int64_t value);
void add_setting(Settings& settings, std::string_view path, std::string_view name, std::string_view help, double value);
void add_setting(Settings& settings, std::string_view path, std::string_view name, std::string_view help, std::string_view value);

template <class P>
void append_settings(const P& params, std::string_view path, Settings& settings) {
  static_assert(OpenParams<P>, "Params must be an aggregate: public numbers, no constructor");
  static_assert(AllListed<members_of<P>, fields_of<P>>,
                "Params must list every number in fields(); see trophic/params/params.hpp");
  static_assert(listed_once<P>(), "Params must list no number and no name twice in fields()");
  for_each_field(params, [&](const auto& f, const auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    const auto add = [&](auto plain) { add_setting(settings, path, f.name, f.help, plain); };
    if constexpr (std::same_as<T, bool>) {
      add(value);
    } else if constexpr (std::integral<T>) {
      add(static_cast<std::int64_t>(value));
    } else if constexpr (std::floating_point<T>) {
      add(static_cast<double>(value));
    } else if constexpr (NamedEnum<T>) {
      add(enum_name(value));
    } else if constexpr (std::convertible_to<T, std::string_view>) {
      add(std::string_view{value});
    } else {
      append_settings(value, join_path(path, f.name), settings);
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
[[nodiscard]] std::string hash_text(std::string_view text);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/params/settings.ipp>
#endif
