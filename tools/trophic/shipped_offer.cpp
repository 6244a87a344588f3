// SPDX-License-Identifier: MIT
// Definitions of shipped_offer.hpp.
#include "shipped_offer.hpp"

#include <memory>
#include <string>
#include <trophic/command/backends.hpp>
#include <trophic/command/table_experiment.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/rules/table.hpp>

namespace trophic::command {

Offer shipped_offer() {
  return {.tables = {{table_name<rules::Paper>(),
                      [](const LinkedBackend& backend) -> std::unique_ptr<AnyExperiment> {
                        return std::make_unique<TableExperiment<rules::Paper>>(backend);
                      }},
                     {table_name<rules::Released>(),
                      [](const LinkedBackend& backend) -> std::unique_ptr<AnyExperiment> {
                        return std::make_unique<TableExperiment<rules::Released>>(backend);
                      }}},
          .backends = linked_backends<LinkedBackends>(),
          .default_backend = std::string{LinkedBackends::default_backend}};
}

}  // namespace trophic::command
