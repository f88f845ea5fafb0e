#include "base/spelling.hpp"

#include <catch2/catch.hpp>

using adore::edit_distance;

TEST_CASE("edit_distance(): inserted, missing, replaced or swapped letter → 1", "[unit][base]") {
  CHECK(edit_distance("plot", "PLOT") == 0);
  CHECK(edit_distance("", "plot") == 4);
  CHECK(edit_distance("plot", "") == 4);
  CHECK(edit_distance("plt", "plot") == 1);
  CHECK(edit_distance("ploot", "plot") == 1);
  CHECK(edit_distance("plat", "plot") == 1);
  CHECK(edit_distance("plto", "plot") == 1);
  CHECK(edit_distance("lpto", "plot") == 2);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("ca", "abc") == 3);  // no letter is changed twice
}
