// SPDX-License-Identifier: MIT
// Parameters by their paths, by reference and by value, for configuration files and manifests.
#pragma once

#include <algorithm>
#include <span>
#include <trophic/params/params.hpp>
#include <variant>
#include <vector>

namespace trophic {

/// One parameter of a run (a number, switch or text) with its path, e.g. "rules.mutation.sd".
struct NamedParam {
  std::string path;
  std::variant<bool, std::int64_t, double, std::string> value;
  std::string help;
  Bound bound = {};  ///< bound of a number
  Read read = Read::at_any_tick;
  std::string no_effect = {};  ///< the reason for which it has none in this table on this backend; empty if it has one
  friend bool operator==(const NamedParam& a, const NamedParam& b) {
    return a.path == b.path && a.value == b.value && a.help == b.help;
  }
};
using NamedParams = std::vector<NamedParam>;

/// The value as text: numbers in their shortest exact form, texts unchanged.
[[nodiscard]] std::string value_text(const NamedParam& param);

/// A whole number of any type, or an enumerator as its index in `names`.
struct WholeRef {
  void* value;
  std::int64_t (*get)(const void* value);
  void (*set)(void* value, std::int64_t to);
  std::int64_t lowest;
  std::uint64_t largest;
  std::span<const std::string_view> names = {};  ///< names of an enumeration's values
};

/// A reference to a parameter in its Params struct; it has no target for a rule without parameters. Valid as long as the struct
/// exists.
struct ParamRef {
  std::string path;
  std::string_view help = {};
  Bound bound = {};
  std::variant<std::monostate, bool*, double*, std::string*, WholeRef> target = {};
  Read read = Read::at_any_tick;
};
using ParamRefs = std::vector<ParamRef>;

/// The values of parameters, in order.
[[nodiscard]] NamedParams named_params_of(const ParamRefs& params);

/// Throws std::invalid_argument "PATH = VALUE: must be ..." for the first parameter outside its bound, as `validate` does.
void validate(const ParamRefs& params);

/// Params that append their own references: void append_param_refs(std::string_view path, ParamRefs& params).
template <class P>
concept AppendsParamRefs = requires(P& params, ParamRefs& refs) {
  params.append_param_refs(std::string_view{}, refs);
};

namespace detail {

template <class T>
[[nodiscard]] WholeRef whole_ref(T& value) {
  WholeRef ref{.value = &value,
               .get = [](const void* of) { return static_cast<std::int64_t>(*static_cast<const T*>(of)); },
               .set = [](void* of, std::int64_t to) { *static_cast<T*>(of) = static_cast<T>(to); },
               .lowest = 0,
               .largest = 0};
  if constexpr (NamedEnum<T>) {
    static constexpr auto names = enum_names(T{});
    ref.names = names;
  } else {
    ref.lowest = static_cast<std::int64_t>(std::numeric_limits<T>::lowest());
    ref.largest = static_cast<std::uint64_t>(std::numeric_limits<T>::max());
  }
  return ref;
}

/// `read`: the latest moment of all of them.
template <class P>
void append_param_refs(P& params, std::string_view path, ParamRefs& refs, Read read = Read::at_any_tick);

struct AppendParamRef {
  std::string_view path;
  ParamRefs& refs;
  Read latest;

  template <class T>
  void operator()(const FieldText& f, T& value) const {
    std::string own = join_path(path, f.name);
    const Read read = std::min(f.read, latest);
    if constexpr (std::same_as<T, bool> || std::same_as<T, double> || std::same_as<T, std::string>) {
      refs.push_back({std::move(own), f.help, f.bound, &value, read});
    } else if constexpr (std::integral<T> || NamedEnum<T>) {
      refs.push_back({std::move(own), f.help, f.bound, whole_ref(value), read});
    } else if constexpr (AppendsParamRefs<T>) {
      value.append_param_refs(own, refs);
    } else {
      append_param_refs(value, own, refs, read);
    }
  }
};

template <class P>
void append_param_refs(P& params, std::string_view path, ParamRefs& refs, Read read) {
  static_assert(OpenParams<P>, "Params must be an aggregate: public parameters, no constructor");
  static_assert(AllListed<members_of<P>, fields_of<P>>,
                "Params must list every parameter in fields(); see trophic/params/params.hpp");
  static_assert(listed_once<P>(), "Params must list no parameter and no name twice in fields()");
  if constexpr (std::is_empty_v<P>) {
    refs.push_back({std::string{path}, {}, {}, {}});
  } else {
    for_each_field(params, AppendParamRef{path, refs, read});
  }
}

}  // namespace detail

/// References to all fields of a Params struct, including nested ones, in order.
template <class P>
[[nodiscard]] ParamRefs param_refs(P& params) {
  ParamRefs refs;
  detail::append_param_refs(params, "", refs);
  return refs;
}

/// All fields of a Params struct, including nested ones, in order.
template <class P>
[[nodiscard]] NamedParams named_params_of(P params) {
  return named_params_of(param_refs(params));
}

/// FNV-1a (64 bits) of a text, as 16 hexadecimal digits.
[[nodiscard]] std::string hash_text(std::string_view text);

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/params/named_params.ipp>
#endif
