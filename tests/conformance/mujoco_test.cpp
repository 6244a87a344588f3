// SPDX-License-Identifier: MIT
#include <conformance/backend_suite.hpp>
#include <trophic/backend/mujoco.hpp>

TEST_CASE_TEMPLATE_INVOKE(trophic_backend_suite, trophic::backend::Mujoco);
