// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <tools/analysis/statistics/difference.hpp>
#include <vector>

using namespace trophic::analysis;

TEST_CASE("a difference has a p value where its contrast has one") {
  const std::vector<double> a{1.0, 1.1, 0.9, 1.0, 1.1, 0.9};
  const std::vector<double> b{2.0, 2.1, 1.9, 2.0, 2.1, 1.9};
  const Difference found = difference_of(1.0, contrast({{-1.0, a}, {1.0, b}}));
  CHECK(*found.p < 1e-6);
  CHECK(found.interval->lower > 0.8);
  CHECK_FALSE(found.differs());  // not before it is adjusted
  CHECK_FALSE(difference_of(1.0, std::nullopt).p);
}

TEST_CASE("differences are corrected together, and those without a p value do not count") {
  Difference small{.value = 1.0, .interval = {}, .p = 0.02, .adjusted = {}};
  Difference none{.value = 0.0, .interval = {}, .p = {}, .adjusted = 0.001};
  Difference large{.value = 2.0, .interval = {}, .p = 0.03, .adjusted = {}};
  adjust_together(std::array{&small, &none, &large});
  CHECK(*small.adjusted == 0.04);
  CHECK(*large.adjusted == 0.04);
  CHECK_FALSE(none.adjusted);
  CHECK(small.differs());
  CHECK_FALSE(none.differs());
}
