// SPDX-License-Identifier: MIT
// Compiles an MJCF document in memory.
#pragma once

#include <pugixml.hpp>

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <trophic/backend/mujoco/box_test.hpp>
#include <trophic/backend/mujoco/engine.hpp>
#include <trophic/backend/mujoco/versions.hpp>

namespace trophic::backend::mujoco {

/// A file that an MJCF document refers to.
struct NamedFile {
  std::string name;
  std::string content;
};

/// Compiles MJCF. Throws std::runtime_error with MuJoCo's own message on failure.
[[nodiscard]] inline ModelPtr compile(const pugi::xml_document& document, const std::optional<NamedFile>& file) {
  static std::mutex one_at_a_time;  // MuJoCo does not document its compiler as thread-safe
  const std::lock_guard lock{one_at_a_time};
  const EngineGuard guard;
  install_box_test();

  struct DeleteFiles {
    void operator()(mjVFS* files) const {
      mj_deleteVFS(files);
      delete files;
    }
  };
  const std::unique_ptr<mjVFS, DeleteFiles> files{new mjVFS};
  mj_defaultVFS(files.get());
  std::ostringstream text;
  document.save(text, "", pugi::format_raw);
  add_file(*files, "model.xml", text.str());
  if (file) add_file(*files, file->name, file->content);

  std::array<char, 1000> error{};
  ModelPtr model{mj_loadXML("model.xml", files.get(), error.data(), static_cast<int>(error.size()))};
  if (!model) throw std::runtime_error{std::string{"MuJoCo rejects the model: "} + error.data()};
  return model;
}

}  // namespace trophic::backend::mujoco
