// SPDX-License-Identifier: MIT
// Looks up the rule tables and backends of an offer by name.
#pragma once

#include <memory>
#include <string>
#include <trophic/experiment/offer.hpp>
#include <vector>

namespace trophic::command {

[[nodiscard]] std::vector<std::string> table_names(const Offer& offer);

/// The backend with this name; null if the offer lacks it.
[[nodiscard]] const BackendChoice* find_backend(const Offer& offer, const std::string& name);

/// The default backend of a rule table: the first that both the table and the offer have, or the offer's default.
[[nodiscard]] std::string default_backend_of(const Offer& offer, const std::string& table);

/// The experiment of a rule table on a backend with default parameters; null if the offer lacks one of them.
[[nodiscard]] std::unique_ptr<AnyExperiment> find_experiment(const Offer& offer, const std::string& table,
                                                             const std::string& backend);

/// The same offer with the built backends if it has none.
[[nodiscard]] Offer with_backends(Offer offer);

}  // namespace trophic::command
