#include "bearing/bearing.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>

using namespace adore::bearing;

TEST_CASE("kPocType: converted to a cage and back → unchanged", "[unit][bearing]") {
  for (int code = 0; code <= 4; ++code) {
    Cage cage;
    cage.pocket = pocket_shape(code, false);
    CHECK(pocket_code(cage, false) == code);
    CHECK(pocket_surfaces(cage, false) == (code == 3 ? 4 : 1));
    CHECK(parse_pocket_shape(name_of(cage.pocket)) == cage.pocket);
  }
  for (int code = -1; code <= 3; ++code) {
    Cage cage;
    cage.pocket = pocket_shape(code, true);
    cage.pocket_faces.resize(static_cast<std::size_t>(std::max(code, 0)));
    CHECK(pocket_code(cage, true) == code);
    CHECK(pocket_surfaces(cage, true) == (code < 0 ? 1 : code == 0 ? 2 : 2 * code));
  }
}

TEST_CASE("pocket codes and names: invalid ones are distinguished", "[unit][bearing]") {
  for (const int code : {-2, -1, 5, 100})
    CHECK(pocket_shape(code, false) == PocketShape::Cylindrical);
  std::set<std::string_view> names;
  for (int code = 0; code <= 4; ++code) names.insert(name_of(pocket_shape(code, false)));
  CHECK(names.size() == 5);
  CHECK_FALSE(parse_pocket_shape("round").has_value());
  CHECK_FALSE(parse_pocket_shape("").has_value());
}
