// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <tools/experiment/printed_rules.hpp>
#include <trophic/ecology/experiment.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

using namespace trophic;
using command::params_text;
using command::PrintedRule;

namespace {

/// A rule with a source in which every character is special somewhere.
struct Odd {
  static constexpr std::string_view name = "odd_rule";
  static constexpr std::string_view source = R"(50 % of "A & B" {$5} #1 a_b ^ ~ \ <c|d> *)";
  struct Params {
    double share = 1.0 / 3.0;
    bool strict_one = true;
    static constexpr auto fields() {
      return std::tuple{field("share", &Params::share, at_least(0.0)), field("strict_one", &Params::strict_one)};
    }
  };
  Params params;
  [[nodiscard]] bool dies(const Individual&, const View&, Rng&) const { return false; }
};

/// A user's rule that names no source.
struct NoSource {
  static constexpr std::string_view name = "plain";
  [[nodiscard]] bool may_die(Species, const View&) const { return true; }
};

using Swapped = with_floor<with_senescence<rules::Paper, Odd>, NoSource>;

std::string line_of(const std::string& text, std::string_view beginning) {
  const std::size_t begin = text.find(beginning);
  REQUIRE(begin != std::string::npos);
  return text.substr(begin, text.find('\n', begin) - begin);
}

template <class Rules>
std::vector<PrintedRule> printed(Experiment<Rules> experiment = {}) {
  return command::printed_rules(rules::slot_rules<Rules>(), named_params_of(param_refs(experiment)));
}

}  // namespace

TEST_CASE("print table: rule table -> a line per rule in the order of slots, then ecology and physics") {
  const auto lines = printed<Swapped>();
  std::vector<std::string_view> slots;
  for (const auto& rule : rules::slot_rules<Swapped>()) slots.push_back(rule.slot);
  REQUIRE(lines.size() == slots.size() + 2);
  for (std::size_t i = 0; i < slots.size(); ++i) CHECK(lines[i].slot == slots[i]);
  CHECK(lines[0].kind == "initialization");
  CHECK(lines[0].policy == "predator_prey");
  CHECK(params_text(lines[0].params) == "predators = 14");
  CHECK(lines[0].source == "paper, Sec. \"Initialization\"");
  CHECK(lines[lines.size() - 2].kind == "ecology");
  CHECK(params_text(lines[lines.size() - 2].params) ==
        "robots = 30, duration_s = 6000, tick_s = 2, first_tick_s = 0, control_hz = 60, clock_scale = 1, robot = spider, arena = "
        "walled_square, cpg_integration = exact, idle_control_steps = 0, phase_at_birth = kept, decision_order = together, "
        "without_target = decides, ends_when = time_is_up");
  CHECK(params_text(lines.back().params) == "timestep_s = 0.0012, integrator = semi_implicit_euler, gravity_m_s2 = 9.81");
}

TEST_CASE("print table: special characters -> escaped in Markdown") {
  const std::string markdown = markdown_table(printed<Swapped>());
  CHECK(markdown.starts_with(
      "| kind | slot | policy | parameters | source |\n|---|---|---|---|---|\n"
      "| initialization | community | predator\\_prey | predators = 14 | paper, Sec. \"Initialization\" |\n"));
  CHECK(line_of(markdown, "| death | senescence |") ==
        R"(| death | senescence | odd\_rule | share = 0.333333, strict\_one = true | )"
        R"(50 % of "A & B" {$5} #1 a\_b ^ \~ \\ \<c\|d\> \* |)");
  CHECK(line_of(markdown, "| death | floor |") == "| death | floor | plain |  |  |");
}

TEST_CASE("print table: given numbers -> printed instead of the table's own") {
  Experiment<rules::Released> experiment;
  experiment.rules.minimum_predators.below = 9;
  CHECK(line_of(markdown_table(printed<rules::Released>()), "| death | minimum\\_predators |").find("below = 8") !=
        std::string::npos);
  CHECK(line_of(markdown_table(printed(experiment)), "| death | minimum\\_predators |").find("below = 9") != std::string::npos);
}
