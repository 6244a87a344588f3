// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <stop_token>
#include <thread>
#include <trophic/support/faster_mode.hpp>
#include <trophic/support/thread_pool.hpp>
#include <vector>

using namespace trophic;

TEST_CASE("a pool does each item once in many thousand short jobs, whoever comes late") {
  ThreadPool pool{4};  // more than there may be processors: some come late
  std::vector<std::atomic<std::uint32_t>> done(50);
  for (std::uint32_t job = 1; job <= 5000; ++job) {
    const std::size_t items = 1 + job % done.size();
    pool.run(items, [&](std::size_t item, std::size_t) { done[item].fetch_add(job); });
    for (std::size_t item = 0; item < done.size(); ++item) {
      const std::uint32_t sum = done[item].exchange(0);
      REQUIRE(sum == (item < items ? job : 0));
    }
  }
}

TEST_CASE("a pool that goes while its helpers come up does nothing more") {
  for (int i = 0; i < 300; ++i) {
    std::atomic<int> done = 0;
    ThreadPool pool{3};
    pool.run(5, [&](std::size_t, std::size_t) { ++done; });
    CHECK(done == 5);
  }
}

TEST_CASE("a pool that goes while its helpers wake up for a job does not wait for them for ever") {
  std::vector<std::jthread> others;  // who take helpers off their processor, the longer the better
  for (int i = 0; i < 8; ++i) {
    others.emplace_back([](const std::stop_token& stop) {
      while (!stop.stop_requested()) std::this_thread::yield();
    });
  }
  for (int i = 0; i < 2000; ++i) {
    ThreadPool pool{3};
    for (int job = 0; job < 3; ++job) pool.run(2, [](std::size_t, std::size_t) {});
  }
}

TEST_CASE("a pool finishes the other items of a job in which one fails, alone or together") {
  ThreadPool pool{2};
  for (int job = 0; job < 100; ++job) {  // among so many both ways are taken
    std::atomic<int> done = 0;
    CHECK_THROWS_AS(pool.run(10,
                             [&](std::size_t item, std::size_t) {
                               ++done;
                               if (item == 3) throw std::runtime_error{"three"};
                             }),
                    std::runtime_error);
    CHECK(done == 10);
  }
}

namespace {

/// How many of so many jobs go the first way, if the ways take so long; what they take is noted so often.
int first_of(FasterMode& ways, int jobs, double first_s, double second_s, int notes = 8) {
  int firsts = 0;
  for (int i = 0; i < jobs; ++i) {
    bool first = false;
    {
      const FasterMode::Trial trial = ways.next(1'000'000'000);  // what the clock says counts for nothing beside what is noted
      first = trial.first();
    }
    for (int k = 0; k < notes; ++k) ways.note(first, first ? first_s : second_s);
    firsts += first ? 1 : 0;
  }
  return firsts;
}

}  // namespace

TEST_CASE("the faster way is taken, the slower one is tried rarely, and a change is noticed") {
  FasterMode ways;
  CHECK(first_of(ways, 1000, 1.0, 3.0) > 950);
  CHECK(first_of(ways, 10'000, 1.0, 3.0) > 9'800);
  CHECK(first_of(ways, 10'000, 9.0, 3.0) < 500);
  CHECK(first_of(ways, 10'000, 1.0, 3.0) > 9'500);
}

TEST_CASE("a job in which the clock stood still, or went back, is soon forgotten") {
  for (const double seconds : {0.0, -1e-9}) {
    for (const bool first : {true, false}) {
      CAPTURE(seconds);
      CAPTURE(first);
      FasterMode ways;
      ways.note(first, seconds);
      first_of(ways, 100, first ? 3.0 : 1.0, first ? 1.0 : 3.0);
      const int firsts = first_of(ways, 1000, first ? 3.0 : 1.0, first ? 1.0 : 3.0);
      CHECK((first ? 1000 - firsts : firsts) > 950);
    }
  }
}

TEST_CASE("a pause of an hour in one job, the first or a later one, is soon forgotten") {
  for (const bool at_once : {true, false}) {
    CAPTURE(at_once);
    FasterMode ways;
    if (!at_once) first_of(ways, 1000, 0.5, 1.0, 1);
    ways.note(true, 3600.0 * 1e6);
    first_of(ways, 10'000, 0.5, 1.0, 1);
    CHECK(first_of(ways, 1000, 0.5, 1.0, 1) > 950);
  }
}
