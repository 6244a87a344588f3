// SPDX-License-Identifier: MIT
// Definitions of gait.hpp.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <trophic/habitat/load/gait.hpp>
#include <trophic/habitat/load/toml_table.hpp>
#include <trophic/params/params.hpp>
#include <trophic/support/replace_file.hpp>
#include <vector>

namespace trophic {

TROPHIC_INLINE Gait load_gait(std::string_view name_or_path, std::string_view installed) {
  const auto file = detail::TomlTable::read(find_model(ModelKind::gait, name_or_path, installed));
  Gait gait{.name = file.text("name"),
            .robot = file.text("robot"),
            .provenance = {},
            .hinges = file.texts("hinges"),
            .internal = {},
            .coupling = {}};
  if (file.has("provenance")) gait.provenance = file.text("provenance");
  for (const std::string_view origin : {"cppn", "evolution"}) {
    if (file.has(origin)) static_cast<void>(file.table(origin));  // the genome of its CPPN, and what made it
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

}  // namespace trophic
