// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <trophic/backend/clusters.hpp>
#include <trophic/support/rng.hpp>
#include <trophic/support/thread_pool.hpp>
#include <vector>

using namespace trophic::backend;
using Sets = std::vector<std::vector<std::size_t>>;

TEST_CASE("clusters: discs that overlap, also through others -> one set") {
  const std::vector<Disc> discs{{0.0, 0.0, 0.3}, {5.0, 0.0, 0.3}, {0.5, 0.0, 0.3}, {1.0, 0.1, 0.3}, {5.0, 0.6001, 0.3}};
  CHECK(connected_sets(discs) == Sets{{0, 2, 3}, {1}, {4}});
  const std::vector<Disc> touching{{0.0, 0.0, 0.5}, {1.0, 0.0, 0.5}};
  CHECK(connected_sets(touching) == Sets{{0, 1}});
  CHECK(connected_sets({}).empty());
}

TEST_CASE("clusters: large disc beyond small ones -> one set") {
  const std::vector<Disc> discs{{0.0, 0.0, 4.0}, {1.0, 6.0, 0.1}, {3.5, 0.0, 0.1}};
  CHECK(connected_sets(discs) == Sets{{0, 2}, {1}});
}

TEST_CASE("clusters: random discs -> sets from comparing all pairs") {
  for (std::uint64_t world = 0; world < 50; ++world) {
    CAPTURE(world);
    trophic::Rng rng{world, trophic::Stream::user};
    std::vector<Disc> discs(60);
    for (Disc& disc : discs) disc = {rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0), rng.uniform(0.1, 0.7)};
    std::vector<std::size_t> label(discs.size());
    for (std::size_t i = 0; i < label.size(); ++i) label[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < discs.size(); ++i) {
        for (std::size_t j = 0; j < discs.size(); ++j) {
          const double apart = std::hypot(discs[i].x_m - discs[j].x_m, discs[i].y_m - discs[j].y_m);
          if (apart <= discs[i].radius_m + discs[j].radius_m && label[j] < label[i]) {
            label[i] = label[j];
            changed = true;
          }
        }
      }
    }
    std::size_t seen = 0;
    std::size_t last_size = discs.size();
    for (const std::vector<std::size_t>& set : connected_sets(discs)) {
      CHECK(set.size() <= last_size);
      last_size = set.size();
      for (const std::size_t i : set) CHECK(label[i] == set.front());
      seen += set.size();
    }
    CHECK(seen == discs.size());
  }
}

TEST_CASE("thread pool: any number of threads, job after job -> each item once") {
  for (const std::size_t threads : {1U, 2U, 5U}) {
    trophic::ThreadPool pool{threads};
    CHECK(pool.threads() == threads);
    for (std::size_t items = 0; items < 200; ++items) {
      std::vector<std::atomic<int>> done(items);
      std::atomic<bool> known_threads = true;
      pool.run(items, [&](std::size_t item, std::size_t thread) {
        ++done[item];
        if (thread >= threads) known_threads = false;
      });
      CHECK(known_threads);
      for (const std::atomic<int>& count : done) CHECK(count == 1);
    }
  }
}

TEST_CASE("thread pool: exception in an item -> rethrown, pool stays usable") {
  trophic::ThreadPool pool{3};
  const auto fail_at_7 = [](std::size_t item, std::size_t) {
    if (item == 7) throw std::runtime_error{"seven"};
  };
  CHECK_THROWS_WITH_AS(pool.run(20, fail_at_7), "seven", std::runtime_error);
  std::atomic<int> done = 0;
  pool.run(20, [&](std::size_t, std::size_t) { ++done; });
  CHECK(done == 20);
}
