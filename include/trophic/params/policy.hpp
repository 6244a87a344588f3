// SPDX-License-Identifier: MIT
// Construction of policies from their parameters. A policy holds only its parameters, so the manifest describes it completely:
//   struct OldAge { struct Params { ...; static constexpr auto fields() { ... } }; Params params; ... };
// or it is empty. Data that changes during a run belongs in a State (population/state.hpp), which the population stores and
// saves. Other members, structs with other names and mutable members do not compile. A library cannot detect static variables, in
// a class or a function, or mutable members of Params with texts or optional numbers; the conformance suites find the former.
#pragma once

#include <trophic/params/params.hpp>

namespace trophic {

/// The Params of a policy without parameters.
struct NoParams {
  friend bool operator==(const NoParams&, const NoParams&) = default;
};

namespace detail {

template <class Policy>
struct params_of {
  using type = NoParams;
};
template <class Policy>
requires requires {
  typename Policy::Params;
}
struct params_of<Policy> {
  using type = typename Policy::Params;
};

}  // namespace detail

/// The parameters of a policy: its nested Params, or NoParams.
template <class Policy>
using ParamsOf = typename detail::params_of<Policy>::type;

namespace detail {

/// A policy without parameters needs a default constructor; one with parameters must be constructible from them.
template <class Policy>
concept HasParams = !std::is_empty_v<ParamsOf<Policy>>;
template <class Policy>
concept MadeFromParams = requires(const ParamsOf<Policy>& params) {
  Policy{params};
};

template <class Policy>
concept Named = requires {
  { Policy::name } -> std::convertible_to<std::string_view>;
};

/// Empty for a policy without a name, which `CheckRules` reports.
template <class Policy>
[[nodiscard]] constexpr std::string_view policy_name() {
  if constexpr (Named<Policy>) return Policy::name;
  return {};
}

/// The type with the data of a policy: its Params. Specialised for policies that are composed of policies.
template <class Policy>
struct held_by {
  using type = ParamsOf<Policy>;
};
/// The data of a policy composed of policies: those policies in its base, and its Params.
template <class Base, class Params>
struct HeldWithParams : Base {
  Params params;
};

template <class Policy>
concept HasParamsMember = requires {
  requires std::same_as<std::remove_cv_t<decltype(Policy::params)>, ParamsOf<Policy>>;
};

/// A policy whose only data is `Params params;`, or that has no data. A further member would make it larger.
template <class Policy>
[[nodiscard]] consteval bool holds_params_only() {
  if constexpr (HasParamsMember<Policy>) return sizeof(Policy) == sizeof(typename held_by<Policy>::type);
  return !HasParams<Policy> && std::is_empty_v<Policy>;
}

template <auto>
struct TemplateArgument;
template <class T>
concept ConstantDefault = requires {
  typename std::bool_constant<(static_cast<void>(T{}), true)>;
};
/// A type of template arguments, as are structs of numbers without a mutable member.
template <class T>
concept IsTemplateArgument = std::is_arithmetic_v<T> || requires {
  typename TemplateArgument<T{}>;
};

/// Whether no member of a struct with fields() is mutable. Assumes so if a member's type cannot be a template argument, or if
/// the defaults are not constants.
template <class T>
[[nodiscard]] consteval bool has_no_mutable_member() {
  if constexpr (ListsFields<T>) {
    bool judged = ConstantDefault<T>;
    bool none = true;
    const auto judge = [&]<class Owner, class Member>(const Field<Owner, Member>&) {
      none = none && has_no_mutable_member<Member>();
      judged = judged && IsTemplateArgument<Member>;
    };
    std::apply([&](const auto&... fields) { (judge(fields), ...); }, T::fields());
    return none && (!judged || IsTemplateArgument<T>);
  }
  return true;
}

/// A policy whose parameters do not change during a run.
template <class Policy>
[[nodiscard]] consteval bool params_are_constant() {
  if constexpr (HasParamsMember<Policy>) {
    return std::is_const_v<std::remove_reference_t<decltype((std::declval<const Policy&>().params))>> &&
           has_no_mutable_member<ParamsOf<Policy>>();
  }
  return true;
}

/// Fails to compile with one message if a policy inside another policy has data outside its Params.
template <class Policy>
struct CheckHeld {
  static_assert(!std::is_class_v<Policy> || holds_params_only<Policy>(),
                "a sensor, or a policy in another policy, has data outside `Params params;`: parameters belong in `Params "
                "params;`, changing data in a State; see trophic/params/policy.hpp");
  static_assert(params_are_constant<Policy>(),
                "a sensor, or a policy in another policy, has mutable parameters: what changes is in a State; see "
                "trophic/params/policy.hpp");
  static constexpr bool ok = true;
};

/// Throws RuleError because the policy (in this slot, if given) has a number at `path` that differs from the one it was made
/// from.
[[noreturn]] void reject_policy(std::string_view policy, std::string_view slot, const std::string& path);

}  // namespace detail

/// The source of a policy: its optional `static constexpr std::string_view source`.
template <class Policy>
[[nodiscard]] constexpr std::string_view source_of() {
  if constexpr (requires { std::string_view{Policy::source}; }) return Policy::source;
  return {};
}

/// Returns a policy with these parameters. Throws RuleError if its public member `params` then holds other parameters, because
/// the manifest would not match the run.
template <class Policy>
[[nodiscard]] Policy make_policy([[maybe_unused]] const ParamsOf<Policy>& params, [[maybe_unused]] std::string_view slot = {}) {
  if constexpr (detail::HasParams<Policy>) {
    Policy policy{params};
    if constexpr (detail::HasParamsMember<Policy>) {
      const std::string lost = first_difference(params, policy.params);
      if (!lost.empty()) detail::reject_policy(detail::policy_name<Policy>(), slot, lost);
    }
    return policy;
  } else {
    return Policy{};
  }
}

}  // namespace trophic

#if TROPHIC_HEADER_ONLY
#include <trophic/params/policy.ipp>
#endif
