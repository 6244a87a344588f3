// SPDX-License-Identifier: MIT
// A list of the acts of robots.
#pragma once

#include <string>
#include <trophic/control/acts/tag.hpp>
#include <trophic/control/acts/turn.hpp>
#include <trophic/params/policy.hpp>
#include <trophic/support/joined_text.hpp>
#include <vector>

namespace trophic::control::acts {

namespace detail {

template <class... Acts>
struct Names {
  static constexpr std::array<std::string_view, sizeof...(Acts)> words{trophic::detail::policy_name<Acts>()...};
  static constexpr std::string_view separator = " + ";
};
template <class... Acts>
struct Sources {
  static constexpr std::array<std::string_view, sizeof...(Acts)> words{source_of<Acts>()...};
  static constexpr std::string_view separator = " + ";
};

/// 0 for a type that is not an act; List reports the error.
template <class One>
[[nodiscard]] consteval std::size_t outputs_of() {
  if constexpr (Act<One>) return One::outputs;
  return 0;
}

}  // namespace detail

/// The outputs of a brain: those of each act in the order of the list. The default is the paper's, `List<Turn, Tag>`.
template <class... Acts>
struct List {
  static constexpr bool is_act_list = (Act<Acts> && ...);  ///< required by the slot
  static constexpr std::size_t count = sizeof...(Acts);
  static constexpr std::size_t outputs = (detail::outputs_of<Acts>() + ... + 0);
  static constexpr std::string_view name = JoinedText<detail::Names<Acts...>>::view;
  static constexpr std::string_view source = JoinedText<detail::Sources<Acts...>>::view;
  template <class One>
  static constexpr bool contains = (std::same_as<One, Acts> || ...);
  /// Whether some act is not in the paper, so that the population stores its values.
  static constexpr bool keeps_values = !(trophic::detail::KeptByIndividual<Acts> && ...);
  static constexpr std::array<const char*, count> keys{&trophic::detail::act_key<Acts>...};

  /// The name of each act; empty for an act that is stored in the individual.
  static constexpr std::array<std::string_view, count> kept_names{
      (trophic::detail::KeptByIndividual<Acts> ? std::string_view{} : trophic::detail::policy_name<Acts>())...};

  /// The name of each output: its act's name, with a number if the act has several outputs.
  [[nodiscard]] static std::vector<std::string> output_names() {
    std::vector<std::string> names;
    each(std::array<double, outputs>{}, [&]<class One>(std::size_t, std::span<const double, One::outputs>) {
      for (std::size_t i = 0; i < One::outputs; ++i) {
        names.push_back(std::string{One::name} + (One::outputs > 1 ? std::to_string(i) : ""));
      }
    });
    return names;
  }

  /// Calls `visit.template operator()<Act>(place, out)` for each act with its place in the list and its outputs.
  template <class Visit>
  static void each(std::span<const double, outputs> out, const Visit& visit) {
    [[maybe_unused]] std::size_t place = 0;
    [[maybe_unused]] const double* own = out.data();
    const auto next = [&]<class One>() {
      if constexpr (is_act_list) {
        visit.template operator()<One>(place++, std::span<const double, One::outputs>{own, One::outputs});
        own += One::outputs;
      }
    };
    (next.template operator()<Acts>(), ...);
  }
};

/// Whether a list has all acts of another one.
template <class Acts, class Others>
inline constexpr bool contains_all = false;
template <class Acts, class... Others>
inline constexpr bool contains_all<Acts, List<Others...>> = (Acts::template contains<Others> && ...);

/// The paper's two outputs.
using TurnAndTag = List<Turn, Tag>;

}  // namespace trophic::control::acts
