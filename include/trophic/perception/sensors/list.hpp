// SPDX-License-Identifier: MIT
// All sensors of a robot, one after the other.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <trophic/params/group.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/perception/sensors/contract.hpp>
#include <trophic/population/state.hpp>
#include <trophic/support/joined_text.hpp>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace trophic::perception::sensors {

namespace detail {

/// The name of a sensor; none for what is no sensor, which List reports.
template <class One>
[[nodiscard]] consteval std::string_view name_of() {
  if constexpr (perception::detail::NamedSensor<One>) return One::name;
  return {};
}

template <class... Sensors>
struct Names {
  static constexpr std::array<std::string_view, sizeof...(Sensors)> names{name_of<Sensors>()...};
  static constexpr const auto& words = names;
  static constexpr std::string_view separator = " + ";
};

template <class... Sensors>
struct Sources {
  static constexpr std::array<std::string_view, sizeof...(Sensors)> words{source_of<Sensors>()...};
  static constexpr std::string_view separator = " + ";
};

/// 0 for what is no sensor, which List reports.
template <class One>
[[nodiscard]] consteval std::size_t size_of() {
  if constexpr (perception::detail::Sized<One>) return One::size;
  return 0;
}

}  // namespace detail

/// What a robot senses: the values of each sensor in the order of the list. A sensor's numbers are set under its name:
/// `rules.sensors.distance_over_scale.full_scale_m`, or in a table by `with`.
template <class... Sensors>
class List {
 public:
  static constexpr bool is_sensor_list = ((Sensor<Sensors> && !Stateful<Sensors>)&&...);  ///< what the slot asks for
  static constexpr std::size_t count = sizeof...(Sensors);
  static constexpr std::size_t size = (detail::size_of<Sensors>() + ... + 0);
  static constexpr std::string_view name = JoinedText<detail::Names<Sensors...>>::view;
  static constexpr std::string_view source = JoinedText<detail::Sources<Sensors...>>::view;

  /// The sensor at a place of the list.
  template <std::size_t place>
  using At = std::tuple_element_t<place, std::tuple<Sensors...>>;
  template <class One>
  static constexpr bool contains = (std::same_as<One, Sensors> || ...);
  /// The list with New in the place of Old.
  template <class Old, class New>
  using Replaced = List<std::conditional_t<std::same_as<Sensors, Old>, New, Sensors>...>;

  using Params = GroupOf<detail::Names<Sensors...>, ParamsOf<Sensors>...>;
  Params params;

  /// Numbers in which one sensor's are these, for a table's params(): `.sensors = Sensors::with<DistanceOverScale>({...})`.
  template <class One>
  [[nodiscard]] static constexpr Params with(const ParamsOf<One>& numbers, Params others = {}) {
    static_assert(contains<One>, "the list has no such sensor");
    [&]<std::size_t... place>(std::index_sequence<place...>) {
      const auto set = [&](auto& of_one, auto is_it) {
        if constexpr (is_it) of_one = numbers;
      };
      (set(others.template get<place>(), std::bool_constant<std::same_as<At<place>, One>>{}), ...);
    }
    (std::index_sequence_for<Sensors...>{});
    return others;
  }

  explicit List(const Params& numbers = {}) : List{numbers, std::index_sequence_for<Sensors...>{}} {}

  using Values = std::array<double, size>;

  /// The name of the sensor that each value is of.
  [[nodiscard]] static std::vector<std::string> value_names() {
    std::vector<std::string> names;
    (names.insert(names.end(), detail::size_of<Sensors>(), std::string{detail::name_of<Sensors>()}), ...);
    return names;
  }

  /// The values that are the same for everybody; the places of the others are for `sense` to fill.
  [[nodiscard]] Values sense_common(const View& view) const {
    Values values{};
    each(
        [&]<class One>(const One& sensor, std::size_t, double* here) {
          if constexpr (CommonSensor<One>) std::ranges::copy(sensor.sense(view), here);
        },
        values);
    return values;
  }

  /// All values for one robot, given the common ones. `stream(i)` is the random stream of the i-th sensor.
  template <class Stream>
  [[nodiscard]] Values sense(BodyIndex self, const std::optional<Sighting>& sighting, const View& view, Values values,
                             const Stream& stream) const {
    each(
        [&]<class One>(const One& sensor, std::size_t i, double* here) {
          if constexpr (!CommonSensor<One>) {
            Rng rng = stream(i);
            std::ranges::copy(sensor.sense(self, sighting, view, rng), here);
          }
        },
        values);
    return values;
  }

 private:
  template <std::size_t... place>
  List(const Params& numbers, std::index_sequence<place...>)
      : params{numbers}, sensors_{make_policy<Sensors>(numbers.template get<place>(), "sensors")...} {}

  /// Calls `visit(sensor, place in the list, its first value)`.
  template <class Visit>
  void each(const Visit& visit, Values& values) const {
    std::apply(
        [&](const auto&... sensor) {
          [[maybe_unused]] std::size_t place = 0;
          [[maybe_unused]] double* here = values.data();
          ((visit(sensor, place++, here), here += std::remove_cvref_t<decltype(sensor)>::size), ...);
        },
        sensors_);
  }

  std::tuple<Sensors...> sensors_;
};

}  // namespace trophic::perception::sensors
