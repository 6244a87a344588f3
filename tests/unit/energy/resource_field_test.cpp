// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <trophic/population/resource_field.hpp>

using namespace trophic;

TEST_CASE("resource field: places and cells -> row by row from the lower left corner, the nearest beyond the floor") {
  Arena arena;
  arena.half_side_m = 2.0;
  const ResourceField field{arena, 4};
  CHECK(field.cells() == 16);
  CHECK(field.cell_m() == 1.0);
  CHECK(field.cell_at(-1.9, -1.9) == 0);
  CHECK(field.cell_at(1.9, -1.9) == 3);
  CHECK(field.cell_at(-1.9, 1.9) == 12);
  CHECK(field.cell_at(99.0, 99.0) == 15);
  CHECK(field.cell_at(-99.0, 0.5) == 8);
  for (std::size_t cell = 0; cell < field.cells(); ++cell) CHECK(field.cell_at(field.centre(cell)) == cell);
}

TEST_CASE("resource field: no cells -> error that names the bound") {
  CHECK_THROWS_WITH_AS((ResourceField{Arena{}, 0}), "rules.resource: 0 cells in a row: must be >= 1 and <= 10000",
                       std::invalid_argument);
}

TEST_CASE("resource field: in an archive -> the same numbers, another size is an error") {
  ResourceField field{Arena{}, 3, 2};
  field.food_J(4) = 7.5;
  field.layer(1, 8) = -2.0;
  Archive written;
  written(field);
  ResourceField again{Arena{}, 3, 2};
  Archive read{written.bytes()};
  read(again);
  CHECK(again.food_J(4) == 7.5);
  CHECK(again.layer(1, 8) == -2.0);
  CHECK(again.total_J() == 7.5);
  ResourceField other{Arena{}, 4, 2};
  Archive wrong{written.bytes()};
  CHECK_THROWS_AS(wrong(other), std::invalid_argument);
}
