// SPDX-License-Identifier: MIT
// `trophic help`: the help of a command, or a topic.
#include <memory>
#include <sstream>
#include <tools/command/output.hpp>
#include <tools/command/run_command.hpp>
#include <tools/command/run_python.hpp>
#include <tools/command/words.hpp>
#include <tools/trophic/slots.hpp>

#include "commands.hpp"
#include "shipped_policies.hpp"

namespace trophic::command {

namespace detail::help {

struct Options {
  std::optional<std::string> topic;
  std::optional<std::string> word;
};

[[nodiscard]] int print_slots(const std::optional<std::string>& word) {
  std::ostringstream out;
  std::vector<std::string> names;
  bool any = false;
  for (std::size_t i = 0; i < slot_texts.size(); ++i) {
    const SlotText& text = slot_texts[i];
    names.emplace_back(text.slot);
    if (word && text.slot != *word) continue;
    any = true;
    out << text.slot << " (" << rules::slot_kinds[i] << ")\n  " << text.question << "\n  policies: " << shipped_policies[i]
        << "\n  swap: with_" << text.slot << "<Table, Policy>; contract and policies: include/trophic/" << rules::slot_kinds[i]
        << "/" << text.slot << "/\n";
  }
  if (!any) {
    throw std::invalid_argument{must_be_one_of("slot " + *word, names) + did_you_mean(nearest_word(*word, names))};
  }
  return print_text(out.str());
}

/// Whether a shipped policy has this name.
[[nodiscard]] bool is_policy(const std::string& name) {
  return std::ranges::any_of(shipped_policies, [&](std::string_view all) {
    return (" " + std::string{all} + " ").find(" " + name + " ") != std::string::npos;
  });
}

}  // namespace detail::help

/// Prints the help of one of `program`'s commands, the slots of a rule table or the metrics.
Command help(const std::function<Command()>& program) {
  const auto options = std::make_shared<detail::help::Options>();
  return {
      .name = "help",
      .about =
          "Prints the help of a command, or `slots`: what each slot of a rule table decides, a slot or a policy by "
          "its name, or `metrics`.",
      .options = {{.name = "topic", .target = &options->topic, .help = "a command, slots, a slot, a policy or metrics"},
                  {.name = "word", .target = &options->word, .help = "of slots: only this one"}},
      .work = [options, program]() -> int {
        const Command all = program();
        std::vector<std::string> topics{"slots", "metrics"};
        for (const Command& command : all.subcommands) topics.push_back(command.name);
        if (options->topic && !options->word && std::ranges::find(rules::slot_names, *options->topic) != rules::slot_names.end())
          return detail::help::print_slots(options->topic);
        if (options->topic && !options->word && detail::help::is_policy(*options->topic))
          return run_python({{"command", "card"}, {"who", "trophic help"}, {"policy", *options->topic}});
        if (options->word && options->topic != "slots") throw std::invalid_argument{*options->word + ": unexpected argument"};
        if (options->topic == "slots") return detail::help::print_slots(options->word);
        if (options->topic == "metrics") return run_python({{"command", "metrics"}, {"who", "trophic help metrics"}});
        if (options->topic && std::ranges::find(topics, *options->topic) == topics.end()) {
          throw std::invalid_argument{must_be_one_of(*options->topic, topics) +
                                      did_you_mean(nearest_word(*options->topic, topics))};
        }
        std::vector<const char*> words{"trophic"};
        if (options->topic) words.push_back(options->topic->c_str());
        words.push_back("--help");
        return run_command(static_cast<int>(words.size()), words.data(), all);
      },
      .examples = {"trophic help analyze", "trophic help slots", "trophic help mutation", "trophic help normal_mutation"}};
}

}  // namespace trophic::command
