// SPDX-License-Identifier: MIT
// Construction of policies from their parameters.
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

}  // namespace detail

namespace detail {

/// Throws RuleError: the policy (in this slot, if given) holds another number under `path` than it was made from.
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
    if constexpr (requires { requires std::same_as<std::remove_cv_t<decltype(Policy::params)>, ParamsOf<Policy>>; }) {
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
