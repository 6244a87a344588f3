// SPDX-License-Identifier: MIT
// A run's null model: the table's inheritance, or its substitute.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace trophic {

/// A metric that differs from the shadow's shows the effect of inheritance; a measure of genomes, bodies or brains that differs
/// from the neutral null's shows the effect of selection. In a world whose numbers change, a species' behaviour is compared with
/// that in the one-sided world: the same opponents evolve there, and it alone does not.
struct Null {
  enum Kind : std::uint8_t {
    none,       ///< the table's heredity
    shadow,     ///< the heredity rule is not applied: every inherited genome is drawn anew, so that nothing accumulates
    neutral,    ///< births, deaths and parents are those of a run, genomes others: nothing is selected (ecology/history.hpp)
    clones,     ///< all have the genome that the first founder draws, and none mutates: nothing can differ
    one_sided,  ///< the shadow of one species: its inherited genomes are drawn anew, all others inherit
  };

  // NOLINTNEXTLINE(google-explicit-constructor): a kind is a null
  Null(Kind its_kind = none, std::string of_species = {}) : kind{its_kind}, species{std::move(of_species)} {}

  Kind kind;
  std::string species;  ///< of one_sided: the name of the one that inherits nothing

  friend bool operator==(const Null&, const Null&) = default;
};

namespace detail {

inline constexpr std::array<std::string_view, 5> null_names{"none", "shadow", "neutral", "clones", "one_sided"};

}  // namespace detail

/// "shadow", or with its species "one_sided_prey": in plans, and as the folder of its runs in that of the experiment's.
[[nodiscard]] inline std::string name_of(const Null& null) {
  return std::string{detail::null_names.at(null.kind)} + (null.species.empty() ? "" : "_" + null.species);
}

/// The null of a name, of a species that a table may lack; none if it names no null.
[[nodiscard]] inline std::optional<Null> null_named(std::string_view name) {
  constexpr std::string_view one_sided = "one_sided_";
  if (name.starts_with(one_sided) && name != one_sided) return Null{Null::one_sided, std::string{name.substr(one_sided.size())}};
  const auto found = std::ranges::find(detail::null_names, name);
  const auto kind = static_cast<Null::Kind>(found - detail::null_names.begin());
  return found == detail::null_names.end() || kind == Null::one_sided ? std::nullopt : std::optional<Null>{kind};
}

}  // namespace trophic
