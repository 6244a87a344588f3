// SPDX-License-Identifier: MIT
// An observer whose only hook is misspelt would see nothing.
// expect: an observer needs at least one hook
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

struct Watcher {
#ifdef VALID
  void on_tick(const trophic::View&) {}
#else
  void on_tock(const trophic::View&) {}
#endif
};

int main() {
  trophic::Ecology<trophic::rules::Paper, trophic::backend::Kinematic> ecology;
  ecology.run_until(10.0, Watcher{});
}
