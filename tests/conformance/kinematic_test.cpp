// SPDX-License-Identifier: MIT
#include <conformance/backend_suite.hpp>
#include <conformance/ground_suite.hpp>
#include <conformance/placing_suite.hpp>
#include <conformance/species_suite.hpp>
#include <trophic/backend/kinematic.hpp>
#include <trophic/backend/torus.hpp>

TEST_CASE_TEMPLATE_INVOKE(trophic_backend_suite, trophic::backend::Kinematic, trophic::backend::Torus);
TEST_CASE_TEMPLATE_INVOKE(trophic_placing_suite, trophic::backend::Kinematic, trophic::backend::Torus);
TEST_CASE_TEMPLATE_INVOKE(trophic_ground_suite, trophic::backend::Kinematic, trophic::backend::Torus);
TEST_CASE_TEMPLATE_INVOKE(trophic_species_suite, trophic::backend::Kinematic, trophic::backend::Torus);
