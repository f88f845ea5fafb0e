#include "deck/catalogue.hpp"
#include "life/iso281.hpp"

#include <catch2/catch.hpp>

#include <numbers>
#include <string>

/// The catalogue against figures that makers publish. Facts only; where each row is from:
/// - 72xx B and 73xx B: NSK, leaflet "New 40 degree angular contact ball bearings" (series BEA);
/// - 6205: trade page of KT Bearing ("What are the 6205 bearing dimensions", after ISO 15:2017);
/// - 60xx: bore, outside diameter and width as in a public table after JIS B 1520;
/// - 222xx: trade list of Extreme Bearing for 22205 K to 22220 K with adapter sleeves: outside
///   diameter, width, C, C0; the bore is that of the sleeve's shaft and 5 mm;
/// - 302xx: "Metric Series" table of a Japanese maker's catalogue, 15 to 35 mm bore (d, D, T, B, C,
///   ratings), and the product list of MBP for 30208.
/// The leaflet's series is said to carry more than the conventional one: 7201 B to 7203 B come out
/// at -4.2 to +0.2 % of its C, the larger ones at -7.5 to -12.6 %; the 6205 at +0.1 % of C, +0.4 %
/// of C0. The ratings are computed from the PROPOSED inside (ISO 281, ISO 76, b_m = 1.3), so they
/// judge ball sizes and numbers: an estimate that were a size off would miss C by 15 % and more.
/// Rollers (b_m = 1.15 spherical, 1.1 tapered): 222xx come out 5 to 18 % above C and 4 to 19 %
/// above C0, 302xx 10 to 23 % above C and 10 to 28 % above C0: the proposed rollers are somewhat
/// too many or too long. Cylindrical ratings: no table was at hand.
using namespace adore;

namespace {

struct Published {
  const char* designation;
  double bore, outside, width;  ///< [mm]
  double C = 0.0, C0 = 0.0;     ///< [N]; 0: not given there
  double cup_width = 0.0;       ///< [mm]; 0: as the width
};

constexpr Published kPublished[] = {
    {"6205", 25, 52, 15, 14000, 7800},
    {"6000", 10, 26, 8},
    {"6001", 12, 28, 8},
    {"6002", 15, 32, 9},
    {"6003", 17, 35, 10},
    {"6004", 20, 42, 12},
    {"6005", 25, 47, 12},
    {"6006", 30, 55, 13},
    {"6007", 35, 62, 14},
    {"16002", 15, 32, 8},
    {"16005", 25, 47, 8},
    {"16010", 50, 80, 10},
    {"23122", 110, 180, 56},
    {"23140", 200, 340, 112},
    {"7201 B", 12, 32, 10, 7750, 3750},
    {"7202 B", 15, 35, 11, 9300, 4800},
    {"7203 B", 17, 40, 12, 11000, 6100},
    {"7204 B", 20, 47, 14, 14800, 8150},
    {"7205 B", 25, 52, 15, 16700, 10200},
    {"7206 B", 30, 62, 16, 22600, 14300},
    {"7207 B", 35, 72, 17, 31000},
    {"7208 B", 40, 80, 18},
    {"7209 B", 45, 85, 19},
    {"7210 B", 50, 90, 20},
    {"7301 B", 12, 37, 12, 10500, 4950},
    {"7302 B", 15, 42, 13, 13600, 6900},
    {"7303 B", 17, 47, 14, 16000, 8300},
    {"7304 B", 20, 52, 15, 18900, 10500},
    {"7305 B", 25, 62, 17, 25900, 14900},
    {"7306 B", 30, 72, 19, 34500},
    {"7307 B", 35, 80, 21},
    {"7308 B", 40, 90, 23},
    {"7309 B", 45, 100, 25},
    {"22205", 25, 52, 18, 43000, 45000},
    {"22206", 30, 62, 20, 59000, 62000},
    {"22207", 35, 72, 23, 81000, 88000},
    {"22208", 40, 80, 23, 88000, 100000},
    {"22209", 45, 85, 23, 95000, 105000},
    {"22210", 50, 90, 23, 100000, 120000},
    {"22211", 55, 100, 25, 120000, 145000},
    {"22212", 60, 110, 28, 145000, 175000},
    {"22213", 65, 120, 31, 180000, 220000},
    {"22215", 75, 130, 31, 190000, 250000},
    {"22216", 80, 140, 33, 210000, 275000},
    {"22217", 85, 150, 36, 250000, 325000},
    {"22218", 90, 160, 40, 305000, 410000},
    {"22219", 95, 170, 43, 340000, 450000},
    {"22220", 100, 180, 46, 375000, 500000},
    {"30203", 17, 40, 12, 20400, 20200, 11},
    {"30204", 20, 47, 14, 29500, 30500, 12},
    {"30205", 25, 52, 15, 31500, 33700, 13},
    {"30206", 30, 62, 16, 43500, 48000, 14},
    {"30207", 35, 72, 17, 54500, 60500, 15},
    {"30208", 40, 80, 18, 0, 0, 16},
};

double proposed(const deck::ProposedInternalGeometry& inner, const std::string& variable) {
  for (const auto& [name, value] : inner.sets)
    if (name == variable) return std::stod(value);
  FAIL("nothing proposed for " << variable);
  return 0.0;
}

}  // namespace

TEST_CASE("catalogue: boundary dimensions are those of manufacturers", "[unit][catalogue]") {
  for (const Published& p : kPublished) {
    INFO(p.designation);
    const deck::CatalogueBearing bearing = deck::find_bearing(p.designation);
    CHECK(bearing.envelope.bore == Approx(1e-3 * p.bore).epsilon(1e-12));
    CHECK(bearing.envelope.outside == Approx(1e-3 * p.outside).epsilon(1e-12));
    CHECK(bearing.envelope.width == Approx(1e-3 * p.width).epsilon(1e-12));
    if (p.cup_width > 0.0)
      CHECK(bearing.envelope.cup_width == Approx(1e-3 * p.cup_width).epsilon(1e-12));
  }
}

TEST_CASE("catalogue: load ratings of the estimated geometry are near those of manufacturers",
          "[unit][catalogue]") {
  for (const Published& p : kPublished) {
    if (p.C == 0.0) continue;
    const deck::CatalogueBearing bearing = deck::find_bearing(p.designation);
    const deck::ProposedInternalGeometry inner =
        deck::propose_internal_geometry(bearing.type, bearing.envelope, bearing.angle);
    life::IsoGeometry iso;
    iso.element_diameter = 1e3 * proposed(inner, "bReDia");
    const bool tapered = bearing.type == deck::BearingType::Tapered,
               spherical = bearing.type == deck::BearingType::Spherical;
    iso.pitch_diameter = tapered ? 0.5 * (p.bore + p.outside) : 1e3 * proposed(inner, "pitchDia");
    if (tapered || spherical) {
      iso.type = life::IsoType::RadialRoller;
      iso.length = 1e3 * proposed(inner, "bReLen");
      iso.rows = spherical ? 2 : 1;
      iso.rating_factor = spherical ? 1.15 : 1.1;
    }
    iso.count = static_cast<int>(proposed(inner, "nRe"));
    iso.contact_angle = bearing.angle * std::numbers::pi / 180.0;
    const double C = life::iso_dynamic_rating(iso), C0 = life::iso_static_rating(iso).value();
    INFO(p.designation << ": C " << C << " N, published " << p.C << " N; C0 " << C0
                       << " N, published " << p.C0 << " N");
    const double tolerance = tapered                   ? 0.30
                             : spherical               ? 0.20
                             : p.designation[0] == '6' ? 0.01
                                                       : 0.15;
    CHECK(C == Approx(p.C).epsilon(tolerance));
    if (p.C0 > 0.0) CHECK(C0 == Approx(p.C0).epsilon(tolerance));
  }
}
