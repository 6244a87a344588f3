// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <csignal>
#include <tools/replicates/stop_on_signal.hpp>
#include <trophic/observe/hooks.hpp>

using namespace trophic;

TEST_CASE("stop on signal: first signal -> run stops, signal reported") {
  static_assert(observe::Observer<const replicates::StopOnSignal>);
  const replicates::StopOnSignal stop;
  CHECK(stop.keep_running());
  CHECK(replicates::StopOnSignal::caught() == 0);
  std::raise(SIGTERM);
  CHECK_FALSE(stop.keep_running());
  CHECK(replicates::StopOnSignal::caught() == SIGTERM);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}
