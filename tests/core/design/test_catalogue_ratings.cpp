#include "base/errors.hpp"
#include "deck/catalogue.hpp"
#include "deck/rated_bearings.hpp"
#include "design/catalogue_ratings.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace adore;

namespace {

/// Values printed in SKF, Rolling bearings, PUB BU/P1 17000 EN (2018), and of QJ in Schaeffler,
/// catalogue HR 1 (2006).
struct Printed {
  const char* designation;
  double bore, outside, width;  ///< [mm]
  double C, C0;                 ///< [kN]
  double limit;                 ///< of both ratings, relative
};
constexpr Printed kPrinted[] = {
    {"51105", 25, 42, 11, 18.2, 39, 0.15},    {"51205", 25, 47, 15, 26.5, 50, 0.15},
    {"81105", 25, 42, 11, 25, 69.5, 0.25},    {"3205", 25, 52, 20.6, 21.6, 14.3, 0.15},
    {"NA4905", 25, 42, 17, 24.2, 34.5, 0.15}, {"QJ205", 25, 52, 15, 25.5, 18.6, 0.20}};

}  // namespace

TEST_CASE("rated bearings: designation → printed size and estimated ratings", "[unit][catalogue]") {
  for (const Printed& p : kPrinted) {
    const auto bearing = deck::find_rated_bearing(p.designation);
    REQUIRE(bearing);
    const design::CatalogueRatings r = design::catalogue_ratings(*bearing);
    INFO(p.designation << ": C " << r.C << " N, C0 " << r.C0 << " N");
    CHECK(bearing->envelope.bore == Approx(1e-3 * p.bore));
    CHECK(bearing->envelope.outside == Approx(1e-3 * p.outside));
    CHECK(bearing->envelope.width == Approx(1e-3 * p.width));
    CHECK(r.C == Approx(1e3 * p.C).epsilon(p.limit));
    CHECK(r.C0 == Approx(1e3 * p.C0).epsilon(p.limit));
    CHECK(design::describe_ratings(*bearing).back().find("cannot be simulated") !=
          std::string::npos);
  }
}

TEST_CASE("rated bearings: blanks and suffixes → accepted; other series → not found",
          "[unit][catalogue]") {
  CHECK(deck::find_rated_bearing("QJ 205 MPA"));
  CHECK(deck::find_rated_bearing("NA 4905"));
  CHECK(deck::find_rated_bearing("51205-TN"));
  for (const char* other : {"6205", "32008", "22210", "23022", "33", "5120", "512051", ""})
    CHECK_FALSE(deck::find_rated_bearing(other));
}

TEST_CASE("rated bearings: no designation → also a deck; all sizes and ratings are positive",
          "[unit][catalogue]") {
  const std::vector<deck::RatedBearing> all = deck::rated_bearings();
  CHECK(all.size() > 170);
  for (const deck::RatedBearing& one : all) {
    INFO(one.designation);
    const design::CatalogueRatings r = design::catalogue_ratings(one);
    CHECK(r.C > 0.0);
    CHECK(r.C0 > 0.0);
    CHECK(one.envelope.outside > one.envelope.bore);
    CHECK_FALSE(one.source.empty());
    CHECK_THROWS_AS(deck::find_bearing(one.designation), InputError);
  }
}
