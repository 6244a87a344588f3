// SPDX-License-Identifier: MIT
// Numbers as (path, value) pairs, for configuration files and manifests.
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

/// One number, switch or text of a run with its path, e.g. "rules.mutation.sd".
struct NamedParam {
  std::string path;
  std::variant<bool, std::int64_t, double, std::string> value;
  std::string help;
  Bound bound = {};  ///< of a number
  friend bool operator==(const NamedParam& a, const NamedParam& b) {
    return a.path == b.path && a.value == b.value && a.help == b.help;
  }
};
using NamedParams = std::vector<NamedParam>;

/// The value as text: numbers in their shortest exact form, texts unchanged.
[[nodiscard]] std::string value_text(const NamedParam& param);

namespace detail {

void add_named_param(NamedParams& named_params, std::string_view path, const FieldText& field, bool value);
void add_named_param(NamedParams& named_params, std::string_view path, const FieldText& field, std::int64_t value);
void add_named_param(NamedParams& named_params, std::string_view path, const FieldText& field, double value);
void add_named_param(NamedParams& named_params, std::string_view path, const FieldText& field, std::string_view value);

template <class P>
void append_named_params(const P& params, std::string_view path, NamedParams& named_params);

struct AppendNamedParam {
  std::string_view path;
  NamedParams& named_params;

  template <class T>
  void operator()(const FieldText& f, const T& value) const {
    const auto add = [&](auto plain) { add_named_param(named_params, path, f, plain); };
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
    } else if constexpr (!std::is_empty_v<T>) {
      append_named_params(value, join_path(path, f.name), named_params);
    }
  }
};

template <class P>
void append_named_params(const P& params, std::string_view path, NamedParams& named_params) {
  static_assert(OpenParams<P>, "Params must be an aggregate: public numbers, no constructor");
  static_assert(AllListed<members_of<P>, fields_of<P>>,
                "Params must list every number in fields(); see trophic/params/params.hpp");
  static_assert(listed_once<P>(), "Params must list no number and no name twice in fields()");
  for_each_field(params, AppendNamedParam{path, named_params});
}

}  // namespace detail

/// Every field of a Params struct, nested ones included, in order.
template <class P>
[[nodiscard]] NamedParams named_params_of(const P& params) {
  NamedParams named_params;
  detail::append_named_params(params, "", named_params);
  return named_params;
}

/// FNV-1a (64 bits) of a text, as 16 hexadecimal digits.
[[nodiscard]] std::string hash_text(std::string_view text);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/params/named_params.ipp>
#endif
