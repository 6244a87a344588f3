// SPDX-License-Identifier: MIT
// `trophic cite`: how a paper cites a run.
#include <tools/analysis/data/pooled_runs.hpp>
#include <tools/analysis/data/run_manifest.hpp>
#include <tools/analysis/data/sweep_runs.hpp>
#include <tools/command/output.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/params/named_params.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>
#include <trophic/support/json.hpp>
#include <trophic/support/whole_file.hpp>

#include "commands.hpp"

namespace trophic::command {

namespace detail::cite {

/// The parameters of a shipped rule table; none for another table.
[[nodiscard]] std::optional<NamedParams> defaults_of(const std::string& table) {
  if (table == table_name<rules::Paper>()) return named_params_of(Experiment<rules::Paper>{});
  if (table == table_name<rules::Released>()) return named_params_of(Experiment<rules::Released>{});
  return std::nullopt;
}

/// The number of a manifest under a path such as "rules.mutation.sd"; null if there is none.
[[nodiscard]] Json value_at(const Json& params, std::string_view path) {
  const std::size_t dot = path.find('.');
  const std::string key{path.substr(0, dot)};
  if (!params.is_object() || !params.contains(key)) return {};
  return dot == std::string_view::npos ? params[key] : value_at(params[key], path.substr(dot + 1));
}

/// "rules.mutation.sd = 0.1 (0.05)" for each parameter that is not the table's; how long a run is and its seed are said apart.
[[nodiscard]] std::vector<std::string> changes(const Json& params, const NamedParams& defaults) {
  std::vector<std::string> texts;
  for (const NamedParam& param : defaults) {
    if (param.path == "seed" || param.path == "ecology.duration_s") continue;
    const Json value = value_at(params, param.path);
    if (value.is_null() || value_text(param).empty()) continue;  // such as the gait, which follows from the robot
    const auto is_same = [&](const auto& number) -> bool {
      using T = std::remove_cvref_t<decltype(number)>;
      if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
        return value.is_number() && value.get<double>() == static_cast<double>(number);
      } else {
        return value == Json(number);
      }
    };
    if (std::visit(is_same, param.value)) continue;
    texts.push_back(param.path + " = " + (value.is_string() ? value.get<std::string>() : json_text(value)) + " (" +
                    value_text(param) + ")");
  }
  return texts;
}

[[nodiscard]] std::string text(const Json& json, const char* key, const std::string& otherwise = "unknown") {
  return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : otherwise;
}

/// Throws std::invalid_argument if it cannot be read: it is what the user named.
[[nodiscard]] analysis::RunManifest manifest_in(const std::filesystem::path& run) {
  try {
    return analysis::read_manifest(run);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument{error.what()};
  }
}

[[nodiscard]] int run(const std::string& folder) {
  if (analysis::is_sweep(folder)) throw std::invalid_argument{folder + ": is a sweep; name one of its cells"};
  std::vector<std::string> remarks;
  const auto runs = analysis::run_folders(folder, remarks);
  if (runs.empty()) throw std::invalid_argument{folder + ": no run is there"};
  const analysis::RunManifest manifest = manifest_in(runs.front());
  const Json json = parse_json(read_whole_file(runs.front() / "manifest.json"));
  const std::string version = text(json, "trophic");
  const std::string revision = text(json, "source_revision");
  std::string sentence = (runs.size() > 1 ? std::to_string(runs.size()) + " runs" : std::string{"A run"}) + " of " +
                         number_text(manifest.until_s) + " s with the rule table `" + manifest.rules + "` on " +
                         manifest.backend + " in trophic " + version + " (revision " + revision + ", fingerprint " +
                         manifest.fingerprint + ", ";
  sentence += json.contains("master_seed") ? "master seed " + text(json, "master_seed") : "seed " + std::to_string(manifest.seed);
  sentence += ")";
  const auto defaults = defaults_of(manifest.rules);
  if (!defaults) {
    sentence += "; the rule table and its parameters are in manifest.json";
  } else {
    const auto changed = changes(manifest.params, *defaults);
    sentence +=
        changed.empty() ? ", with the parameters of the table" : ", with these parameters changed (the table's in brackets): ";
    for (std::size_t i = 0; i < changed.size(); ++i) sentence += (i > 0 ? "; " : "") + changed[i];
  }
  sentence += ".";
  if (!manifest.begins.empty()) sentence += (runs.size() > 1 ? " They begin " : " It begins ") + manifest.begins + ".";
  return print_text(sentence + R"(

@misc{trophic,
  title = {trophic: ecologies of simulated robots with rules at compile time and physics behind an adapter},
  author = {{The trophic authors}},
  year = {2026},
  note = {Software, version )" +
                    version + R"(, revision )" + revision + R"(}
}
@article{kachler2023,
  title = {Open-endedness induced through a predator-prey scenario using modular robots},
  author = {Kachler, Dimitri and Miras, Karine},
  journal = {arXiv:2309.11275},
  year = {2023},
  doi = {10.48550/arXiv.2309.11275}
}
)");
}

}  // namespace detail::cite

/// Prints how to cite a run.
Command cite() {
  const auto folder = std::make_shared<std::string>();
  return {
      .name = "cite",
      .about =
          "Prints how to cite a run or a set of replicates: a sentence with rule table, changed parameters, engine, version and "
          "seed from its manifest, and BibTeX entries.",
      .options = {{.name = "run", .target = folder.get(), .help = "folder of a run or of replicates", .required = true}},
      .work = [folder] { return detail::cite::run(*folder); },
      .subcommands = {},
      .version = {},
      .examples = {"trophic cite runs/paper"}};
}

}  // namespace trophic::command
