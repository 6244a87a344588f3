// SPDX-License-Identifier: MIT
// Whether a final class has a hook of a wrong signature could not be told.
// expect: an observer must not be final
#include <trophic/backend/kinematic.hpp>
#include <trophic/ecology/ecology.hpp>
#include <trophic/habitat/load/habitat.hpp>
#include <trophic/rules/paper.hpp>

#ifdef VALID
struct Watcher {
#else
struct Watcher final {
#endif
  void on_tick(const trophic::View&) {}
};

int main() {
  trophic::Ecology<trophic::rules::Paper, trophic::backend::Kinematic> ecology;
  ecology.run_until(10.0, Watcher{});
}
