#include "base/rotation.hpp"
#include "listing/print_file.hpp"
#include "listing/print_flange_wear.hpp"
#include "results/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <utility>

/// The four sections of a printed step (outputs.md 3.3).
namespace adore::listing {
namespace {

/// Columns of a table as channels, one row per element.
struct ChannelColumn {
  std::string title;
  std::string_view id;
  int race = -1;  ///< of contact channels
  /// Instead of a channel's values: SI, of one element.
  std::function<double(std::size_t)> value = {};
};

void element_table(Report& report, const StepRecord& record, int interval,
                   const std::vector<ChannelColumn>& wanted) {
  std::vector<Report::Column> columns;
  for (const ChannelColumn& column : wanted)
    columns.push_back({column.title, channels()[channel_index(column.id)].unit});
  std::vector<Report::Row> rows;
  for (int j = 0; j < record.shape.elements; j += interval) {
    Report::Row row{std::to_string(j + 1), {}};
    for (const ChannelColumn& column : wanted)
      row.values.push_back(column.value ? column.value(static_cast<std::size_t>(j))
                                        : record[column.id][static_cast<std::size_t>(
                                              column.race < 0 ? j : 2 * j + column.race)]);
    rows.push_back(std::move(row));
  }
  report.table("element", columns, rows);
}

/// Why there are no films and temperatures of contacts.
std::string_view no_films(RaceFrictionModel friction) {
  switch (friction) {
    case RaceFrictionModel::Curve:
      return "hypothetical traction";
    case RaceFrictionModel::OfUser:
      return "user routine ADRX7";
    case RaceFrictionModel::None:
    case RaceFrictionModel::Film:
      break;
  }
  return "no race friction";
}

/// Load distribution along roller 1 (page 1a).
void slices_of_first(Report& report, const scene::Snapshot& snapshot) {
  const auto& races = snapshot.elements.front().race;
  report.heading("1a. Load and pressure along roller 1, slice by slice from -x to +x");
  std::vector<Report::Row> rows;
  for (std::size_t k = 0; k < races[0].slice_load.size(); ++k)
    rows.push_back({std::to_string(k + 1),
                    {races[0].slice_load[k], races[0].slice_pressure[k], races[1].slice_load[k],
                     races[1].slice_pressure[k]}});
  report.table("slice",
               {{"load outer", &unit::kForce},
                {"pres outer", &unit::kPressure},
                {"load inner", &unit::kForce},
                {"pres inner", &unit::kPressure}},
               rows);
}

/// At time zero there is no time to average over.
void mean(Report& report, std::string_view label, double value, const UnitPair& unit, double time) {
  if (time > 0.0)
    report.item(label, value, unit);
  else
    report.item(label, "not computed at time zero");
}

void wear(Report& report, const scene::Snapshot& snapshot, std::string_view label, double rate) {
  if (snapshot.power.integrated)
    mean(report, label, rate, unit::kVolumeFlow, snapshot.time);
  else
    report.item(label, "not computed (wear integrals are off)");
}

/// Races, and what of it their flanges have.
void race_wear(Report& report, const scene::Snapshot& snapshot, const StepRecord& record,
               std::string_view outer, std::string_view inner) {
  for (const std::size_t j : {0U, 1U}) {
    wear(report, snapshot, j == 0 ? outer : inner, record["race.wear_rate"][j]);
    const auto& flanges = snapshot.elements.front().flange[j];
    if (flanges[0].present || flanges[1].present)
      wear(report, snapshot, "    flange part", record["race.flange_wear_rate"][j]);
  }
}

/// Roller ends at the flanges (page 1b); nothing without a flange.
void flanges(Report& report, const scene::Snapshot& snapshot, int interval) {
  for (std::size_t race = 0; race < 2; ++race)
    for (std::size_t side = 0; side < 2; ++side) {
      if (!snapshot.elements.front().flange[race][side].present) continue;
      report.heading(
          fmt::format("1b. Roller ends at the {} race flange, {}x side (gap: negative in contact)",
                      race == 0 ? "outer" : "inner", side == 0 ? "-" : "+"));
      std::vector<Report::Row> rows;
      for (std::size_t j = 0; j < snapshot.elements.size();
           j += static_cast<std::size_t>(interval)) {
        const scene::FlangeContactSnapshot& c = snapshot.elements[j].flange[race][side];
        rows.push_back(
            {std::to_string(j + 1),
             {c.force, std::isfinite(c.gap) ? c.gap : 0.0, c.height, c.slip, c.heat, c.load_slip}});
      }
      report.table("element",
                   {{"force", &unit::kForce},
                    {"gap", &unit::kLength},
                    {"height", &unit::kLength},
                    {"slip", &unit::kSpeed},
                    {"heat", &unit::kPower},
                    {"QV", &unit::kPower}},
                   rows);
    }
}

/// Heat of each element at each of its contacts; the parts of the power loss that elements have.
void heat_of_elements(Report& report, const StepRecord& record, int interval, bool rollers,
                      bool cage) {
  report.heading(
      "Heat of each element: friction, rolling resistance and damping at the races (1 outer, 2 "
      "inner), flanges, cage pocket");
  std::vector<ChannelColumn> columns;
  for (int race = 0; race < 2; ++race)
    for (const auto& [title, id] :
         {std::pair{"friction", "contact.heat"}, std::pair{"rolling", "contact.rolling_heat"},
          std::pair{"damping", "contact.damping_heat"}})
      columns.push_back({fmt::format("{} {}", title, race + 1), id, race});
  if (record.shape.split)
    columns.insert(columns.end(), {{"second 1", "second_contact.heat", 0},
                                   {"second 2", "second_contact.heat", 1}});
  const auto flanges = [&record](std::string_view id) {
    return [&record, id](std::size_t j) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 4; ++k) sum += record[id][4 * j + k];
      return sum;
    };
  };
  if (rollers) {
    columns.push_back({"flanges", "contact.heat", 0, flanges("flange.heat")});
    columns.push_back({"flange damp", "contact.heat", 0, flanges("flange.damping_heat")});
  }
  if (cage) columns.push_back({"pocket", "element.pocket_heat"});
  element_table(report, record, interval, columns);
}

void elements(Report& report, const scene::Snapshot& snapshot, const StepRecord& record,
              const bearing::Bearing& bearing, RaceFrictionModel friction, int interval) {
  // Films that have collapsed or stand still are 0, and so is a rise without slip.
  const bool film = friction == RaceFrictionModel::Film;
  const auto& roughness =
      bearing.rollers() != nullptr ? bearing.rollers()->roughness : bearing.balls().roughness;
  const bool lambda = roughness[0] > 0.0 || roughness[1] > 0.0;
  const bool rollers = record.shape.rollers;
  report.heading(
      "1. Rolling element parameters: position, velocity, angular velocity (theta, phi in the "
      "azimuth frame)");
  element_table(report, record, interval,
                {{"axial", "element.axial_position"},
                 {"radial", "element.radial_position"},
                 {"orbital", "element.orbital_position"},
                 {"axial vel", "element.axial_velocity"},
                 {"radial vel", "element.radial_velocity"},
                 {"orbital vel", "element.orbital_velocity"},
                 {"ang vel", "element.angular_velocity"},
                 {"theta", "element.angular_velocity_theta"},
                 {"phi", "element.angular_velocity_phi"}});
  report.heading(
      "Angular position of the principal x axis, and thermal state of the contacts (QV: integral "
      "of pressure times slip speed)");
  std::vector<ChannelColumn> thermal{{"theta", "element.theta"},
                                     {"phi", "element.phi"},
                                     {"rotation", "element.rotation"},
                                     {"QV outer", "contact.load_slip", 0},
                                     {"QV inner", "contact.load_slip", 1}};
  if (film)
    thermal.insert(thermal.end(), {{"rise outer", "contact.temperature_rise", 0},
                                   {"rise inner", "contact.temperature_rise", 1},
                                   {"temp outer", "contact.temperature", 0},
                                   {"temp inner", "contact.temperature", 1}});
  element_table(report, record, interval, thermal);
  if (!film)
    report.item(fmt::format("Contact temperature and its rise above the race temperature ({})",
                            no_films(friction)),
                "not computed");
  if (film) {
    report.heading(
        "Minimum film thickness of the contacts, and lambda (minimum film thickness divided by the "
        "composite roughness)");
    std::vector<ChannelColumn> films;
    for (int race = 0; race < 2; ++race) {
      films.push_back({race == 0 ? "least outer" : "least inner", "contact.least_film", race});
      if (lambda) films.push_back({"lambda", "contact.film_parameter", race});
    }
    element_table(report, record, interval, films);
    if (!lambda) report.item("Lambda (no roughness given)", "not computed");
  }
  if (!film) report.item(fmt::format("Film thickness ({})", no_films(friction)), "not computed");
  for (int race = 0; race < 2; ++race) {
    const char* name = race == 0 ? "outer" : "inner";
    report.heading(
        rollers
            ? fmt::format("Contacts with the {} race (a: half the contact length; b, pressure and "
                          "place: those of the slice with the largest pressure)",
                          name)
            : fmt::format(
                  "Contacts with the {} race (a across, b along the rolling direction; edge: {})",
                  name,
                  race == 0 ? "depth s below the shoulder"
                            : "distance t from the middle plane of the groove"));
    std::vector<ChannelColumn> columns{{"load", "contact.load", race},
                                       {"angle", "contact.angle", race},
                                       {"a", "contact.half_major", race},
                                       {"b", "contact.half_minor", race},
                                       {"pressure", "contact.pressure", race}};
    if (film) columns.push_back({"film", "contact.film", race});
    columns.insert(columns.end(), {{"slip", "contact.slip", race},
                                   {"spin/roll", "contact.spin_to_roll", race},
                                   {"heat", "contact.heat", race},
                                   {rollers ? "place" : "edge",
                                    rollers ? "contact.peak_position" : "contact.edge", race}});
    if (race == 1 && !rollers)  // N94: the channel holds s of both races
      columns.back().value = [&](std::size_t j) {
        return snapshot.elements[j].race[1].centre_chord;
      };
    element_table(report, record, interval, columns);
    if (!record.shape.split || !(bearing.balls().shim[static_cast<std::size_t>(race)] > 0.0))
      continue;
    report.heading(
        fmt::format("Contacts with the other (less loaded) half of the split {} race", name));
    element_table(report, record, interval,
                  {{"load", "second_contact.load", race},
                   {"angle", "second_contact.angle", race},
                   {"a", "second_contact.half_major", race},
                   {"b", "second_contact.half_minor", race},
                   {"pressure", "second_contact.pressure", race},
                   {"slip", "second_contact.slip", race},
                   {"heat", "second_contact.heat", race}});
  }
  heat_of_elements(report, record, interval, rollers, record.shape.cages > 0);
  if (rollers) {
    slices_of_first(report, snapshot);
    flanges(report, snapshot, interval);
    print_flange_wear(report, snapshot, bearing);
  }
  if (record.shape.pairs > 0) {
    report.heading("Contacts between neighboring elements (gap: negative in contact)");
    std::vector<Report::Row> rows;
    for (int j = 0; j < record.shape.pairs; j += interval) {
      const auto at = static_cast<std::size_t>(j);
      rows.push_back({fmt::format("{} and {}", j + 1, (j + 1) % record.shape.elements + 1),
                      {record["neighbour.force"][at], record["neighbour.gap"][at]}});
    }
    report.table("elements", {{"force", &unit::kForce}, {"gap", &unit::kLength}}, rows);
  }
  if (record.shape.cages == 0) return;
  report.heading(
      rollers ? "Cage pockets (gap: negative in contact; position: contact point along the surface)"
              : "Cage pockets (gap: negative in contact; theta = 0: the cage drives the ball, "
                "theta = 180 deg: the ball drives the cage)");
  std::vector<Report::Column> columns;
  const char* last = rollers ? "pocket.position" : "pocket.phi";
  for (const char* id : {"pocket.force", "pocket.gap", "pocket.theta", last})
    columns.push_back({std::string(id).substr(7), channels()[channel_index(id)].unit});
  std::vector<Report::Row> rows;
  const int surfaces = record.shape.pocket_surfaces;
  for (int j = 0; j < record.shape.elements; j += interval) {
    for (int s = 0; s < surfaces; ++s) {
      const auto at = static_cast<std::size_t>(j * surfaces + s);
      rows.push_back({surfaces == 1 ? std::to_string(j + 1) : fmt::format("{}.{}", j + 1, s + 1),
                      {record["pocket.force"][at], record["pocket.gap"][at],
                       record["pocket.theta"][at], record[last][at]}});
    }
  }
  for (int k = 0; k < record.shape.last_halves; ++k)
    for (int s = 0; s < surfaces; ++s) {
      const auto at = static_cast<std::size_t>((record.shape.elements + k) * surfaces + s);
      rows.push_back(
          {surfaces == 1 ? fmt::format("end {}", k + 1) : fmt::format("end {}.{}", k + 1, s + 1),
           {record["pocket.force"][at], record["pocket.gap"][at], record["pocket.theta"][at],
            record[last][at]}});
    }
  report.table("element", columns, rows);
  if (record.shape.last_halves > 0)
    report.text(
        "The cage is cut through pockets. In a cut pocket, the row of the element belongs to the "
        "half pocket at the start of a segment. The row \"end\" belongs to the half pocket at the "
        "end of a segment.");
}

/// By the model that run option sol7Life names, as if the loads of `life_step` lasted for ever.
void fatigue_life(Report& report, const scene::Snapshot& snapshot, long life_step) {
  const double life = snapshot.power.life_hours;
  const std::string label =
      life_step == snapshot.step
          ? std::string("Fatigue life at the current loads (sol7Life)")
          : fmt::format("Fatigue life at the loads of step {} (kLifeFreq; sol7Life)", life_step);
  if (std::isinf(life))
    report.item(label, "INFINITE");
  else if (life > 0.0)
    report.item(label, life, unit::kLife);
  else
    report.item("Fatigue life", "no life model is active");
}

void bodies(Report& report, const scene::Snapshot& snapshot, const StepRecord& record,
            long life_step) {
  report.heading(
      "2. Race and cage parameters: position and orientation (theta, phi of the body's axis in the "
      "base frame)");
  std::vector<Report::Row> places, speeds, orbits;
  // Angles are those of the plot files: turns of an orbit accumulate in both.
  const auto add = [&](const std::string& name, const scene::BodySnapshot& body, double theta,
                       double phi, double w_theta, double w_phi, double orbit_angle) {
    const OrbitMotion orbit = orbit_motion(body.position, body.velocity, body.acceleration);
    places.push_back({name,
                      {body.position.x(), body.position.y(), body.position.z(), theta, phi,
                       body.total_rotation}});
    speeds.push_back({name,
                      {body.velocity.x(), body.velocity.y(), body.velocity.z(), body.omega.norm(),
                       w_theta, w_phi}});
    orbits.push_back({name,
                      {orbit.r, orbit_angle, orbit.theta_dot, orbit.r_dot, orbit.r_ddot,
                       body.acceleration.x()}});
  };
  const auto angles = [&](const std::string& group, std::size_t at) {
    return std::array{record[group + ".theta"][at], record[group + ".phi"][at],
                      record[group + ".angular_velocity_theta"][at],
                      record[group + ".angular_velocity_phi"][at],
                      record[group + ".orbital_position"][at]};
  };
  const bool segments = snapshot.cages.size() > 1;
  for (std::size_t k = 0; k < snapshot.cages.size(); ++k) {
    const auto a = angles("cage", k);
    add(segments ? fmt::format("segment {}", k + 1) : std::string("cage"), snapshot.cages[k], a[0],
        a[1], a[2], a[3], a[4]);
  }
  for (std::size_t race = 0; race < 2; ++race) {
    const auto a = angles("race", race);
    add(race == 0 ? "outer race" : "inner race", snapshot.races[race], a[0], a[1], a[2], a[3],
        a[4]);
  }
  report.table("",
               {{"x", &unit::kLength},
                {"y", &unit::kLength},
                {"z", &unit::kLength},
                {"theta", &unit::kAngle},
                {"phi", &unit::kAngle},
                {"rotation", &unit::kAngle}},
               places, 12);
  report.blank();
  report.table("",
               {{"x vel", &unit::kSpeed},
                {"y vel", &unit::kSpeed},
                {"z vel", &unit::kSpeed},
                {"ang vel", &unit::kRotation},
                {"theta", &unit::kAngle},
                {"phi", &unit::kAngle}},
               speeds, 12);
  report.blank();
  report.table("",
               {{"orbit rad", &unit::kLength},
                {"orbit pos", &unit::kAngle},
                {"whirl vel", &unit::kRotation},
                {"radial vel", &unit::kSpeed},
                {"radial acc", &unit::kAcceleration},
                {"axial acc", &unit::kAcceleration}},
               orbits, 12);
  if (!snapshot.cages.empty() && !snapshot.cages.front().lands.empty()) {
    const auto& shown = snapshot.cages.front().lands;
    const bool films = std::any_of(shown.begin(), shown.end(), [](const scene::LandSnapshot& land) {
      return land.film_force > 0.0;
    });
    report.heading(films ? "Contact and film between cage and race (angle: azimuth in the cage "
                           "frame; attitude: angle from the smallest gap to the film force)"
                         : "Contact between cage and race (angle: azimuth in the cage frame)");
    std::vector<Report::Row> lands;
    for (std::size_t k = 0; k < snapshot.cages.size(); ++k) {
      int number = 0;
      for (const scene::LandSnapshot& land : snapshot.cages[k].lands) {
        lands.push_back({segments ? fmt::format("land {} of {}", ++number, k + 1)
                                  : fmt::format("land {}", ++number),
                         {land.force, land.gap, land.angle}});
        if (films)
          for (const double value : {land.film_force, land.attitude})
            lands.back().values.push_back(value);
        lands.back().values.push_back(land.heat);
      }
    }
    std::vector<Report::Column> columns{
        {"force", &unit::kForce}, {"gap", &unit::kLength}, {"angle", &unit::kAngle}};
    if (films) {
      columns.push_back({"film force", &unit::kForce});
      columns.push_back({"attitude", &unit::kAngle});
    }
    columns.push_back({"heat", &unit::kPower});
    report.table("", columns, lands, 12);
  }
  if (segments) {
    report.heading(
        "Gaps between cage segments (contact between them is not modeled; negative: overlap)");
    for (std::size_t k = 0; k < snapshot.cages.size(); ++k)
      report.item(fmt::format("Segments {} and {}", k + 1, (k + 1) % snapshot.cages.size() + 1),
                  snapshot.cages[k].to_next, unit::kLength);
  }
  report.heading("Wear rates, averaged since time zero, and life");
  wear(report, snapshot, "Rolling element 1", record["power.element1_wear_rate"][0]);
  race_wear(report, snapshot, record, "Outer race", "Inner race");
  if (!snapshot.cages.empty()) wear(report, snapshot, "Cage", record["power.cage_wear_rate"][0]);
  fatigue_life(report, snapshot, life_step);
}

void applied(Report& report, const scene::Snapshot& snapshot, const bearing::Bearing& bearing) {
  report.heading("3. Applied parameters: forces and moments on the races, about their centers");
  std::vector<Report::Row> rows;
  for (std::size_t race = 0; race < 2; ++race) {
    const scene::RaceSnapshot& body = snapshot.races[race];
    rows.push_back(
        {race == 0 ? "outer race" : "inner race",
         {body.applied_force.x(), body.applied_force.y(), body.applied_force.z(),
          body.applied_moment.x(), body.applied_moment.y(), body.applied_moment.z(),
          body.omega.dot(body_x_axis(body.orientation)), bearing.race_temperature[race]}});
  }
  report.table("",
               {{"Fx", &unit::kForce},
                {"Fy", &unit::kForce},
                {"Fz", &unit::kForce},
                {"Mx", &unit::kMoment},
                {"My", &unit::kMoment},
                {"Mz", &unit::kMoment},
                {"speed", &unit::kRotation},
                {"temperature", &unit::kTemperature}},
               rows, 12);
  const Vec3 shift = snapshot.races[1].position - snapshot.races[0].position;
  report.blank();
  for (int k = 0; k < 3; ++k)
    report.item(
        fmt::format("Displacement of the inner relative to the outer race along {}", "xyz"[k]),
        shift[k], unit::kLength);
  for (std::size_t race = 0; race < 2; ++race) {
    const auto tilt = tilt_of_axis(body_x_axis(snapshot.races[race].orientation));
    const char* name = race == 0 ? "outer" : "inner";
    report.item(fmt::format("Misalignment of the {} race about y", name), tilt[0], unit::kAngle);
    report.item(fmt::format("Misalignment of the {} race about z", name), tilt[1], unit::kAngle);
  }
  report.item("Rolling element temperature", bearing.element_temperature, unit::kTemperature);
  if (bearing.cage) report.item("Cage temperature", bearing.cage_temperature, unit::kTemperature);
  report.item(
      "Internal clearance, diametral",
      bearing.rollers() != nullptr ? bearing.rollers()->clearance : bearing.balls().clearance,
      unit::kLength);
  if (bearing.operating) {
    report.item("Diametral operating fit, outer race (positive: interference)",
                bearing.operating->fit[0].interference, unit::kLength);
    report.item("Diametral operating fit, inner race (positive: interference)",
                bearing.operating->fit[1].interference, unit::kLength);
  }
  if (!bearing.cage) return;
  report.item("Cage pocket clearance I, diametral", bearing.cage->pocket_clearance_1,
              unit::kLength);
  for (std::size_t i = 0; i < bearing.cage->lands.size(); ++i)
    report.item(fmt::format("Cage clearance at guide land {}, diametral", i + 1),
                bearing.cage->lands[i].clearance, unit::kLength);
}

void summary(Report& report, const scene::Snapshot& snapshot, const StepRecord& record,
             const Averages& averages, long life_step) {
  report.heading("4. Time step summary");
  report.item("Step", snapshot.step);
  report.item("Time", snapshot.time, unit::kTime);
  report.item("Last step size", snapshot.step_size, unit::kTime);
  report.item("Bearing rotation, inner minus outer race", snapshot.shaft_rotation,
              unit::kRevolution);
  report.item("Outer race rotation", snapshot.races[0].total_rotation, unit::kRevolution);
  report.item("Inner race rotation", snapshot.races[1].total_rotation, unit::kRevolution);
  for (std::size_t k = 0; k < snapshot.cages.size(); ++k)
    report.item(snapshot.cages.size() == 1 ? std::string("Cage rotation")
                                           : fmt::format("Cage segment {} rotation", k + 1),
                snapshot.cages[k].total_rotation, unit::kRevolution);
  const double time = averages.time;
  mean(report, "Orbital velocity ratio, average over elements and time", averages.orbital_ratio,
       unit::kPure, time);
  if (!snapshot.cages.empty()) {
    const char* over = snapshot.cages.size() > 1 ? "segments and time" : "time";
    mean(report, fmt::format("Cage angular velocity ratio, average over {}", over),
         averages.cage_ratio, unit::kPure, time);
    mean(report, fmt::format("Cage whirl ratio, average over {}", over), averages.whirl_ratio,
         unit::kPure, time);
  }
  report.item("Power loss", snapshot.power.total_loss, unit::kPower);
  report.item("Power loss, average over time", averages.power_loss, unit::kPower);
  for (const auto& item : snapshot.energy.items())
    if (item.term->kind == scene::LedgerKind::Heat)
      report.item(fmt::format("    current power loss: {}", item.place()), item.rate, unit::kPower);
  report.item("Fraction of the power loss from churning and drag", snapshot.power.churning_fraction,
              unit::kPure);
  wear(report, snapshot, "Average wear rate, rolling element 1",
       record["power.element1_wear_rate"][0]);
  race_wear(report, snapshot, record, "Average wear rate, outer race",
            "Average wear rate, inner race");
  if (!snapshot.cages.empty())
    wear(report, snapshot, "Average wear rate, cage", record["power.cage_wear_rate"][0]);
  fatigue_life(report, snapshot, life_step);
  if (snapshot.held_elements)
    report.item("Quasi-static elements, number", static_cast<long>(*snapshot.held_elements));
  report.item("Energy residual", snapshot.energy.residual(), unit::kEnergy);
}

constexpr std::size_t kBecause = 88;  ///< columns of a reason in the plan

/// Cuts off what of `text` goes into a line of `width` columns, at a blank where there is one.
std::string_view take_line(std::string_view& text, std::size_t width) {
  std::size_t end = text.size();
  if (end > width) {
    end = text.rfind(' ', width);
    if (end == std::string_view::npos || end == 0) end = width;
  }
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end);
  while (text.starts_with(' ')) text.remove_prefix(1);
  return line;
}

}  // namespace

void print_step(Report& report, const scene::Snapshot& snapshot, const StepRecord& record,
                const bearing::Bearing& bearing, const Averages& averages, int kPrtOpt,
                std::optional<long> life_step, RaceFrictionModel friction) {
  const PrintSections sections = select_print_sections(kPrtOpt);
  const long step = life_step.value_or(snapshot.step);
  report.new_page(fmt::format("STEP {}", snapshot.step));
  if (sections.element_interval > 0)
    elements(report, snapshot, record, bearing, friction, sections.element_interval);
  if (sections.bodies) bodies(report, snapshot, record, step);
  if (sections.applied) applied(report, snapshot, bearing);
  summary(report, snapshot, record, averages, step);
}

void print_ledgers(Report& report, const RunSummary& run, const scene::ScenePlan& plan,
                   const std::optional<RunLife>& life) {
  report.new_page("TIME STEP SUMMARY AND LEDGERS");
  report.item("Run ended", run.status);
  if (!run.message.empty()) report.text(run.message);
  if (!run.integrator.empty()) {
    report.item("Integrator", run.integrator);
    report.item("Tolerance", run.tolerance, unit::kPure);
    report.item("Steps", run.steps);
    report.item("Simulated time", run.time, unit::kTime);
    report.item("Bearing rotation", run.revolutions * 2.0 * std::numbers::pi, unit::kRevolution);
  }
  for (const auto& [name, value] : run.counters)
    report.item(fmt::format("Counter: {}", name), value);
  if (run.error_sum) {
    report.item("Sum of step error estimates (relative to variable scales)", *run.error_sum,
                unit::kPure);
    report.item("Largest step error estimate (relative to variable scale)", *run.error_largest,
                unit::kPure);
  } else if (!run.integrator.empty()) {
    report.item("Step error estimates",
                "not computed (not available with this integration method)");
  }

  if (!run.stability.empty()) report.text("Stability: " + run.stability);
  if (run.load) {
    report.heading(
        "Mean load on the elements over the stored steps, compared with the load of the deck");
    for (int k = 0; k < 3; ++k) {
      const char axis = "xyz"[k];
      if (run.load->given[static_cast<std::size_t>(k)])
        report.item(fmt::format("{}: specified", axis), run.load->asked[k], unit::kForce);
      report.item(fmt::format("{}: actual", axis), run.load->mean[k], unit::kForce);
    }
    report.item("relative difference from the specified load", run.load->departure(), unit::kPure);
  }

  report.heading("Arithmetic settings (they affect the last digits of the results)");
  for (const auto& [name, value] : arithmetic_items(run)) {
    if (name == "note")
      report.text(value);
    else
      report.item(name, value);
  }

  if (life) print_run_life(report, *life);

  report.heading("Model of this run: effects and unknowns");
  std::vector<std::vector<std::string>> rows;
  for (const scene::EffectEntry& effect : plan.effects)
    for (std::string_view rest = effect.because, first = effect.name;;) {
      rows.push_back({std::string(first),
                      first.empty() ? ""
                      : effect.on   ? "on"
                                    : "off",
                      std::string(take_line(rest, kBecause))});
      first = {};
      if (rest.empty()) break;
    }
  report.text_table({{"effect", 30}, {"", 4}, {"because", kBecause}}, rows);
  report.blank();
  rows.clear();
  for (const scene::BodyEntry& body : plan.bodies)
    rows.push_back({body.name, std::to_string(body.unknowns), body.degrees});
  report.text_table({{"body", 30}, {"unknowns", 9}, {"degrees of freedom", 83}}, rows);

  if (run.energy) {
    report.heading("Conservation of energy since the start");
    for (const auto& [name, value] : energy_items(*run.energy))
      report.item(name, value, unit::kEnergy);
    const double scale = energy_scale(*run.energy);
    if (scale > 0.0)
      report.item("energy residual divided by the exchanged energy", run.energy->residual() / scale,
                  unit::kPure);
    if (const double heat = results::heat_scale(*run.energy); heat > 0.0)
      report.item("energy residual divided by the heat", run.energy->residual() / heat,
                  unit::kPure);
    if (run.elastic && *run.elastic > 0.0)
      report.item("energy residual divided by the quasi-static elastic energy",
                  run.energy->residual() / *run.elastic, unit::kPure);
  }
  if (!run.momentum.empty()) {
    report.heading(
        "Conservation of momentum of elements and cage since the start (base frame, SI units)");
    for (const auto& [name, value] : run.momentum) report.item(name, value, unit::kPure);
  }
  if (run.max_quaternion_error)
    report.item("largest deviation of a quaternion norm from 1", *run.max_quaternion_error,
                unit::kPure);
  if (run.quadrature_error) {
    report.item("error of the contact integrals / traction force", run.quadrature_error->force,
                unit::kPure);
    if (run.quadrature_error->heat_of_finer > 0.0)
      report.item("error of the contact integrals / heat of the races",
                  run.quadrature_error->heat_of_rule / run.quadrature_error->heat_of_finer - 1.0,
                  unit::kPure);
  }

  if (!run.cost.empty()) {
    report.heading(run.measured_from > 0
                       ? fmt::format("Cost: computing time since the run was continued at step {}, "
                                     "by program part (measured; varies from run to run)",
                                     run.measured_from)
                       : "Cost: computing time by program part (measured; varies from run to run)");
    rows.clear();
    double total = 0.0;
    for (const scene::CostLedger::Row& row : run.cost) {
      total += row.seconds;
      rows.push_back({row.name, std::to_string(row.calls), fmt::format("{:.4f}", row.seconds),
                      run.seconds > 0.0 ? fmt::format("{:.1f} %", 100.0 * row.seconds / run.seconds)
                                        : std::string()});
    }
    rows.push_back(
        {"sum of these parts", "", fmt::format("{:.4f}", total),
         run.seconds > 0.0 ? fmt::format("{:.1f} %", 100.0 * total / run.seconds) : std::string()});
    rows.push_back({run.measured_from > 0 ? "since continuation" : "whole run", "",
                    fmt::format("{:.4f}", run.seconds), ""});
    report.text_table({{"part", 40}, {"calls", 14}, {"seconds", 12}, {"share", 8}}, rows);
  }
  if (!run.no_part.empty()) {
    report.heading("Deck values without effect in this run");
    std::vector<std::string> reasons;
    for (const deck::NoPart& value : run.no_part)
      if (std::find(reasons.begin(), reasons.end(), value.because) == reasons.end())
        reasons.push_back(value.because);
    for (const std::string& because : reasons) {
      std::string names;
      for (const deck::NoPart& value : run.no_part) {
        if (value.because != because) continue;
        names += fmt::format("{}{} = {}", names.empty() ? "" : ", ", value.variable, value.value);
      }
      report.text(fmt::format("{}: {}", because, names));
    }
  }
  if (const std::vector<Finding> shown = shown_findings(run.findings); !shown.empty()) {
    report.heading("Notes");
    for (const Finding& one : shown) report.text(one.text());
  }
}

}  // namespace adore::listing
