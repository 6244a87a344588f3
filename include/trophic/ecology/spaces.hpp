// SPDX-License-Identifier: MIT
// The names and bounds of what robots perceive and of what is decided for them.
#pragma once

#include <algorithm>
#include <limits>
#include <trophic/ecology/stepping.hpp>
#include <trophic/perception/sensors/list.hpp>
#include <trophic/perception/sensors/per_species.hpp>
#include <trophic/rules/table.hpp>

namespace trophic {

namespace detail {

/// The inputs of one species' brain.
template <class Sensors>
struct InputsOf;
template <class... Sensors>
struct InputsOf<perception::sensors::List<Sensors...>> {
  [[nodiscard]] static std::vector<Channel> of(Species) {
    std::vector<Channel> all;
    const auto add = [&]<class One>(std::type_identity<One>) {
      Channel one{.name = std::string{One::name}};
      if constexpr (requires { One::least <= One::most; }) one.least = One::least, one.most = One::most;
      for (std::size_t i = 0; i < One::size; ++i) {
        all.push_back(one);
        if (One::size > 1) all.back().name += "_" + std::to_string(i);
      }
    };
    (add(std::type_identity<Sensors>{}), ...);
    return all;
  }
};
template <class Community, class... Lists>
struct InputsOf<perception::sensors::PerSpeciesOf<Community, Lists...>> {
  [[nodiscard]] static std::vector<Channel> of(Species species) {
    return std::array{InputsOf<Lists>::of(species)...}.at(species);
  }
};

}  // namespace detail

/// The spaces of a table of so many species. Outputs of networks lie in [-1, 1]; a target angle that no rule of the brain changes
/// is in radians.
template <class Rules>
[[nodiscard]] Spaces spaces_of(std::size_t species, std::span<const int> tags) {
  using Brain = AnswersForSpecies<PolicyIn<Rules, RuleSlot::brain>>;
  using Acts = PolicyIn<Rules, RuleSlot::acts>;
  Spaces spaces;
  for (Species one = 0; one < species; ++one)
    spaces.inputs.push_back(detail::InputsOf<PolicyIn<Rules, RuleSlot::sensors>>::of(one));
  for (const std::string& name : Acts::output_names()) spaces.outputs.push_back({.name = name, .least = -1.0, .most = 1.0});
  std::size_t place = 0;
  Acts::each(std::array<double, Acts::outputs>{}, [&]<class One>(std::size_t, std::span<const double, One::outputs>) {
    Channel& channel = spaces.outputs[place];
    place += One::outputs;
    constexpr bool evaluates = control::EvaluatesOutputs<Brain>;
    if constexpr (std::same_as<One, control::acts::Turn> &&
                  !(evaluates && requires(const Brain b) { b.target_angle_rad(0.0); })) {
      channel = {.name = channel.name, .unit = std::string{One::unit}, .least = One::least, .most = One::most};
    } else if constexpr (std::same_as<One, control::acts::Tag> && !evaluates) {
      channel.least = *std::ranges::min_element(tags);
      channel.most = *std::ranges::max_element(tags);
    }
  });
  return spaces;
}

}  // namespace trophic
