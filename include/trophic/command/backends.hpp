// SPDX-License-Identifier: MIT
// The backends that a program was built with: the one list behind --backend, its help and its errors.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/backend/backend_choice.hpp>
#include <trophic/backend/contract.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/command/words.hpp>
#include <trophic/params/toml.hpp>
#include <trophic/support/colour.hpp>
#include <type_traits>
#include <utility>
#include <vector>
// Linking trophic::mujoco or trophic::ode defines these; a program that is built by hand needs -DTROPHIC_WITH_MUJOCO.
#ifdef TROPHIC_WITH_MUJOCO
#include <trophic/backend/mujoco.hpp>
#endif
#ifdef TROPHIC_WITH_ODE
#include <trophic/backend/ode.hpp>
#endif

namespace trophic::command {

/// Backends to choose from at run time; the first is the default.
template <Backend First, Backend... More>
struct BackendList {
  static constexpr std::string_view default_backend = First::name;

  /// Calls `visit.operator()<B>()` for each.
  template <class Visitor>
  static void for_each(Visitor&& visit) {
    visit.template operator()<First>();
    (visit.template operator()<More>(), ...);
  }
};

/// The default backend of trophic's own programs, whatever was found when they were built.
inline constexpr std::string_view default_backend = "mujoco";

/// The kinematic backend and the engines that the program is linked with.
struct LinkedBackends : BackendList<backend::Kinematic
#ifdef TROPHIC_WITH_MUJOCO
                                    ,
                                    backend::Mujoco
#endif
#ifdef TROPHIC_WITH_ODE
                                    ,
                                    backend::Ode
#endif
                                    > {
  static constexpr std::string_view default_backend = command::default_backend;
};

/// A backend that a program was built with, its type erased.
struct LinkedBackend {
  std::string name;
  std::string version;
  bool has_joints;
  BackendChoice (*choice)();  ///< with the backend's own numbers
  /// Sets what a table names, as read_numbers; `path` is the table's.
  void (*read)(BackendChoice& choice, const toml::table& numbers, const std::string& path);
  /// Writes the engine's model, robots in these colours. Returns false for an engine without such a file.
  bool (*save_mjcf)(const AnyBackend& bodies, const std::string& path, std::span<const Colour> colours);
};

template <Backend B>
[[nodiscard]] LinkedBackend linked_backend() {
  return {.name = std::string{B::name},
          .version = B::version(),
          .has_joints = JointDriven<B>,
          .choice = [] { return BackendChoice{typename B::Params{}}; },
          .read = [](BackendChoice& choice, const toml::table& numbers,
                     const std::string& path) { trophic::detail::read_table(*choice.as<B>(), numbers, path); },
          .save_mjcf =
              []([[maybe_unused]] const AnyBackend& bodies, [[maybe_unused]] const std::string& path,
                 [[maybe_unused]] std::span<const Colour> colours) {
                if constexpr (requires(const B& engine) { engine.save_mjcf(path, colours); }) {
                  bodies.as<B>()->save_mjcf(path, colours);
                  return true;
                } else {
                  return false;
                }
              }};
}

template <class Backends>
[[nodiscard]] std::vector<LinkedBackend> linked_backends() {
  std::vector<LinkedBackend> all;
  Backends::for_each([&]<class B>() { all.push_back(linked_backend<B>()); });
  return all;
}

/// An engine for which trophic has a backend, and the Debian packages that it needs.
struct Engine {
  std::string_view name;
  std::string_view packages;
};
inline constexpr std::array known_engines{Engine{"mujoco", "libmujoco-dev libgl-dev libpugixml-dev"},
                                          Engine{"ode", "libode-dev"}};

template <class Backends>
[[nodiscard]] std::vector<std::string> backend_names() {
  std::vector<std::string> names;
  Backends::for_each([&]<class B>() { names.emplace_back(B::name); });
  return names;
}

/// The backends that have joints.
template <class Backends>
[[nodiscard]] std::vector<std::string> joint_driven_names() {
  std::vector<std::string> names;
  Backends::for_each([&]<class B>() {
    if constexpr (JointDriven<B>) names.emplace_back(B::name);
  });
  return names;
}

/// "kinematic 1, mujoco 2.2.2".
[[nodiscard]] inline std::string backend_versions(const std::vector<LinkedBackend>& backends) {
  std::string text;
  for (const LinkedBackend& one : backends) text += (text.empty() ? "" : ", ") + one.name + " " + one.version;
  return text;
}
template <class Backends>
[[nodiscard]] std::string backend_versions() {
  return backend_versions(linked_backends<Backends>());
}

/// The error about a backend that is not in `names`: an engine that this program was built without, or an unknown name.
[[nodiscard]] inline std::string about_missing_backend(const std::string& name, const std::vector<std::string>& names) {
  const std::string option = "--backend " + name;
  for (const Engine& engine : known_engines) {
    if (engine.name != name) continue;
    const std::string instead = names.empty() ? "" : ", or use --backend " + names.front();
    return option + ": this program was built without it: apt-get install " + std::string{engine.packages} +
           ", find_package(trophic COMPONENTS " + std::string{engine.name} + "_compiled) and build again" + instead;
  }
  return must_be_one_of(option, names) + did_you_mean(nearest_word(name, names));
}

/// "physics: kinematic, mujoco (mujoco)": the help of --backend.
[[nodiscard]] inline std::string backend_help(const std::vector<std::string>& names,
                                              std::string_view otherwise = default_backend) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "physics: " : ", ") + name;
  return text + " (" + std::string{otherwise} + ")";
}

/// Calls `visit.operator()<B>()` for the backend with joints of this name, and returns its result. Throws
/// std::invalid_argument for any other name.
template <class Backends, class Visitor>
[[nodiscard]] int with_joint_driven(const std::string& name, Visitor&& visit) {
  std::function<int()> call;
  bool has_no_joints = false;
  Backends::for_each([&]<class B>() {
    if (B::name != name) return;
    if constexpr (JointDriven<B>) {
      call = [&visit] { return visit.template operator()<B>(); };
    } else {
      has_no_joints = true;
    }
  });
  if (has_no_joints) throw std::invalid_argument{"--backend " + name + ": has no joints, so it walks no gait"};
  if (!call) throw std::invalid_argument{about_missing_backend(name, joint_driven_names<Backends>())};
  return call();
}

}  // namespace trophic::command
