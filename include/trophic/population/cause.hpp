// SPDX-License-Identifier: MIT
// Causes of death: those of the library's rules, and any that a rule names.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>

namespace trophic {

/// Why an individual died: one of these, or a cause that a rule names (`cause_named`). `diverged`: the engine could not compute
/// the motion of its body.
enum class Cause : std::uint16_t { caught, starved, sacrificed, senescence, diverged };

/// The library's own causes.
[[nodiscard]] constexpr std::array<std::string_view, 5> enum_names(Cause) {
  return {"caught", "starved", "sacrificed", "senescence", "diverged"};
}

namespace detail {

/// The causes that rules in this process have named, after the library's own.
struct NamedCauses {
  std::mutex mutex = {};
  std::deque<std::string> names = {};  ///< never moved
};
[[nodiscard]] inline NamedCauses& named_causes() {
  static NamedCauses all;
  return all;
}

}  // namespace detail

/// Whether a name is valid in tables: lower-case letters, digits and underscores.
[[nodiscard]] constexpr bool is_cause_name(std::string_view name) {
  const auto fits = [](char one) { return (one >= 'a' && one <= 'z') || (one >= '0' && one <= '9') || one == '_'; };
  return !name.empty() && name.size() <= 40 && std::ranges::all_of(name, fits);
}

/// The cause with this name; thread-safe. Its number may differ between processes, its name does not. Throws
/// std::invalid_argument for a name that is invalid in tables.
[[nodiscard]] inline Cause cause_named(std::string_view name) {
  constexpr auto own = enum_names(Cause{});
  if (const auto found = std::ranges::find(own, name); found != own.end()) return static_cast<Cause>(found - own.begin());
  if (!is_cause_name(name)) {
    throw std::invalid_argument{"cause of death \"" + std::string{name.substr(0, 40)} +
                                "\": must be 1 to 40 lower-case letters, digits and underscores"};
  }
  detail::NamedCauses& all = detail::named_causes();
  const std::lock_guard lock{all.mutex};
  auto found = std::ranges::find(all.names, name);
  if (found == all.names.end()) found = all.names.emplace(all.names.end(), name);
  return static_cast<Cause>(static_cast<std::size_t>(found - all.names.begin()) + own.size());
}

/// The name of a cause, as in tables.
[[nodiscard]] inline std::string_view enum_name(Cause cause) {
  constexpr auto own = enum_names(Cause{});
  const auto number = static_cast<std::size_t>(cause);
  if (number < own.size()) return own[number];
  detail::NamedCauses& all = detail::named_causes();
  const std::lock_guard lock{all.mutex};
  return all.names.at(number - own.size());
}

}  // namespace trophic
