// SPDX-License-Identifier: MIT
// Definitions of offers.hpp.
#include <algorithm>
#include <tools/command/backends.hpp>
#include <tools/command/offers.hpp>
#include <utility>

namespace trophic::command {

std::vector<std::string> table_names(const Offer& offer) {
  std::vector<std::string> names;
  for (const auto& [name, make] : offer.rule_tables) names.push_back(name);
  return names;
}

const BackendChoice* find_backend(const Offer& offer, const std::string& name) {
  const auto found = std::ranges::find(offer.backends, name, &BackendChoice::name);
  return found == offer.backends.end() ? nullptr : &*found;
}

std::unique_ptr<AnyExperiment> find_experiment(const Offer& offer, const std::string& table, const std::string& backend) {
  const auto made = std::ranges::find(offer.rule_tables, table, &std::pair<std::string, MakeExperiment>::first);
  const BackendChoice* on = find_backend(offer, backend);
  return made == offer.rule_tables.end() || on == nullptr ? nullptr : made->second(*on);
}

std::string default_backend_of(const Offer& offer, const std::string& table) {
  if (offer.backends.empty()) return offer.default_backend;
  const auto experiment = find_experiment(offer, table, offer.backends.front().name());
  for (const std::string& name : experiment == nullptr ? std::vector<std::string>{} : experiment->backends())
    if (find_backend(offer, name) != nullptr) return name;
  return offer.default_backend;
}

Offer with_backends(Offer offer) {
  if (offer.default_backend.empty()) {
    offer.default_backend = offer.backends.empty() ? std::string{default_backend} : offer.backends.front().name();
  }
  if (offer.backends.empty()) offer.backends = built_backends();
  return offer;
}

}  // namespace trophic::command
