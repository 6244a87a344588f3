// SPDX-License-Identifier: MIT
// The definition of trophic/experiment/described_run.hpp.
#include <algorithm>
#include <stdexcept>
#include <tools/command/backends.hpp>
#include <tools/command/config.hpp>
#include <tools/command/offers.hpp>
#include <tools/command/toml_of_json.hpp>
#include <tools/command/words.hpp>
#include <tools/experiment/experiment_of.hpp>
#include <trophic/experiment/described_run.hpp>

namespace trophic {

namespace described {

/// Puts parameters, in nested objects or under their paths, into nested tables.
void insert_parameters(toml::table& table, const std::string& prefix, const Json& parameters) {
  for (const auto& [key, value] : parameters.items()) {
    const std::string path = prefix + key;
    if (value.is_object()) {
      insert_parameters(table, path + ".", value);
    } else if (value.is_number() || value.is_string() || value.is_boolean()) {
      command::insert_at(table, path, value);
    } else {
      throw std::invalid_argument{path + " = " + json_text(value) + ": must be a number, a text, true or false"};
    }
  }
}

/// Takes a text out of a description; empty if it is not there.
[[nodiscard]] std::string take_text(Json& description, const std::string& key) {
  if (!description.contains(key)) return {};
  const Json value = description[key];
  description.erase(key);
  if (value.is_string() && !value.get_ref<const std::string&>().empty()) return value.get<std::string>();
  throw std::invalid_argument{key + " = " + json_text(value) + ": must be a text that is not empty"};
}

void check_known(const std::string& key, const std::string& name, const std::vector<std::string>& names) {
  if (std::ranges::find(names, name) != names.end()) return;
  throw std::invalid_argument{key + " = " + command::must_be_one_of(name, names) +
                              command::did_you_mean(command::nearest_word(name, names))};
}

[[nodiscard]] Null null_of(const std::string& name) {
  const auto null = null_named(name.empty() ? "none" : name);
  if (!null) throw std::invalid_argument{"null = " + name + ": must be none, shadow, clones or one_sided_SPECIES"};
  if (*null == Null::neutral) {
    throw std::invalid_argument{"null = neutral: must be a run of a plan or of --replicates, which has the run that it repeats"};
  }
  return *null;
}

}  // namespace described

DescribedRun described_run(const Json& description, const Offer& offer) {
  if (!description.is_object()) throw std::invalid_argument{"a description: must be an object with parameters by their names"};
  const Offer whole = command::with_backends(offer);
  Json left = description;
  std::string table = described::take_text(left, "rule_table");
  if (table.empty()) table = whole.rule_tables.front().first;
  described::check_known("rule_table", table, command::table_names(whole));
  std::string engine = described::take_text(left, "engine");
  if (engine.empty()) engine = command::default_backend_of(whole, table);
  described::check_known("engine", engine, command::backend_names(whole.backends));
  const Null null = described::null_of(described::take_text(left, "null"));
  std::optional<std::uint64_t> seed;
  if (left.contains("seed")) seed = whole_number<std::uint64_t>(left, "seed");
  left.erase("seed");
  command::Config config = command::read_config({}, {});
  described::insert_parameters(config.parameters, "", left);
  const auto chosen = command::find_experiment(whole, table, engine);
  DescribedRun run{command::detail::planned_experiment(*chosen, config), null};
  if (seed) run.experiment->seed() = *seed;
  return run;
}

}  // namespace trophic
