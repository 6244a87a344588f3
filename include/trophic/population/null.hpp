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

/// The difference between a metric and the shadow's shows the effect of inheritance; for measures of genomes, bodies or brains,
/// the difference from the neutral null shows the effect of selection. If population sizes change, a species' behaviour is
/// compared with that in its one-sided world, where the opponents evolve but this species does not.
struct Null {
  enum Kind : std::uint8_t {
    none,     ///< the table's heredity
    shadow,   ///< the heredity rule is not applied: every inherited genome is drawn anew, so adaptations cannot accumulate
    neutral,  ///< births, deaths and parents are those of a run, but genomes are independent: no selection (ecology/history.hpp)
    clones,   ///< all have the first founder's genome, and none mutates: no variation
    one_sided,  ///< the shadow of one species: its inherited genomes are drawn anew, while all others inherit
  };

  // NOLINTNEXTLINE(google-explicit-constructor): a kind is a null
  Null(Kind its_kind = none, std::string of_species = {}) : kind{its_kind}, species{std::move(of_species)} {}

  Kind kind;
  std::string species;  ///< for one_sided: the name of the species that inherits nothing

  friend bool operator==(const Null&, const Null&) = default;
};

namespace detail {

inline constexpr std::array<std::string_view, 5> null_names{"none", "shadow", "neutral", "clones", "one_sided"};

}  // namespace detail

/// The name in plans and of the folder of its runs: "shadow" or, with its species, "one_sided_prey".
[[nodiscard]] inline std::string name_of(const Null& null) {
  return std::string{detail::null_names.at(null.kind)} + (null.species.empty() ? "" : "_" + null.species);
}

/// The null with this name, whose species a table may lack; empty if it is not the name of a null.
[[nodiscard]] inline std::optional<Null> null_named(std::string_view name) {
  constexpr std::string_view one_sided = "one_sided_";
  if (name.starts_with(one_sided) && name != one_sided) return Null{Null::one_sided, std::string{name.substr(one_sided.size())}};
  const auto found = std::ranges::find(detail::null_names, name);
  const auto kind = static_cast<Null::Kind>(found - detail::null_names.begin());
  return found == detail::null_names.end() || kind == Null::one_sided ? std::nullopt : std::optional<Null>{kind};
}

}  // namespace trophic
