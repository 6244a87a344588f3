// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <new>
#include <tools/live/footage.hpp>
#include <trophic/io/recording_head.hpp>

static long allocations_left = -1;  // until one fails; negative: none does

[[gnu::noinline]] void* operator new(std::size_t size) {
  if (allocations_left >= 0 && allocations_left-- == 0) throw std::bad_alloc{};
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc{};
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

TEST_CASE("JSON: one allocation of a writer fails, each in turn -> the program ends, and does not crash") {
  using namespace trophic;
  Arena arena;
  arena.obstacles.resize(1);
  arena.zones.push_back({.name = "burrow"});
  live::TickSight sight;
  sight.rows = {{.body = 0}, {.body = 1}};
  sight.are_spare = {false, true};
  sight.stock_J = {0.5, 1.0};
  sight.foods_J = {{"grass", {0.5, 1.0}}, {"fruit", {2.0}}};
  sight.outputs = {{0.25, -1.0}};
  const std::tuple<const char*, std::function<std::string()>> writers[] = {
      {R"("zones":[{"name":"burrow")", [&] { return json_text(io::recording::json_of(arena)); }},
      {R"("outputs":{"turn":[0.25,null])", [&] { return live::tick_messages(sight, {}).at(0)->text; }}};
  for (const auto& [part, write] : writers) {
    CHECK(write().find(part) != std::string::npos);
    long at = 0;
    for (int status = 1; WEXITSTATUS(status) != 0 || at == 0; ++at) {
      const pid_t child = ::fork();
      if (child == 0) {
        std::set_terminate([] { ::_exit(1); });  // the library's destructors ask for memory; a program ends with a sentence
        allocations_left = at;
        try {
          ::_exit(write().empty() || allocations_left < 0 ? 1 : 0);
        } catch (const std::bad_alloc&) {
          ::_exit(1);
        }
      }
      REQUIRE(::waitpid(child, &status, 0) == child);
      REQUIRE(WIFEXITED(status));
    }
    CHECK(at > 10);
  }
}
