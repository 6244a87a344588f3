// SPDX-License-Identifier: MIT
// One description of a run for programs: that of a configuration file.
#include <doctest/doctest.h>

#include <support/temporary_folder.hpp>
#include <trophic/experiment/described_run.hpp>
#include <trophic/experiment/table_experiment.hpp>
#include <trophic/rules/paper.hpp>
#include <trophic/rules/released.hpp>

namespace {

using namespace trophic;

[[nodiscard]] Offer offer() {
  return {.rule_tables = rule_tables<rules::Paper, rules::Released>()};
}

[[nodiscard]] std::string refusal(const Json& description) {
  return test::message_of<std::invalid_argument>([&] { static_cast<void>(described_run(description, offer())); });
}

[[nodiscard]] observe::RunDescription description_of(const Json& description) {
  return described_run(description, offer()).simulation()->describe(100.0);
}

TEST_CASE("described run: paths or nested objects -> the run of these parameters") {
  const Json nested{{"rule_table", "released"},
                    {"engine", "kinematic"},
                    {"seed", 9007199254740992U},
                    {"ecology", {{"robots", 24}}},
                    {"rules", {{"mutation", {{"half_width", 0.1}}}}}};
  const Json paths{
      {"rule_table", "released"}, {"engine", "kinematic"}, {"ecology.robots", 24}, {"rules.mutation.half_width", 0.1}};
  const auto run = description_of(nested);
  CHECK(run.rules == "released");
  CHECK(run.seed == 9007199254740992U);
  CHECK(run.backend.starts_with("kinematic"));
  CHECK(run.fingerprint == description_of(paths).fingerprint);
  CHECK(run.other_params.size() == 2);
}

TEST_CASE("described run: its null -> that of the command line") {
  const auto run = description_of({{"engine", "kinematic"}, {"null", "one_sided_prey"}});
  CHECK(run.rules.starts_with("paper with heredity = "));
}

TEST_CASE("described run: a wrong field -> a sentence with field, value and bound") {
  CHECK(refusal(Json::array()) == "a description: must be an object with parameters by their names");
  CHECK(refusal({{"rule_table", "papr"}}).find("rule_table = papr: must be paper or released; did you mean paper?") == 0);
  CHECK(refusal({{"engine", 3}}) == "engine = 3: must be a text that is not empty");
  CHECK(refusal({{"engine", "kinematic"}, {"seed", -1}}).find("seed = -1: must be a whole number from 0 to ") == 0);
  CHECK(refusal({{"engine", "kinematic"}, {"rules.mutation.sdd", 1}}) ==
        "rules.mutation.sdd: unknown key; did you mean rules.mutation.sd?");
  CHECK(refusal({{"engine", "kinematic"}, {"rules", {{"mutation", {{"sd", -1.0}}}}}}).find("rules.mutation.sd = -1") == 0);
  CHECK(refusal({{"engine", "kinematic"}, {"rules.mutation.sd", nullptr}}) ==
        "rules.mutation.sd = null: must be a number, a text, true or false");
  CHECK(refusal({{"engine", "kinematic"}, {"null", "neutral"}}).find("null = neutral: must be a run of a plan") == 0);
  CHECK(refusal({{"engine", "kinematic"}, {"null", "nul"}}) == "null = nul: must be none, shadow, clones or one_sided_SPECIES");
}

}  // namespace
