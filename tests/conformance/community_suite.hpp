// SPDX-License-Identifier: MIT
// The contract of every community, as one doctest case: TEST_CASE_TEMPLATE_INVOKE(trophic_community_suite, MyCommunity);
#pragma once

#include <conformance/policy_suite.hpp>
#include <trophic/initialization/community/contract.hpp>

TEST_CASE_TEMPLATE_DEFINE("community", Policy, trophic_community_suite) {
  using namespace trophic;
  static_assert(initialization::Community<Policy>);
  conformance::check_policy<Policy>();
  const auto policy = conformance::defaulted<Policy>();
  const FoodWeb web = policy.web();
  CHECK(web.size() > 0);
  for (Species species = 0; species < web.size(); ++species) CHECK_FALSE(web.name(species).empty());
  for (const std::size_t robots : {std::size_t{30}, std::size_t{100}}) {
    const auto founders = policy.founders(robots);
    CHECK(founders.size() == robots);
    CHECK(founders == policy.founders(robots));
    for (const Species species : founders) CHECK(species < web.size());
  }
  conformance::check_params_used<Policy>([&](const Policy& made) {
    conformance::Answers answers;
    const FoodWeb links_of = made.web();
    for (const Feeding& link : links_of.links()) answers.add(std::pair{link.hunter, link.victim});
    answers.add(made.founders(30));
    answers.add(made.founders(100));
    return answers;
  });
}
