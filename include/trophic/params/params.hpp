// SPDX-License-Identifier: MIT
// Parameters of a rule. Each Params struct lists its fields once, with bounds; validation, configuration files and manifests read
// that list.
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <trophic/params/detail/member_count.hpp>
#include <trophic/support/linkage.hpp>
#include <tuple>
#include <type_traits>
#include <utility>

namespace trophic {

/// The closed or open interval in which a number must lie.
struct Bound {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_excluded = false;
};

[[nodiscard]] constexpr Bound at_least(double lower) {
  return {.lower = lower};
}
[[nodiscard]] constexpr Bound above(double lower) {
  return {.lower = lower, .lower_excluded = true};
}
[[nodiscard]] constexpr Bound between(double lower, double upper) {
  return {.lower = lower, .upper = upper};
}
[[nodiscard]] constexpr Bound above_to(double lower, double upper) {
  return {.lower = lower, .upper = upper, .lower_excluded = true};
}
[[nodiscard]] constexpr Bound any_number() {
  return {};
}
/// Seeds up to 2^53, which every JSON reader represents exactly.
[[nodiscard]] constexpr Bound any_seed() {
  return between(0.0, 9007199254740992.0);
}

/// When a run reads a parameter for the last time, so that a later change of it has no effect.
enum class Read {
  at_start,       ///< for founders, or for the world as it begins
  for_newcomers,  ///< for founders, and at births without a parent
  at_birth,       ///< for founders, and at births
  at_any_tick
};

/// Description of a member of a Params struct. `help` is the line that `--print-config` prints next to it.
struct FieldText {
  std::string_view name;
  Bound bound = {};
  std::string_view help = {};
  Read read = Read::at_any_tick;
};

/// One named member of a Params struct. `field(...).read_at_start()` declares when a run reads it; the default is at any tick.
template <class Owner, class T>
struct Field : FieldText {
  T Owner::*member;

  [[nodiscard]] constexpr Field read_at_start() const { return when(Read::at_start); }
  [[nodiscard]] constexpr Field read_for_newcomers() const { return when(Read::for_newcomers); }
  [[nodiscard]] constexpr Field read_at_birth() const { return when(Read::at_birth); }

 private:
  [[nodiscard]] constexpr Field when(Read moment) const {
    Field same = *this;
    same.read = moment;
    return same;
  }
};

/// A number with its bound.
template <class Owner, class T>
[[nodiscard]] constexpr Field<Owner, T> field(std::string_view name, T Owner::*member, Bound bound, std::string_view help = {}) {
  return {{name, bound, help}, member};
}

/// A switch, a text, an enumeration (declare `constexpr std::array<std::string_view, N> enum_names(E)`) or a nested Params.
template <class Owner, class T>
[[nodiscard]] constexpr Field<Owner, T> field(std::string_view name, T Owner::*member, std::string_view help = {}) {
  return {{name, Bound{}, help}, member};
}

/// A struct that lists its fields: `static constexpr auto fields() { return std::tuple{field("max_age_s", &Params::max_age_s,
/// above(0))}; }`.
template <class P>
concept ListsFields = requires {
  std::tuple_size<decltype(P::fields())>::value;
};

namespace detail {

struct AnyVisitor {
  template <class T>
  void operator()(const FieldText&, T&) const {}
};

}  // namespace detail

/// A struct that itself calls `visit(FieldText, member)` for each of its members. Used for structs that differ between rule
/// tables, for which fields() would be compiled once per table.
template <class P>
concept VisitsFields = requires(P& params, detail::AnyVisitor visit) {
  P::visit_fields(params, visit);
};

template <class P>
concept HasFields = ListsFields<P> || VisitsFields<P>;

/// Requirements on the Params of a policy: empty, or with every parameter listed, so that none can be missing from a
/// manifest.
template <class P>
concept Parameters = std::is_empty_v<P> || HasFields<P>;

namespace detail {

/// `members` is the number of members, `listed` the number of entries of fields(); the compiler's message contains both.
template <std::size_t members, std::size_t listed>
concept AllListed = members == listed;

/// Whether fields() lists each member and each name at most once.
template <class P>
[[nodiscard]] consteval bool listed_once() {
  if constexpr (ListsFields<P>) {
    const auto same = [](const auto& a, const auto& b) {
      if constexpr (std::same_as<decltype(a.member), decltype(b.member)>) return a.name == b.name || a.member == b.member;
      return a.name == b.name;
    };
    const auto alone = [&](const auto&... all) {
      [[maybe_unused]] const auto count = [&](const auto& one) { return (0 + ... + (same(one, all) ? 1 : 0)); };
      return ((count(all) == 1) && ...);
    };
    return std::apply(alone, P::fields());
  }
  return true;
}

template <class P>
inline constexpr std::size_t fields_of = 0;
template <ListsFields P>
inline constexpr std::size_t fields_of<P> = std::tuple_size_v<decltype(P::fields())>;

/// The number of listed fields if fields() is missing or P is not an aggregate: both have their own error messages.
template <class P>
inline constexpr std::size_t members_of = fields_of<P>;
template <ListsFields P>
requires std::is_aggregate_v<P>
inline constexpr std::size_t members_of<P> = member_count<P>();

template <class P>
concept OpenParams = !ListsFields<P> || std::is_aggregate_v<P>;

}  // namespace detail

template <class E>
concept NamedEnum = std::is_enum_v<E> && requires(E e) {
  enum_names(e).size();
};

/// The name of an enumerator, as in configuration files.
template <NamedEnum E>
[[nodiscard]] constexpr std::string_view enum_name(E value) {
  return enum_names(value).at(static_cast<std::size_t>(value));
}

/// Calls `visit(field, value)` for each field in order; does nothing for an empty struct.
template <class P, class Visitor>
constexpr void for_each_field(P& params, Visitor&& visit) {
  using Plain = std::remove_const_t<P>;
  static_assert(Parameters<Plain>, "Params must be empty or list every parameter in fields(); see trophic/params/params.hpp");
  if constexpr (VisitsFields<Plain>) {
    Plain::visit_fields(params, visit);
  } else if constexpr (ListsFields<Plain>) {
    constexpr auto fields = Plain::fields();
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (visit(std::get<I>(fields), params.*(std::get<I>(fields).member)), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<decltype(fields)>>{});
  }
}

/// The shortest text that reads back as the same number.
template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] std::string number_text(Number value) {
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

/// The condition of a bound as text: "must be > 0 and <= 1".
[[nodiscard]] std::string bound_text(const Bound& bound);

[[nodiscard]] std::string join_path(std::string_view prefix, std::string_view name);

namespace detail {

/// Returns false for numbers that are not finite. Whole numbers are compared as such, even beyond 2^53.
template <class Number>
[[nodiscard]] constexpr bool within(Number number, const Bound& bound) {
  const auto value = static_cast<double>(number);
  const bool above_lower = bound.lower_excluded ? value > bound.lower : value >= bound.lower;
  if constexpr (std::integral<Number>) {
    if (value == bound.upper && value < 0x1p63 && std::cmp_greater(number, static_cast<std::int64_t>(bound.upper))) return false;
  }
  return above_lower && value <= bound.upper && value - value == 0.0;
}

/// Throws std::invalid_argument "PREFIX.NAME = TEXT: must be ...".
[[noreturn]] void reject_number(std::string_view prefix, std::string_view name, double value, const std::string& text,
                                const Bound& bound);

}  // namespace detail

template <class P>
void validate(const P& params, std::string_view path);

namespace detail {

struct Validate {
  std::string_view path;

  template <class T>
  void operator()(const FieldText& f, const T& value) const {
    if constexpr (HasFields<T>) {
      validate(value, join_path(path, f.name));
    } else if constexpr (std::is_arithmetic_v<T> && !std::same_as<T, bool>) {
      if (!within(value, f.bound)) reject_number(path, f.name, static_cast<double>(value), number_text(value), f.bound);
    }
  }
};

}  // namespace detail

/// Throws std::invalid_argument "PATH = VALUE: must be ..." for the first field, including nested ones, outside its bound; a
/// number that is not finite is outside every bound.
template <class P>
void validate(const P& params, std::string_view path) {
  for_each_field(params, detail::Validate{path});
}

/// The path of the first number, including nested ones, in which two Params differ; empty if they are equal.
template <class P>
[[nodiscard]] std::string first_difference(const P& a, const P& b, std::string_view path = "") {
  std::string found;
  for_each_field(a, [&](const auto& f, const auto& value) {
    if (!found.empty()) return;
    const auto& other = b.*(f.member);
    if constexpr (HasFields<std::remove_cvref_t<decltype(value)>>) {
      found = first_difference(value, other, join_path(path, f.name));
    } else if constexpr (requires { value == other; }) {
      if (!(value == other)) found = join_path(path, f.name);
    }
  });
  return found;
}

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/params/params.ipp>
#endif
