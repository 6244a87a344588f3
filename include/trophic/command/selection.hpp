// SPDX-License-Identifier: MIT
// The offer of an experiment program: rule tables and backends, any table on any backend.
#pragma once

#include <memory>
#include <string>
#include <trophic/command/any_experiment.hpp>
#include <trophic/command/backends.hpp>
#include <vector>

namespace trophic::command {

/// A rule table with its name.
struct OfferedTable {
  std::string name;
  std::unique_ptr<AnyExperiment> (*experiment)(const LinkedBackend& backend);  ///< with the numbers that table and backend have
};

/// A table on a backend. Refers to both.
struct Selection {
  const OfferedTable* table;
  const LinkedBackend* backend;

  [[nodiscard]] std::unique_ptr<AnyExperiment> experiment() const { return table->experiment(*backend); }
};

/// All tables and backends that a program was built with.
struct Offer {
  std::vector<OfferedTable> tables;  ///< the first is the default
  std::vector<LinkedBackend> backends;
  std::string default_backend;  ///< need not be among them

  [[nodiscard]] std::vector<std::string> table_names() const { return names_of(tables); }
  [[nodiscard]] std::vector<std::string> backend_names() const { return names_of(backends); }

  [[nodiscard]] const OfferedTable* table(const std::string& name) const { return find(tables, name); }       ///< null: none
  [[nodiscard]] const LinkedBackend* backend(const std::string& name) const { return find(backends, name); }  ///< null: none

 private:
  template <class Named>
  [[nodiscard]] static std::vector<std::string> names_of(const std::vector<Named>& all) {
    std::vector<std::string> names;
    for (const Named& one : all) names.push_back(one.name);
    return names;
  }
  template <class Named>
  [[nodiscard]] static const Named* find(const std::vector<Named>& all, const std::string& name) {
    for (const Named& one : all) {
      if (one.name == name) return &one;
    }
    return nullptr;
  }
};

}  // namespace trophic::command
