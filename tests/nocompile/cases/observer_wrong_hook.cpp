// SPDX-License-Identifier: MIT
// A hook that cannot be called would never be.
// expect: the observer's on_tick must be callable as void on_tick(const View&)
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Watcher {
#ifdef VALID
  void on_tick(const trophic::View&) {}
#else
  void on_tick(double) {}
#endif
};

int main() {
  trophic::Ecology<trophic::rules::Paper, trophic::backend::Kinematic> ecology;
  ecology.run_until(10.0, Watcher{});
}
