// SPDX-License-Identifier: MIT
// From runs to results: metrics with intervals beside the paper's values and null models. `analyze --help` lists the options.
#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string>
#include <trophic/measure/report.hpp>
#include <trophic/measure/run_set.hpp>
#include <trophic/measure/summary.hpp>
#include <trophic/measure/text_table.hpp>
#include <trophic/observe/run_folder.hpp>
#include <trophic/version.hpp>
#include <vector>

#include "command.hpp"

namespace {

namespace measure = trophic::measure;

struct Options {
  std::vector<std::filesystem::path> runs;
  std::vector<std::filesystem::path> compare;
  std::filesystem::path out = "analysis";
  measure::Bootstrap bootstrap;
};

void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
  std::ofstream file{path};
  file << json.dump(2) << '\n';
  file.close();
  if (!file) throw std::runtime_error{"cannot write " + path.string()};
}

void tell(const measure::RunSet& set) {
  for (const std::string& remark : set.remarks) std::cerr << "analyze: " << remark << "\n";
}

void finish(const std::filesystem::path& out, std::span<const measure::RunSet> sets, const nlohmann::ordered_json& json) {
  measure::write_metrics(out / "metrics.csv", sets);
  write_json(out / "summary.json", json);
  std::cout << "files   " << out.string() << "/{metrics.csv,summary.json}" << std::endl;
  if (!std::cout) throw std::runtime_error{"cannot write to standard output"};
}

void analyze(const Options& options) {
  const std::array sets{measure::read_set(options.runs)};
  const auto out = trophic::observe::make_new_folder(options.out);
  tell(sets[0]);
  const auto rows = measure::summarize(sets[0].runs, options.bootstrap);
  measure::print_table(std::cout, sets[0], rows);
  measure::print_conclusions(std::cout, rows);
  nlohmann::ordered_json json;
  json["trophic"] = trophic::version;
  json["sets"].push_back(measure::summary_json(sets[0], rows));
  finish(out, sets, json);
}

void compare(const Options& options) {
  std::array sets{measure::read_set(std::span{options.compare}.subspan(0, 1)),
                  measure::read_set(std::span{options.compare}.subspan(1, 1))};
  if (sets[0].label == sets[1].label) {
    sets[0].label += " (a)";
    sets[1].label += " (b)";
  }
  const auto out = trophic::observe::make_new_folder(options.out);
  for (const measure::RunSet& set : sets) tell(set);
  const auto differences = measure::compare_sets(sets[0].runs, sets[1].runs, options.bootstrap);
  measure::print_differences(std::cout, sets[0], sets[1], differences);
  nlohmann::ordered_json json;
  json["trophic"] = trophic::version;
  for (const measure::RunSet& set : sets) {
    json["sets"].push_back(measure::summary_json(set, measure::summarize(set.runs, options.bootstrap)));
  }
  json["differences"] = measure::differences_json(differences);
  finish(out, sets, json);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace trophic::examples;
  Options options;
  CLI::App app{
      "Measures runs of predator_prey: the paper's metrics with bootstrap intervals over runs, beside its published values and "
      "null models."};
  app.add_option("runs", options.runs, "folders of runs, or of replicates; pooled, so they must have one fingerprint");
  app.add_option("--compare", options.compare, "two such folders: the difference of every metric")->expected(2);
  app.add_option("--out", options.out, "new folder for metrics.csv and summary.json (analysis)");
  app.add_option("--resamples", options.bootstrap.resamples, "bootstrap resamples (10000)");
  app.add_option("--seed", options.bootstrap.seed, "of the bootstrap (1)");
  return run_command(app, argc, argv, "analyze", [&] {
    trophic::validate(options.bootstrap, "bootstrap");
    if (options.runs.empty() == options.compare.empty()) {
      throw std::invalid_argument{"either folders of runs, or --compare and two of them"};
    }
    options.compare.empty() ? analyze(options) : compare(options);
    return 0;
  });
}
