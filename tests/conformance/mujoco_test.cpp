// SPDX-License-Identifier: MIT
#include <conformance/backend_suite.hpp>
#include <conformance/embodying_suite.hpp>
#include <conformance/ground_suite.hpp>
#include <conformance/placing_suite.hpp>
#include <conformance/species_suite.hpp>
#include <trophic/backend/mujoco.hpp>

namespace {

using trophic::backend::Mujoco;

template <Mujoco::Stepping chosen>
struct Stepped : Mujoco {
  using Mujoco::Mujoco;
  static constexpr bool rounds_with_others = chosen == Mujoco::Stepping::one_model;  ///< one system of equations for all robots
  struct Params : Mujoco::Params {
    using Backend = Stepped;
    Params() : Mujoco::Params{.stepping = chosen} {}
  };
};

}  // namespace

TEST_CASE_TEMPLATE_INVOKE(trophic_backend_suite, trophic::backend::Mujoco);
TEST_CASE_TEMPLATE_INVOKE(trophic_embodying_suite, trophic::backend::Mujoco);
TEST_CASE_TEMPLATE_INVOKE(trophic_placing_suite, Mujoco, Stepped<Mujoco::Stepping::islands>,
                          Stepped<Mujoco::Stepping::one_model>);
TEST_CASE_TEMPLATE_INVOKE(trophic_ground_suite, trophic::backend::Mujoco);
TEST_CASE_TEMPLATE_INVOKE(trophic_species_suite, trophic::backend::Mujoco);
