#include "listing/solution_tables.hpp"

#include "base/constants.hpp"
#include "contact/groove.hpp"
#include "listing/print_films.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::listing {
namespace {

using bearing::Bearing;

/// Angle at which the groove of a race ends at its shoulder, measured as contact angles are; NaN
/// when the deck gives no shoulder or the groove does not reach it.
double shoulder_angle(const Bearing& bearing, const contact::GrooveGeometry& groove,
                      std::size_t race) {
  const double shoulder = 0.5 * bearing.balls().shoulder_diameter[race];
  if (!(shoulder > 0.0)) return kNaN;
  const double height = (race == 0 ? 1.0 : -1.0) * (shoulder - groove.centre_radius[race]);
  const double cosine = height / groove.groove_radius[race];
  return std::abs(cosine) <= 1.0 ? std::acos(cosine) : kNaN;
}

}  // namespace

StaticTables static_tables(const statics::StaticSolution& solution, const Bearing& bearing,
                           UnitSystem units) {
  StaticTables out{bearing.run_id, "ball", units, {}};
  StaticTable& elements = out.tables.emplace_back(StaticTable{"elements", {}});
  const auto column = [&](auto&& value) {
    std::vector<double> values;
    for (const statics::StaticBall& ball : solution.balls) values.push_back(value(ball));
    return values;
  };
  elements.add("azimuth", unit::kAngle, column([](const auto& b) { return b.azimuth; }));
  const contact::GrooveGeometry groove = contact::groove_geometry(bearing.balls());
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string race = j == 0 ? "outer " : "inner ";
    // Half the angle that the contact ellipse takes up on the groove.
    const auto half = [&](const statics::StaticBall& b) {
      return std::asin(std::min(1.0, b.a[j] / groove.groove_radius[j]));
    };
    elements.add(race + "load", unit::kForce, column([&](const auto& b) { return b.Q[j]; }));
    elements.add(race + "contact angle", unit::kAngle,
                 column([&](const auto& b) { return b.alpha[j]; }));
    elements.add(race + "ellipse low", unit::kAngle,
                 column([&](const auto& b) { return b.alpha[j] - half(b); }));
    elements.add(race + "ellipse high", unit::kAngle,
                 column([&](const auto& b) { return b.alpha[j] + half(b); }));
    elements.add(race + "pressure", unit::kPressure,
                 column([&](const auto& b) { return b.Q[j] > 0.0 ? b.p_max[j] : 0.0; }));
    elements.add(race + "spin to roll", unit::kPure,
                 column([&](const auto& b) { return b.Q[j] > 0.0 ? b.spin_roll[j] : kNaN; }));
    if (bearing.balls().shim[j] > 0.0) {  // contact with the other half of a split race
      elements.add(race + "second load", unit::kForce,
                   column([&](const auto& b) { return b.second[j].Q; }));
      elements.add(race + "second contact angle", unit::kAngle, column([&](const auto& b) {
                     return b.second[j].Q > 0.0 ? b.second[j].alpha : kNaN;
                   }));
      elements.add(race + "second pressure", unit::kPressure,
                   column([&](const auto& b) { return b.second[j].p_max; }));
    }
    const double end = shoulder_angle(bearing, groove, j);
    if (std::isfinite(end))
      elements.add(race + "groove end", unit::kAngle,
                   column([&](const auto& b) { return b.alpha[j] < 0.0 ? -end : end; }));
  }
  if (solution.films) add_film_columns(elements, *solution.films);
  return out;
}

const char* type_name(bearing::Type type) {
  switch (type) {
    case bearing::Type::Ball:
      return "ball";
    case bearing::Type::Cylindrical:
      return "cylindrical roller";
    case bearing::Type::Spherical:
      return "spherical roller";
    case bearing::Type::Tapered:
      return "tapered roller";
    case bearing::Type::SphericalTapered:
      return "spherical tapered roller";
  }
  return "";
}

namespace {

/// The roller with the largest contact load; nullptr without rollers.
const statics::StaticRoller* heaviest(const statics::RollerSolution& solution) {
  const statics::StaticRoller* out = nullptr;
  double largest = -1.0;
  for (const statics::StaticRoller& roller : solution.rollers)
    for (const statics::RollerRaceContact& contact : roller.race)
      if (contact.load > largest) {
        largest = contact.load;
        out = &roller;
      }
  return out;
}

}  // namespace

StaticTables static_tables(const statics::RollerSolution& solution, const Bearing& bearing,
                           UnitSystem units) {
  StaticTables out{bearing.run_id, type_name(bearing.type), units, {}};
  StaticTable elements{"elements", {}};
  const auto add = [&](std::string name, const UnitPair& unit, auto&& value) {
    std::vector<double> values;
    for (const statics::StaticRoller& roller : solution.rollers) values.push_back(value(roller));
    elements.add(std::move(name), unit, std::move(values));
  };
  add("azimuth", unit::kAngle, [](const auto& r) { return r.azimuth; });
  add("tilt", unit::kAngle, [&](const auto& r) { return r.tilt + bearing.rollers()->axis_angle; });
  if (solution.friction.computed) add("skew", unit::kAngle, [](const auto& r) { return r.skew; });
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string race = j == 0 ? "outer " : "inner ";
    add(race + "load", unit::kForce, [&](const auto& r) { return r.race[j].load; });
    add(race + "moment", unit::kMoment, [&](const auto& r) { return r.race[j].moment; });
    add(race + "contact angle", unit::kAngle,
        [&](const auto& r) { return r.race[j].contact_angle; });
    add(race + "pressure", unit::kPressure, [&](const auto& r) { return r.race[j].peak_pressure; });
    for (std::size_t side = 0; side < 2; ++side)
      if (bearing.rollers()->flange[j][side])
        add(race + (side == 0 ? "flange -x load" : "flange +x load"), unit::kForce,
            [&](const auto& r) { return r.flange[j][side].load; });
  }
  if (solution.films) add_film_columns(elements, *solution.films);
  out.tables.push_back(std::move(elements));
  const statics::StaticRoller* roller = heaviest(solution);
  if (roller == nullptr || roller->race[0].slice_load.empty()) return out;
  StaticTable slices{"slices", {}};
  slices.add("position", unit::kLength, solution.slice_position);
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string race = j == 0 ? "outer " : "inner ";
    std::vector<double> per_length;
    for (const double load : roller->race[j].slice_load)
      per_length.push_back(load / solution.slice_width);
    slices.add(race + "pressure", unit::kPressure, roller->race[j].slice_pressure);
    slices.add(race + "load per length", unit::kStiffness, std::move(per_length));
  }
  out.tables.push_back(std::move(slices));
  return out;
}

StaticTable stiffness_over_speed(const std::vector<statics::StiffnessRow>& rows) {
  static constexpr std::array<const char*, 5> kLoads{"Fx", "Fy", "Fz", "My", "Mz"},
      kMotions{"x", "y", "z", "rot y", "rot z"};
  StaticTable out{"stiffness over speed", {}};
  const auto add = [&](std::string name, const UnitPair& unit, auto&& value) {
    std::vector<double> values;
    for (const statics::StiffnessRow& row : rows) values.push_back(value(row));
    out.add(std::move(name), unit, std::move(values));
  };
  const auto solved = [&](std::string name, const UnitPair& unit, auto&& value) {
    add(std::move(name), unit, [&](const statics::StiffnessRow& row) {
      return row.failure.empty() ? value(row.result) : kNaN;
    });
  };
  add("outer speed", unit::kRotation, [](const auto& row) { return row.speed[0]; });
  add("inner speed", unit::kRotation, [](const auto& row) { return row.speed[1]; });
  for (std::size_t k = 0; k < 5; ++k)
    solved(fmt::format("displacement {}", kMotions[k]), k < 3 ? unit::kLength : unit::kRadian,
           [&](const statics::RaceResult& r) { return r.displacement[k]; });
  solved("largest load", unit::kForce, [](const statics::RaceResult& r) { return r.max_load; });
  // If the caller knows the fits at each speed.
  if (std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.operating; })) {
    add("clearance", unit::kLength,
        [](const auto& row) { return row.operating ? row.operating->operating.clearance : kNaN; });
    add("free contact angle", unit::kAngle, [](const auto& row) {
      return row.operating && row.operating->locus[0] > 0.0 ? row.operating->operating.contact_angle
                                                            : kNaN;
    });
  }
  const bool differences = std::any_of(rows.begin(), rows.end(), [](const auto& row) {
    return row.result.stiffness_by_difference.has_value();
  });
  for (Eigen::Index i = 0; i < 5; ++i)
    for (Eigen::Index j = 0; j < 5; ++j) {
      const UnitPair& unit = i < 3 ? (j < 3 ? unit::kStiffness : unit::kCoupledStiffness)
                                   : (j < 3 ? unit::kForce : unit::kRotationalStiffness);
      const std::string name = fmt::format("{}/{}", kLoads[static_cast<std::size_t>(i)],
                                           kMotions[static_cast<std::size_t>(j)]);
      solved(name, unit, [&](const statics::RaceResult& r) { return r.stiffness(i, j); });
      if (differences)
        solved(name + " by difference", unit, [&](const statics::RaceResult& r) {
          return r.stiffness_by_difference ? (*r.stiffness_by_difference)(i, j) : kNaN;
        });
    }
  return out;
}

}  // namespace adore::listing
