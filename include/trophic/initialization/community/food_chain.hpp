// SPDX-License-Identifier: MIT
// A food chain of three species.
#pragma once

#include <trophic/initialization/community/contract.hpp>
#include <trophic/params/params.hpp>

namespace trophic::initialization::community {

/// Apex predators eat hunters, hunters eat grazers. Rule: of N bodies the first N - hunters - apex start as grazers, the next
/// `hunters` as hunters, the last `apex` as apex predators.   Reads: nothing.   Random draws: 0.
struct FoodChain {
  static constexpr std::string_view name = "food_chain";
  static constexpr std::string_view source = "not in the paper";
  static constexpr Species grazer = 0;
  static constexpr Species hunter = 1;
  static constexpr Species apex = 2;
  static constexpr std::array<std::string_view, 3> species_names{"grazer", "hunter", "apex"};

  struct Params {
    std::size_t hunters = 9;
    std::size_t apex = 7;
    static constexpr auto fields() {
      return std::tuple{field("hunters", &Params::hunters, at_least(0), "number of founders that eat grazers"),
                        field("apex", &Params::apex, at_least(0), "number of founders that eat hunters")};
    }
  };
  Params params;

  [[nodiscard]] FoodWeb web() const {
    return {{species_names.begin(), species_names.end()},
            {{.hunter = hunter, .victim = grazer}, {.hunter = apex, .victim = hunter}}};
  }

  [[nodiscard]] std::vector<Species> founders(std::size_t robots) const {
    check("hunters", params.hunters, robots, "the number of robots");
    check("apex", params.apex, robots - params.hunters, "the number of robots that are not hunters");
    std::vector<Species> species(robots - params.hunters - params.apex, grazer);
    species.insert(species.end(), params.hunters, hunter);
    species.insert(species.end(), params.apex, apex);
    return species;
  }

 private:
  static void check(const std::string& field, std::size_t value, std::size_t bound, const std::string& meaning) {
    if (value > bound) {
      throw std::invalid_argument{"rules.community." + field + " = " + std::to_string(value) +
                                  ": must be <= " + std::to_string(bound) + ", " + meaning};
    }
  }
};
static_assert(Community<FoodChain>);

}  // namespace trophic::initialization::community
