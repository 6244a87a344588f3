// SPDX-License-Identifier: MIT
// Lotka's and Volterra's predators and prey: a well-mixed world without a carrying capacity.
#pragma once

#include <cmath>
#include <numbers>
#include <trophic/rules/with.hpp>
#include <trophic/worlds/rosenzweig_macarthur.hpp>

namespace trophic::worlds {

inline constexpr auto lotka_volterra_params = [](auto& params) {
  params.community.predators = 500;
  params.recruitment = {.spare_bodies = 1150, .r = 0.01, .K = 1e12, .e = 1.0};
  params.capture = {.reach_m = 0.1 * std::sqrt(2e-5 / std::numbers::pi), .handling_ticks = 0};
  params.senescence = {.m = 0.01};
};

/// Rules: like RosenzweigMacArthur, without a carrying capacity and without handling time.   Source: [lotka1925] [volterra1926].
/// Numbers cycle, with an amplitude that only chance changes. The means over whole periods do not depend on it: N* = m / (a e)
/// and P* = r / a, here 500 and 500, in periods of about 2 pi / sqrt(r m) = 630 ticks.   Runs only on the backend `torus`.
using LotkaVolterra = named<with_params<RosenzweigMacArthur, lotka_volterra_params>, "lotka_volterra">;

}  // namespace trophic::worlds
