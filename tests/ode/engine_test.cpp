// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <ode/scene.hpp>

#include <string>
#include <thread>
#include <trophic/backend/ode/engine.hpp>
#include <vector>

namespace ode = trophic::backend::ode;

TEST_CASE("ODE engine: assertions, errors and messages -> exceptions") {
  const ode::EngineGuard guard;
  CHECK_THROWS_AS(dDebug(d_ERR_IASSERT, "assertion %d", 7), ode::EngineError);
  CHECK_THROWS_AS(dError(d_ERR_UNKNOWN, "error"), ode::EngineError);
  CHECK_THROWS_AS(dMessage(d_ERR_LCP, "message"), ode::EngineError);
  try {
    dDebug(d_ERR_IASSERT, "assertion %d failed", 7);
  } catch (const ode::EngineError& error) {
    CHECK(std::string{error.what()} == "ODE: assertion 7 failed");
  }
  // A real one, from inside a step: a force that is not finite.
  ode::WorldPtr world{dWorldCreate()};
  const dBodyID body = dBodyCreate(world.get());
  dMass no_mass;
  dMassSetZero(&no_mass);
  CHECK_THROWS_AS(dBodySetMass(body, &no_mass), ode::EngineError);
}

TEST_CASE("ODE engine: several backends in several threads -> all walk") {
  const trophic::test::OdeWorld world;
  trophic::backend::Ode alone = world.make();
  trophic::test::walk(alone, 0.5);
  std::vector<trophic::backend::Ode::State> ends(3);
  std::vector<std::thread> threads;
  for (auto& end : ends) {
    threads.emplace_back([&world, &end] {
      for (int i = 0; i < 3; ++i) {
        trophic::backend::Ode backend = world.make();
        trophic::test::walk(backend, 0.5);
        end = backend.save();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& end : ends) CHECK(end == alone.save());
}
