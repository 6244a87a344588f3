// SPDX-License-Identifier: MIT
// A gait: the weights of one robot's CPG, as data.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <trophic/body/robot_model.hpp>
#include <trophic/detail/toml_table.hpp>
#include <trophic/models.hpp>
#include <trophic/params.hpp>
#include <vector>

namespace trophic::control {

/// Weights of a CPG with one oscillator per hinge (Sec. "Robot Controller"). Formulas: control/cpg.hpp.
struct Gait {
  std::string name;
  std::string robot;                ///< the robot that it was made for; informative, `check_fit` compares hinges
  std::string provenance;           ///< where the numbers come from
  std::vector<std::string> hinges;  ///< names in the order of RobotModel::hinges; n of them
  Eigen::VectorXd internal;         ///< n weights w_i between x_i and y_i
  Eigen::MatrixXd coupling;         ///< n x n, antisymmetric: c_ij between x_i and x_j; 0 where not coupled

  bool operator==(const Gait&) const = default;
};

/// Throws std::invalid_argument unless sizes agree, all weights are finite and the coupling is antisymmetric.
inline void validate(const Gait& gait) {
  const auto fail = [&](const std::string& what) { throw std::invalid_argument{"gait " + gait.name + ": " + what}; };
  const auto n = static_cast<Eigen::Index>(gait.hinges.size());
  if (gait.internal.size() != n) {
    fail("internal has " + std::to_string(gait.internal.size()) + " weights: must have one per hinge, " + std::to_string(n));
  }
  if (gait.coupling.rows() != n || gait.coupling.cols() != n)
    fail("coupling: must be " + std::to_string(n) + " x " + std::to_string(n));
  if (!gait.internal.allFinite() || !gait.coupling.allFinite()) fail("weights must be finite");
  if (gait.coupling != -gait.coupling.transpose()) fail("coupling: must be antisymmetric");
}

/// Throws std::invalid_argument unless the gait names the robot's hinges in the robot's order and couples neighbours only.
inline void check_fit(const Gait& gait, const RobotModel& robot) {
  validate(gait);
  const std::string whose = "gait " + gait.name + " does not fit robot " + robot.name + ": ";
  if (gait.hinges.size() != robot.hinges.size()) {
    throw std::invalid_argument{whose + std::to_string(gait.hinges.size()) + " hinges, the robot has " +
                                std::to_string(robot.hinges.size())};
  }
  for (std::size_t i = 0; i < gait.hinges.size(); ++i) {
    if (gait.hinges[i] != robot.hinges[i].name) {
      throw std::invalid_argument{whose + "hinge " + std::to_string(i) + " is \"" + gait.hinges[i] + "\", the robot's is \"" +
                                  robot.hinges[i].name + "\""};
    }
    for (std::size_t j = 0; j < gait.hinges.size(); ++j) {
      const bool coupled = gait.coupling(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) != 0.0;
      if (coupled && !std::ranges::binary_search(robot.hinge_neighbours[i], j)) {
        throw std::invalid_argument{whose + "\"" + gait.hinges[i] + "\" and \"" + gait.hinges[j] +
                                    "\" are coupled but no neighbours"};
      }
    }
  }
}

/// The gait of a file, by name ("spider_published") or path (format: models/README.md). Throws std::runtime_error for a file that
/// cannot be found, read or parsed and std::invalid_argument "FILE: KEY = VALUE: must be ..." for its content.
[[nodiscard]] inline Gait load_gait(std::string_view name_or_path) {
  const auto file = detail::TomlTable::read(find_model(ModelKind::gait, name_or_path));
  Gait gait{.name = file.text("name"),
            .robot = file.text("robot"),
            .provenance = {},
            .hinges = file.texts("hinges"),
            .internal = {},
            .coupling = {}};
  if (file.has("provenance")) gait.provenance = file.text("provenance");
  for (const std::string_view origin : {"cppn", "evolution"}) {
    if (file.has(origin)) static_cast<void>(file.table(origin));  // read by evolve::load_cppn
  }
  for (std::size_t i = 0; i < gait.hinges.size(); ++i) {
    if (std::find(gait.hinges.begin(), gait.hinges.begin() + static_cast<std::ptrdiff_t>(i), gait.hinges[i]) !=
        gait.hinges.begin() + static_cast<std::ptrdiff_t>(i)) {
      file.fail("hinges", ": \"" + gait.hinges[i] + "\" appears twice");
    }
  }
  const std::vector<double> internal = file.numbers("internal");
  const auto n = static_cast<Eigen::Index>(gait.hinges.size());
  gait.internal = Eigen::Map<const Eigen::VectorXd>(internal.data(), static_cast<Eigen::Index>(internal.size()));
  gait.coupling = Eigen::MatrixXd::Zero(n, n);
  if (file.has("coupling")) {
    for (const auto& pair : file.tables("coupling")) {
      const auto hinge = [&](std::string_view key) {
        const std::string name = pair.text(key);
        const auto found = std::ranges::find(gait.hinges, name);
        if (found == gait.hinges.end()) pair.fail(key, " = \"" + name + "\": must be one of the gait's hinges");
        return static_cast<Eigen::Index>(found - gait.hinges.begin());
      };
      const Eigen::Index from = hinge("from");
      const Eigen::Index to = hinge("to");
      if (from >= to)
        pair.fail("to", " = \"" + gait.hinges[static_cast<std::size_t>(to)] + "\": must come after \"from\" in hinges");
      if (gait.coupling(from, to) != 0.0) pair.fail("to", ": this pair is coupled twice");
      gait.coupling(from, to) = pair.number("weight", any_number());
      gait.coupling(to, from) = -gait.coupling(from, to);
      pair.no_other_keys();
    }
  }
  file.no_other_keys();
  validate(gait);
  return gait;
}

/// The gait as TOML text; `load_gait` reads back exactly the same gait (but pairs with weight 0 are left out).
[[nodiscard]] inline std::string to_toml(const Gait& gait) {
  validate(gait);
  const auto quoted = [](const std::string& text) {
    std::ostringstream written;
    written << toml::value<std::string>{text};
    return written.str();
  };
  std::string text =
      "name = " + quoted(gait.name) + "\nrobot = " + quoted(gait.robot) + "\nprovenance = " + quoted(gait.provenance);
  std::string hinges;
  std::string internal;
  std::string pairs;
  for (std::size_t i = 0; i < gait.hinges.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    hinges += (i == 0 ? "" : ", ") + quoted(gait.hinges[i]);
    internal += (i == 0 ? "" : ", ") + detail::toml_float(gait.internal[row]);
    for (std::size_t j = i + 1; j < gait.hinges.size(); ++j) {
      const double weight = gait.coupling(row, static_cast<Eigen::Index>(j));
      if (weight == 0.0) continue;
      pairs += "\n[[coupling]]\nfrom = " + quoted(gait.hinges[i]) + "\nto = " + quoted(gait.hinges[j]) +
               "\nweight = " + detail::toml_float(weight) + "\n";
    }
  }
  return text + "\n\nhinges = [" + hinges + "]\ninternal = [" + internal + "]\n" + pairs;
}

/// Writes `to_toml(gait)` to a new file. Throws std::runtime_error if the file exists or cannot be written completely.
inline void save_gait(const Gait& gait, const std::filesystem::path& file) {
  if (std::filesystem::exists(file)) throw std::runtime_error{file.string() + ": exists, not overwritten"};
  std::ofstream stream{file, std::ios::binary};
  stream << to_toml(gait);
  stream.close();
  if (!stream) throw std::runtime_error{file.string() + ": cannot be written"};
}

}  // namespace trophic::control
