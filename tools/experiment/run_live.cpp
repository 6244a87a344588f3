// SPDX-License-Identifier: MIT
// Definitions of run_live.hpp.
#include <iostream>
#include <tools/command/output.hpp>
#include <tools/command/run_command.hpp>
#include <tools/experiment/experiment_of.hpp>
#include <tools/experiment/run_experiment.hpp>
#include <tools/experiment/run_live.hpp>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/io/run_folder.hpp>

namespace trophic::command {

namespace detail {

/// Those of rules.
[[nodiscard]] NamedParams of_rules(NamedParams parameters) {
  std::erase_if(parameters, [](const NamedParam& one) { return !one.path.starts_with("rules."); });
  return parameters;
}

/// Options and parameters of the run that a page asks for.
void restart(const Restart& restart, const std::string& old_table, const std::filesystem::path& first_out,
             ExperimentOptions& options, Config& config) {
  options.seed = restart.seed;
  options.resume = false;
  options.out = io::next_free_folder(first_out).string();
  if (restart.rule_table == old_table) {
    for (const observe::ParameterChange& row : restart.made) config.assignments.push_back(row.number + "=" + row.value);
    return;
  }
  options.rules = restart.rule_table;
  config.parameters.erase("rules");
  std::erase_if(config.assignments, [](const std::string& assignment) { return assignment.starts_with("rules."); });
}

/// Throws std::invalid_argument if trophic was built without the page.
[[nodiscard]] std::unique_ptr<LiveServer> open_live([[maybe_unused]] std::uint16_t port) {
#ifdef TROPHIC_WITH_LIVE
  return live::open(port);
#else
  throw std::invalid_argument{
      "--live: trophic was built without its live page; install libboost-dev and build it with -DTROPHIC_VIEWER=ON"};
#endif
}

}  // namespace detail

int run_live(std::unique_ptr<AnyExperiment> chosen, ExperimentOptions options, Config config, const Offer& offer) {
  const std::filesystem::path first_out = options.out;
  {  // Refusals come before a port is opened.
    if (!options.resume) io::check_new_folder(options.out);
    const auto experiment = detail::experiment_of(*chosen, options, config);
    static_cast<void>(detail::simulations(*chosen, options, config, *experiment, Null::none)(experiment->seed()));
  }
  const std::unique_ptr<LiveServer> server = detail::open_live(static_cast<std::uint16_t>(options.live_port.value_or(0)));
  for (;;) {
    int code = 0;
    try {
      const auto experiment = detail::experiment_of(*chosen, options, config);
      server->begin(
          {.folder = options.out,
           .rule_table = chosen->rule_table(),
           .rule_tables = table_names(offer),
           .seed = experiment->seed(),
           .until_s = experiment->ecology().duration_s,
           .numbers = detail::of_rules(experiment->simulations(Null::none)(experiment->seed())->describe(0.0).named_params),
           .table = detail::of_rules(named_params_of(chosen->fresh()->params()))});
      code = detail::run_once(options, *experiment,
                              detail::simulations(*chosen, options, config, *experiment, Null::none, {}, &server->conductor()),
                              std::nullopt, server.get());
    } catch (const std::exception& error) {
      code = report_failure(options.program.c_str(), error);
      server->failed(error.what());
    }
    const std::optional<Restart> next = server->next();
    if (!next) return code;
    detail::restart(*next, chosen->rule_table(), first_out, options, config);
    chosen = find_experiment(offer, next->rule_table, chosen->backend().name());
    if (chosen == nullptr) throw std::invalid_argument{"rule table " + next->rule_table + ": is not a table of this program"};
    options.provenance.emplace_back("restarted", "by the live page of the run in " + first_out.string());
    std::cout << "live    seed " << next->seed << ", rules " << next->rule_table << ", into " << shown(options.out) << std::endl;
  }
}

}  // namespace trophic::command
