#include "base/errors.hpp"
#include "results/channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

/// The classic files as lists of columns into the channel table (outputs.md 5.3-5.5, 6).
namespace adore::results {
namespace {

/// Rolling element file: values 1-15 per element, then outer/inner pairs.
constexpr std::string_view kElementFile[] = {"element.orbital_acceleration",
                                             "element.radial_acceleration",
                                             "element.axial_acceleration",
                                             "element.orbital_velocity",
                                             "element.radial_velocity",
                                             "element.axial_velocity",
                                             "element.orbital_position",
                                             "element.radial_position",
                                             "element.axial_position",
                                             "element.theta",
                                             "element.phi",
                                             "element.rotation",
                                             "element.angular_velocity",
                                             "element.angular_velocity_theta",
                                             "element.angular_velocity_phi",
                                             "contact.load",
                                             "contact.angle",
                                             "contact.spin_to_roll",
                                             "contact.slip",
                                             "contact.heat",
                                             "contact.film"};
/// Appended pairs (N52): 28-33 for balls, 40-45 for rollers.
constexpr std::string_view kElementExtension[] = {"contact.load_slip", "contact.temperature_rise",
                                                  "contact.temperature"};
/// Appended behind those, so that the heat of an element is complete: 34-38 for balls, 46-54 for
/// rollers, whose last four are of the flanges.
constexpr std::string_view kElementHeat[] = {"contact.rolling_heat", "contact.damping_heat"};
/// Appended for balls of a bearing with a split race (39-56): the quantities of 16-33 at the
/// contacts with the other halves, in the same order.
constexpr std::string_view kSecondContacts[] = {
    "second_contact.load",         "second_contact.angle",
    "second_contact.spin_to_roll", "second_contact.slip",
    "second_contact.heat",         "second_contact.film",
    "second_contact.load_slip",    "second_contact.temperature_rise",
    "second_contact.temperature"};
constexpr int kBallValues = 38, kRollerValues = 54;
constexpr int kSplitBallValues = kBallValues + 2 * static_cast<int>(std::size(kSecondContacts));
constexpr std::string_view kPocket[] = {"pocket.force", "pocket.gap", "pocket.theta", "pocket.phi"};
constexpr std::string_view kPocketPlace[] = {"pocket.force", "pocket.gap", "pocket.position",
                                             "pocket.phi"};
constexpr std::string_view kCageFile[] = {"cage.whirl_ratio",
                                          "cage.radial_velocity",
                                          "cage.axial_velocity",
                                          "cage.land1_force",
                                          "cage.land1_gap",
                                          "cage.land1_angle",
                                          "cage.land2_force",
                                          "cage.land2_gap",
                                          "cage.land2_angle",
                                          "cage.orbital_acceleration",
                                          "cage.radial_acceleration",
                                          "cage.axial_acceleration",
                                          "cage.x_over_clearance",
                                          "cage.y_over_clearance",
                                          "cage.z_over_clearance",
                                          "cage.orbital_position",
                                          "cage.radial_position",
                                          "cage.axial_position",
                                          "cage.theta",
                                          "cage.phi",
                                          "cage.rotation",
                                          "cage.speed_ratio",
                                          "cage.angular_velocity_theta",
                                          "cage.angular_velocity_phi"};
constexpr std::string_view kRaceFile[] = {"race.whirl_speed",
                                          "race.radial_velocity",
                                          "race.axial_velocity",
                                          "race.applied_force_x",
                                          "race.applied_force_y",
                                          "race.applied_force_z",
                                          "race.applied_moment_x",
                                          "race.applied_moment_y",
                                          "race.applied_moment_z",
                                          "race.orbital_acceleration",
                                          "race.radial_acceleration",
                                          "race.axial_acceleration",
                                          "race.x",
                                          "race.y",
                                          "race.z",
                                          "race.orbital_position",
                                          "race.radial_position",
                                          "race.axial_position",
                                          "race.theta",
                                          "race.phi",
                                          "race.rotation",
                                          "race.angular_velocity",
                                          "race.angular_velocity_theta",
                                          "race.angular_velocity_phi"};
constexpr std::string_view kPowerFile[] = {"power.loss",
                                           "power.churning_fraction",
                                           "power.life",
                                           "race.applied_moment_x",
                                           "race.applied_moment_y",
                                           "race.applied_moment_z",
                                           "power.element1_wear_rate",
                                           "race.wear_rate",
                                           "power.cage_wear_rate",
                                           "power.element_temperature",
                                           "race.temperature",
                                           "power.cage_temperature"};

constexpr std::string_view kFlanges[] = {"flange.force", "flange.gap", "flange.heat"};
/// SOL7 values 18-26 (N51): of the thermal analysis.
constexpr std::string_view kThermal[] = {
    "thermal.coolant_inlet", "thermal.coolant_exit", "thermal.outside_diameter",
    "thermal.bore",          "thermal.housing",      "thermal.total_heat",
    "thermal.coolant_heat",  "thermal.outer_heat",   "thermal.inner_heat"};

constexpr int kBall = 1;
constexpr int kRoundRollerPocket = -1;
constexpr std::string_view kRaceName[] = {"outer", "inner"};

class Columns {
 public:
  explicit Columns(std::size_t limit) : limit_(limit) {}
  [[nodiscard]] bool full() const { return columns_.size() >= limit_; }
  void add(std::string_view id, std::size_t at, std::string_view id_suffix = {},
           std::string_view label_suffix = {}) {
    const std::size_t index = channel_index(id);
    const Channel& channel = channels()[index];
    push({fmt::format("{}{}", id, id_suffix), fmt::format("{}{}", channel.label, label_suffix),
          channel.unit, static_cast<int>(index), at});
  }
  /// Outer then inner.
  void add_pair(std::string_view id, std::size_t first) {
    for (std::size_t race = 0; race < 2; ++race)
      add(id, first + race, fmt::format(".{}", kRaceName[race]),
          fmt::format(", {} race", kRaceName[race]));
  }
  void add_foreign(std::string id, std::string label, const UnitPair* unit) {
    push({std::move(id), std::move(label), unit, -1, 0});
  }
  /// Fills up to the limit with nameless values.
  std::vector<SolColumn> finish() && {
    while (!full())
      add_foreign(fmt::format("value{}", columns_.size() + 1),
                  fmt::format("value {}", columns_.size() + 1), &unit::kPure);
    return std::move(columns_);
  }

 private:
  void push(SolColumn column) {
    if (!full()) columns_.push_back(std::move(column));
  }
  std::size_t limit_;
  std::vector<SolColumn> columns_;
};

/// -x then +x side of one race.
void add_flange_pair(Columns& columns, std::string_view id, std::size_t element, std::size_t race) {
  for (std::size_t side = 0; side < 2; ++side)
    columns.add(id, 4 * element + 2 * race + side, fmt::format(".{}.{}", kRaceName[race], side + 1),
                fmt::format(", {} race, {} side", kRaceName[race], side == 0 ? "-x" : "+x"));
}

void add_element_columns(Columns& columns, const SolHeader& header) {
  const auto element = static_cast<std::size_t>(header.index - 1);
  for (std::string_view id : kElementFile) {
    if (channels()[channel_index(id)].per == Per::Contact)
      columns.add_pair(id, 2 * element);
    else
      columns.add(id, element);
  }
  if (header.bearing_type != kBall)
    for (std::size_t race = 0; race < 2; ++race)
      for (std::string_view id : kFlanges) add_flange_pair(columns, id, element, race);
  for (std::string_view id : kElementExtension) columns.add_pair(id, 2 * element);
  for (std::string_view id : kElementHeat) columns.add_pair(id, 2 * element);
  columns.add("element.pocket_heat", element);
  if (header.bearing_type != kBall)
    for (std::size_t race = 0; race < 2; ++race)
      add_flange_pair(columns, "flange.damping_heat", element, race);
  else if (header.value_count == kSplitBallValues)
    for (std::string_view id : kSecondContacts) columns.add_pair(id, 2 * element);
}

void add_cage_columns(Columns& columns, const SolHeader& header) {
  const int segment = header.index - header.elements - 1;
  for (std::string_view id : kCageFile) columns.add(id, static_cast<std::size_t>(segment));
  const int surfaces = std::max(header.pocket_surfaces, 1);
  // Faces of roller pockets store the axial position of the contact, round pockets its angle.
  const bool place = header.bearing_type != kBall && header.pocket_type != kRoundRollerPocket;
  // The count decides: a segment whose cut goes through a pocket carries half a pocket more than
  // the header says.
  for (int pocket = 1; !columns.full(); ++pocket) {
    for (int surface = 1; surface <= surfaces && !columns.full(); ++surface) {
      const int row = header.segments > 1 && pocket > header.per_segment
                          ? header.elements + segment
                          : (header.first_pocket + segment * header.per_segment + pocket - 1) %
                                std::max(header.elements, 1);
      const auto at = static_cast<std::size_t>(row * surfaces + surface - 1);
      const std::string where = surfaces == 1
                                    ? fmt::format(", pocket {}", pocket)
                                    : fmt::format(", pocket {} surface {}", pocket, surface);
      for (std::string_view id : place ? kPocketPlace : kPocket)
        columns.add(id, at, fmt::format(".{}.{}", pocket, surface), where);
    }
  }
}

void add_power_columns(Columns& columns) {
  for (std::string_view id : kPowerFile) {
    if (channels()[channel_index(id)].per == Per::Race)
      columns.add_pair(id, 0);
    else
      columns.add(id, 0);
  }
  for (const std::string_view id : kThermal) columns.add(id, 0);
}

}  // namespace

SolKind sol_kind_of(const SolHeader& header) {
  if (header.index == 0) return SolKind::Power;
  if (header.index <= header.elements) return SolKind::Element;
  return header.index <= header.elements + header.segments ? SolKind::Cage : SolKind::Race;
}

std::vector<SolColumn> sol_columns(const SolHeader& header) {
  Columns columns(static_cast<std::size_t>(std::max(header.value_count, 0)));
  switch (sol_kind_of(header)) {
    case SolKind::Element:
      add_element_columns(columns, header);
      break;
    case SolKind::Cage:
      add_cage_columns(columns, header);
      break;
    case SolKind::Race: {
      const auto race =
          static_cast<std::size_t>(header.index - header.elements - header.segments - 1);
      for (std::string_view id : kRaceFile) columns.add(id, race);
      break;
    }
    case SolKind::Power:
      add_power_columns(columns);
      break;
    case SolKind::Animation:
      break;
  }
  return std::move(columns).finish();
}

int sol_value_count(SolKind kind, const Shape& shape) {
  switch (kind) {
    case SolKind::Element:
      return shape.rollers ? kRollerValues : shape.split ? kSplitBallValues : kBallValues;
    case SolKind::Cage:
      return 24 + 4 * shape.pocket_surfaces *
                      (shape.elements / std::max(shape.cages, 1) + (shape.last_halves > 0 ? 1 : 0));
    case SolKind::Race:
      return 24;
    case SolKind::Power:
      return shape.thermal ? 26 : 17;
    case SolKind::Animation:
      return 11 * shape.elements + 22;
  }
  return 0;
}

std::array<const UnitPair*, 10> unit_slots(SolKind kind) {
  using namespace unit;
  if (kind == SolKind::Power)
    return {&kPower, &kLife,       &kMoment, &kVolumeFlow, &kTemperature,
            &kTime,  &kRevolution, nullptr,  nullptr,      nullptr};
  if (kind == SolKind::Animation)
    return {&kLength, &kRadian,   &kForce,       &kTime,  &kRevolution,
            &kSpeed,  &kRotation, &kTemperature, &kPower, nullptr};
  return {&kRotationRate, &kAcceleration, &kRotation,
          &kSpeed,        &kAngle,        &kLength,
          &kForce,        &kPower,        kind == SolKind::Race ? &kMoment : &kTemperature,
          nullptr};
}

std::string unit_of_column(const SolFile& file, const SolColumn& column) {
  if (column.unit == &unit::kPure) return {};
  const auto slots = unit_slots(file.kind);
  const auto slot = std::find(slots.begin(), slots.end(), column.unit);
  return slot == slots.end() ? std::string()
                             : file.header.units[static_cast<std::size_t>(slot - slots.begin())];
}

}  // namespace adore::results
