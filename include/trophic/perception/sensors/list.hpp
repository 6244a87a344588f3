// SPDX-License-Identifier: MIT
// A list of the sensors of a robot.
#pragma once

#include <trophic/params/group.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/perception/sensors/contract.hpp>
#include <trophic/support/joined_text.hpp>

namespace trophic::detail {

/// Fails to compile with a clear message if a sensor's State violates the requirements in population/state.hpp.
template <class One>
struct CheckSensorState {
  static_assert(!Stateful<One> || perception::OwnSensor<One>,
                "a sensor with a State must sense(self, sighting, view, rng) or (..., const State& own): sense(view) is for "
                "values that are "
                "the same for all robots");
  TROPHIC_CHECK_STATE_OF(One, "a sensor")
  static constexpr bool ok = true;
};

}  // namespace trophic::detail

namespace trophic::perception::sensors {

namespace detail {

/// The name of a sensor; empty for a type that is not a sensor. List reports the error.
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

/// 0 for a type that is not a sensor; List reports the error.
template <class One>
[[nodiscard]] consteval std::size_t size_of() {
  if constexpr (perception::detail::Sized<One>) return One::size;
  return 0;
}

template <class... Sensors>
class Held {
 public:
  static_assert((trophic::detail::CheckHeld<Sensors>::ok && ...));
  explicit Held(Sensors... sensors) : sensors_{std::move(sensors)...} {}

 protected:
  /// Calls `visit(sensor, its index in the list as an integral_constant)` for each.
  template <class Visit>
  void each(const Visit& visit) const {
    [&]<std::size_t... place>(std::index_sequence<place...>) {
      (visit(std::get<place>(sensors_), std::integral_constant<std::size_t, place>{}), ...);
    }
    (std::index_sequence_for<Sensors...>{});
  }

 private:
  std::tuple<Sensors...> sensors_;
};

/// For sensors of which some have a State: the list then has one too, with each sensor's State under its name, and forwards the
/// hooks.
template <class... Sensors>
class HeldWithStates : public Held<Sensors...> {
 public:
  static_assert((trophic::detail::CheckSensorState<Sensors>::ok && ...));
  using Held<Sensors...>::Held;
  using State = GroupOf<Names<Sensors...>, StateOf<Sensors>...>;

  [[nodiscard]] State born(const Individual& newborn, const State* parent, const State& body) const {
    State all;
    this->each([&]<class One>(const One& sensor, auto place) {
      if constexpr (trophic::detail::BornWithState<One>) {
        const auto* parents = parent != nullptr ? &parent->template get<place>() : nullptr;
        all.template get<place>() = sensor.born(newborn, parents, body.template get<place>());
      }
    });
    return all;
  }

#define TROPHIC_NOTIFY_SENSORS(hook, Happened, signature)                        \
  void hook(State& own, BodyIndex self, Happened what, const View& view) const { \
    this->each([&]<class One>(const One& sensor, auto place) {                   \
      if constexpr (trophic::detail::StateTakes_##hook<One>) {                   \
        sensor.hook(own.template get<place>(), self, what, view);                \
      }                                                                          \
    });                                                                          \
  }
  TROPHIC_STATE_HOOKS(TROPHIC_NOTIFY_SENSORS)
#undef TROPHIC_NOTIFY_SENSORS
};

/// One sensor's state among those of a list; empty for a sensor without State.
template <class One, class All, class Place>
[[nodiscard]] const StateOf<One>& state_in([[maybe_unused]] const All& all, Place) {
  if constexpr (Stateful<One>) {
    return all.template get<Place::value>();
  } else {
    static constexpr NoState none;
    return none;
  }
}

template <class... Sensors>
using HeldSensors = std::conditional_t<(Stateful<Sensors> || ...), HeldWithStates<Sensors...>, Held<Sensors...>>;

}  // namespace detail

/// The inputs of a brain: the values of each sensor in the order of the list. A sensor's parameters have paths with its name,
/// `rules.sensors.distance_over_scale.full_scale_m`, or in a table by `with`. If a sensor has a State (population/state.hpp),
/// the list has one for each body, with that sensor's under its name.
template <class... Sensors>
class List : public detail::HeldSensors<Sensors...> {
 public:
  static constexpr bool is_sensor_list = (Sensor<Sensors> && ...);  ///< required by the slot
  static constexpr bool needs_joints = (perception::needs_joints<Sensors> || ...);
  static constexpr std::size_t count = sizeof...(Sensors);
  static constexpr std::size_t size = (detail::size_of<Sensors>() + ... + 0);
  static constexpr std::string_view name = JoinedText<detail::Names<Sensors...>>::view;
  static constexpr std::string_view source = JoinedText<detail::Sources<Sensors...>>::view;

  /// The sensor at an index of the list.
  template <std::size_t place>
  using At = std::tuple_element_t<place, std::tuple<Sensors...>>;
  template <class One>
  static constexpr bool contains = (std::same_as<One, Sensors> || ...);
  /// The list with New instead of Old.
  template <class Old, class New>
  using Replaced = List<std::conditional_t<std::same_as<Sensors, Old>, New, Sensors>...>;

  using Params = GroupOf<detail::Names<Sensors...>, ParamsOf<Sensors>...>;
  Params params;

  /// Returns the parameters of the list with these for one sensor, for a table's params(): `.sensors =
  /// Sensors::with<DistanceOverScale>({...})`.
  template <class One>
  [[nodiscard]] static constexpr Params with(const ParamsOf<One>& given, Params others = {}) {
    static_assert(contains<One>, "the list has no such sensor");
    [&]<std::size_t... place>(std::index_sequence<place...>) {
      const auto set = [&](auto& of_one, auto is_it) {
        if constexpr (is_it) of_one = given;
      };
      (set(others.template get<place>(), std::bool_constant<std::same_as<At<place>, One>>{}), ...);
    }
    (std::index_sequence_for<Sensors...>{});
    return others;
  }

  explicit List(const Params& given = {}) : List{given, std::index_sequence_for<Sensors...>{}} {}

  using Values = std::array<double, size>;

  /// The number of inputs of a species' brain.
  [[nodiscard]] static constexpr std::size_t size_of(Species) { return size; }

  /// The sensor name of each value.
  [[nodiscard]] static std::vector<std::string> value_names() {
    std::vector<std::string> names;
    (names.insert(names.end(), detail::size_of<Sensors>(), std::string{detail::name_of<Sensors>()}), ...);
    return names;
  }

  /// The values that are the same for all robots; `sense` fills the others.
  [[nodiscard]] Values sense_common(const View& view) const {
    Values values{};
    double* here = values.data();
    this->each([&]<class One>(const One& sensor, auto) {
      if constexpr (CommonSensor<One>) std::ranges::copy(sensor.sense(view), here);
      here += One::size;
    });
    return values;
  }

  /// All values for one robot, given the common ones and its state. `stream(i)` is the random stream of the i-th sensor.
  template <class Own, class Stream>
  [[nodiscard]] Values sense([[maybe_unused]] const Own& own, BodyIndex self, const std::optional<Sighting>& sighting,
                             const View& view, Values values, const Stream& stream) const {
    double* here = values.data();
    this->each([&]<class One>(const One& sensor, auto place) {
      if constexpr (!CommonSensor<One>) {
        Rng rng = stream(place());
        std::ranges::copy(ask::sense(sensor, detail::state_in<One>(own, place), self, sighting, view, rng), here);
      }
      here += One::size;
    });
    return values;
  }

 private:
  template <std::size_t... place>
  List(const Params& given, std::index_sequence<place...>)
      : detail::HeldSensors<Sensors...>{make_policy<Sensors>(given.template get<place>(), "sensors")...}, params{given} {}
};

}  // namespace trophic::perception::sensors

namespace trophic::detail {

template <class... Sensors>
struct held_by<perception::sensors::List<Sensors...>> {
  using type = HeldWithParams<perception::sensors::detail::HeldSensors<Sensors...>,
                              typename perception::sensors::List<Sensors...>::Params>;
};

}  // namespace trophic::detail
