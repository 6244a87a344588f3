// SPDX-License-Identifier: MIT
// A list of sensors for each species.
#pragma once

#include <trophic/params/group.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/perception/sensors/list.hpp>
#include <trophic/population/species_names.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::perception::sensors {

template <class Community, class... Lists>
class PerSpeciesOf;

namespace detail {

template <class... Lists>
struct ListNames {
  static constexpr std::array<std::string_view, sizeof...(Lists)> words{Lists::name...};
  static constexpr std::string_view separator = " | ";
};

/// One list for each species.
template <class... Lists>
class ListsHeld {
 public:
  template <class Params>
  explicit ListsHeld(const Params& given) : ListsHeld{given, std::index_sequence_for<Lists...>{}} {}

 protected:
  /// Calls `visit(list, its place as an integral_constant)` for a species' list.
  template <class Visit>
  void of(Species species, const Visit& visit) const {
    [&]<std::size_t... place>(std::index_sequence<place...>) {
      ((place == species ? visit(std::get<place>(lists_), std::integral_constant<std::size_t, place>{}) : void()), ...);
    }
    (std::index_sequence_for<Lists...>{});
  }
  [[nodiscard]] const std::tuple<Lists...>& lists() const { return lists_; }

 private:
  template <class Params, std::size_t... place>
  ListsHeld(const Params& given, std::index_sequence<place...>)
      : lists_{make_policy<Lists>(given.template get<place>(), "sensors")...} {}

  std::tuple<Lists...> lists_;
};

/// For lists of which some have a State: the states of all lists, each under its species' name.
template <class Community, class... Lists>
class ListsWithStates : public ListsHeld<Lists...> {
 public:
  using ListsHeld<Lists...>::ListsHeld;
  using State = GroupOf<trophic::detail::SpeciesNames<Community>, StateOf<Lists>...>;

  [[nodiscard]] State born(const Individual& newborn, const State* parent, const State& body) const {
    State all;
    this->of(newborn.species, [&]<class List>(const List& list, auto place) {
      if constexpr (Stateful<List>) {
        const auto* parents = parent != nullptr ? &parent->template get<place>() : nullptr;
        all.template get<place>() = list.born(newborn, parents, body.template get<place>());
      }
    });
    return all;
  }

#define TROPHIC_NOTIFY_LISTS(hook, Happened, signature)                                     \
  void hook(State& own, BodyIndex self, Happened what, const View& view) const {            \
    this->of(view.robots[self].species, [&]<class List>(const List& list, auto place) {     \
      if constexpr (Stateful<List>) list.hook(own.template get<place>(), self, what, view); \
    });                                                                                     \
  }
  TROPHIC_STATE_HOOKS(TROPHIC_NOTIFY_LISTS)
#undef TROPHIC_NOTIFY_LISTS
};

template <class Community, class... Lists>
using HeldLists = std::conditional_t<(Stateful<Lists> || ...), ListsWithStates<Community, Lists...>, ListsHeld<Lists...>>;

}  // namespace detail

/// The inputs of brains that differ by species: `PerSpecies<PreyList, PredatorList>` has one List for each species of the table's
/// community, in its order. A brain has the inputs of its species' list. The paths of parameters have the species and the sensor,
/// `rules.sensors.prey.distance_over_scale.full_scale_m`, or in a table by `params.sensors.get<0>()`. Each individual has the
/// states of its species' sensors; the others do not change.
template <class... Lists>
using PerSpecies = PerSpeciesOf<void, Lists...>;

template <class... Lists>
class PerSpeciesOf<void, Lists...> {
 public:
  static constexpr std::string_view name = JoinedText<detail::ListNames<Lists...>>::view;
};

/// The same in a table of this community.
template <class Community, class... Lists>
class PerSpeciesOf : public detail::HeldLists<Community, Lists...> {
 public:
  static_assert(sizeof...(Lists) == Community::species_names.size(),
                "sensors::PerSpecies needs one sensors::List for each species of the table's community");
  static constexpr bool is_sensor_list = (Lists::is_sensor_list && ...);  ///< required by the slot
  static constexpr bool needs_joints = (Lists::needs_joints || ...);
  static constexpr std::size_t size = std::max({Lists::size...});
  static constexpr std::array<std::size_t, sizeof...(Lists)> sizes{Lists::size...};
  static constexpr std::string_view name = JoinedText<detail::ListNames<Lists...>>::view;
  static constexpr std::string_view source = JoinedText<detail::Sources<Lists...>>::view;

  using Params = GroupOf<trophic::detail::SpeciesNames<Community>, ParamsOf<Lists>...>;
  Params params;

  explicit PerSpeciesOf(const Params& given = {}) : detail::HeldLists<Community, Lists...>{given}, params{given} {}

  using Values = std::array<double, size>;
  using Common = std::tuple<typename Lists::Values...>;

  /// The number of inputs of a species' brain.
  [[nodiscard]] static std::size_t size_of(Species species) { return sizes.at(species); }

  /// The sensor of each value, by species where they differ: "side_of_adversary / rays".
  [[nodiscard]] static std::vector<std::string> value_names() {
    const std::array all{Lists::value_names()...};
    std::vector<std::string> names(size);
    for (std::size_t i = 0; i < size; ++i) {
      for (const std::vector<std::string>& own : all) {
        const std::string one = i < own.size() ? own[i] : "-";
        if (names[i] != one) names[i] += (names[i].empty() ? "" : " / ") + one;
      }
    }
    return names;
  }

  [[nodiscard]] Common sense_common(const View& view) const {
    return std::apply([&](const auto&... lists) { return Common{lists.sense_common(view)...}; }, this->lists());
  }

  /// The values of the list of self's species; those beyond its size are 0.
  template <class Own, class Stream>
  [[nodiscard]] Values sense([[maybe_unused]] const Own& own, BodyIndex self, const std::optional<Sighting>& sighting,
                             const View& view, const Common& common, const Stream& stream) const {
    Values values{};
    this->of(view.robots[self].species, [&]<class List>(const List& list, auto place) {
      std::ranges::copy(list.sense(detail::state_in<List>(own, place), self, sighting, view, std::get<place>(common), stream),
                        values.begin());
    });
    return values;
  }
};

}  // namespace trophic::perception::sensors

namespace trophic::detail {

template <class Community, class... Lists>
struct held_by<perception::sensors::PerSpeciesOf<Community, Lists...>> {
  using type = perception::sensors::PerSpeciesOf<Community, Lists...>;
};

}  // namespace trophic::detail
