// SPDX-License-Identifier: MIT
// The species and the feeding links between them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <trophic/support/cpp20.hpp>
#include <utility>
#include <vector>

namespace trophic {

/// Index of a species in its FoodWeb.
using Species = std::size_t;
using OneSpecies = std::optional<Species>;  ///< none: all

/// A link of the food web: `hunter` catches and eats `victim`.
struct Feeding {
  Species hunter;
  Species victim;
};

/// Any number of species and the feeding links between them. Small and immutable.
class FoodWeb {
 public:
  /// @throws std::invalid_argument for a link to a species without a name.
  FoodWeb(std::vector<std::string> names, std::vector<Feeding> links) : names_{std::move(names)}, links_{std::move(links)} {
    for (const Feeding& link : links_) {
      if (link.hunter >= names_.size() || link.victim >= names_.size()) {
        throw std::invalid_argument{"food web: link " + std::to_string(link.hunter) + " eats " + std::to_string(link.victim) +
                                    ": must be < " + std::to_string(names_.size()) + ", the number of species"};
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return names_.size(); }
  [[nodiscard]] const std::string& name(Species species) const { return names_.at(species); }
  [[nodiscard]] const std::vector<Feeding>& links() const { return links_; }

  [[nodiscard]] bool eats(Species hunter, Species victim) const {
    return std::ranges::any_of(links_, [&](const Feeding& l) { return l.hunter == hunter && l.victim == victim; });
  }
  /// Whether either species eats the other.
  [[nodiscard]] bool opponents(Species a, Species b) const { return eats(a, b) || eats(b, a); }
  [[nodiscard]] bool hunts(Species species) const {
    return std::ranges::any_of(links_, [&](const Feeding& l) { return l.hunter == species; });
  }
  [[nodiscard]] bool is_hunted(Species species) const {
    return std::ranges::any_of(links_, [&](const Feeding& l) { return l.victim == species; });
  }
  /// The first species that `hunter` eats; empty for a species that does not hunt.
  [[nodiscard]] std::optional<Species> first_victim(Species hunter) const {
    const auto link = std::ranges::find(links_, hunter, &Feeding::hunter);
    return link == links_.end() ? std::nullopt : std::optional{link->victim};
  }

 private:
  std::vector<std::string> names_;
  std::vector<Feeding> links_;
};

}  // namespace trophic
