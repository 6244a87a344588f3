// SPDX-License-Identifier: MIT
// Definitions of backends.hpp.
#include <tools/command/backends.hpp>
#include <tools/command/words.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/backend/torus.hpp>
// CMake defines these for the engines that it found.
#ifdef TROPHIC_WITH_MUJOCO
#include <trophic/backend/mujoco.hpp>
#endif
#ifdef TROPHIC_WITH_ODE
#include <trophic/backend/ode.hpp>
#endif

namespace trophic::command {

namespace {

/// An engine for which trophic has a backend, and what to run for it.
struct Engine {
  std::string_view name;
  std::string_view command;
};
constexpr std::array known_engines{
#ifdef TROPHIC_WHEEL  // what pip installs
    Engine{"mujoco", "pip install \"trophic[mujoco]\""},
#else
    Engine{"mujoco", "apt-get install libmujoco-dev libgl-dev libpugixml-dev and build trophic again"},
#endif
    Engine{"ode", "apt-get install libode-dev and build trophic again"}};

}  // namespace

std::vector<BackendChoice> built_backends() {
  return {
      backend::Kinematic::Params{},
      backend::Torus::Params{},
#ifdef TROPHIC_WITH_MUJOCO
      backend::Mujoco::Params{},
#endif
#ifdef TROPHIC_WITH_ODE
      backend::Ode::Params{},
#endif
  };
}

std::vector<std::string> backend_names(const std::vector<BackendChoice>& backends) {
  std::vector<std::string> names;
  for (const BackendChoice& backend : backends) names.push_back(backend.name());
  return names;
}

std::vector<std::string> joint_driven_names() {
  std::vector<std::string> names;
  for (const BackendChoice& backend : built_backends()) {
    if (backend.has_joints()) names.push_back(backend.name());
  }
  return names;
}

BackendChoice joint_driven_backend(const std::string& name) {
  const std::vector<BackendChoice> backends = built_backends();
  const auto found = std::ranges::find(backends, name, &BackendChoice::name);
  if (found == backends.end()) throw std::invalid_argument{about_missing_backend(name, joint_driven_names())};
  if (!found->has_joints()) throw std::invalid_argument{"--backend " + name + ": has no joints, so it cannot simulate a gait"};
  return *found;
}

std::string backend_versions(const std::vector<BackendChoice>& backends) {
  std::string text;
  for (const BackendChoice& one : backends) text += (text.empty() ? "" : ", ") + one.name() + " " + one.version();
  return text;
}

std::string about_missing_backend(const std::string& name, const std::vector<std::string>& names) {
  const std::string option = "--backend " + name;
  const auto engine = std::ranges::find(known_engines, name, &Engine::name);
  if (engine == known_engines.end()) return must_be_one_of(option, names) + did_you_mean(nearest_word(name, names));
  const std::string instead = names.empty() ? "" : ", or use --backend " + names.front();
  return option + ": this program was built without it; run " + std::string{engine->command} + instead;
}

std::string backend_help(const std::vector<std::string>& names, std::string_view otherwise) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "physics: " : ", ") + name;
  return text + " (default: " + std::string{otherwise} + ")";
}

}  // namespace trophic::command
