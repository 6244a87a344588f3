// SPDX-License-Identifier: MIT
// Definitions of run_live.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <trophic/command/run_experiment.ipp>
#include <trophic/command/run_live.hpp>
#include <trophic/io/next_free_folder.hpp>
#include <trophic/io/run_folder.hpp>
#include <vector>

namespace trophic::command {

namespace detail {

/// The numbers of rules of an experiment.
[[nodiscard]] inline NamedParams rule_numbers(const AnyExperiment& experiment) {
  NamedParams numbers = experiment.named_params();
  std::erase_if(numbers, [](const NamedParam& number) { return !number.path.starts_with("rules."); });
  return numbers;
}

/// Options and numbers of the run that a page asks for.
inline void restart(const Restart& restart, const std::string& old_table, const std::filesystem::path& first_out,
                    ExperimentOptions& options, Config& config) {
  options.seed = restart.seed;
  options.resume = false;
  options.out = io::next_free_folder(first_out).string();
  if (restart.rule_table == old_table) {
    for (const changes::ChangeRow& row : restart.made) config.assignments.push_back(row.number + "=" + row.value);
    return;
  }
  options.rules = restart.rule_table;
  config.numbers.erase("rules");
  std::erase_if(config.assignments, [](const std::string& assignment) { return assignment.starts_with("rules."); });
}

}  // namespace detail

TROPHIC_INLINE int run_live(Selection selection, ExperimentOptions options, Config config, const Offer& offer,
                            OpenLive open_live) {
  if (open_live == nullptr) {
    throw std::invalid_argument{
        "--live: this program was built without a live page; apt-get install libboost-dev, build trophic again and link "
        "trophic::live"};
  }
  const std::filesystem::path first_out = options.out;
  {  // Refusals come before a port is opened.
    if (!options.resume) io::check_new_folder(options.out);
    const auto experiment = detail::experiment_of(selection, options, config);
    static_cast<void>(detail::simulations(selection, options, config, *experiment, false)(experiment->seed()));
  }
  const std::unique_ptr<LiveServer> server =
      open_live(options.program, static_cast<std::uint16_t>(options.live_port.value_or(0)));
  for (;;) {
    const auto experiment = detail::experiment_of(selection, options, config);
    server->begin({.folder = options.out,
                   .rule_table = selection.table->name,
                   .rule_tables = offer.table_names(),
                   .seed = experiment->seed(),
                   .until_s = experiment->ecology().duration_s,
                   .numbers = detail::rule_numbers(*experiment)});
    const int code = detail::run_once(options, *experiment,
                                      detail::simulations(selection, options, config, *experiment, false, &server->conductor()),
                                      std::nullopt, server.get());
    const std::optional<Restart> next = server->next();
    if (!next) return code;
    detail::restart(*next, selection.table->name, first_out, options, config);
    selection.table = offer.table(next->rule_table);
    if (selection.table == nullptr)
      throw std::invalid_argument{"rule table " + next->rule_table + ": is not one of this program"};
    options.provenance.emplace_back("restarted", "by the live page of the run in " + first_out.string());
    std::cout << "live    seed " << next->seed << ", rules " << next->rule_table << ", into " << options.out << std::endl;
  }
}

}  // namespace trophic::command
