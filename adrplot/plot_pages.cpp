#include "adrplot/plot_pages.hpp"

#include "base/errors.hpp"
#include "results/channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace adore::adrplot {
namespace {

using results::SolHeader;
using results::SolKind;

constexpr int kBall = 1;

PanelSpec single(std::string title, std::string column, bool wraps = false) {
  return {std::move(title), {{"", std::move(column)}}, wraps};
}

PanelSpec both_races(std::string title, const std::string& channel) {
  return {std::move(title),
          {{"outer race", channel + ".outer"}, {"inner race", channel + ".inner"}},
          false};
}

PanelSpec flange_pair(std::string title, const std::string& channel) {
  return {std::move(title),
          {{"flange at −x", channel + ".1"}, {"flange at +x", channel + ".2"}},
          false};
}

PageSpec history(std::string title, std::vector<PanelSpec> panels, std::string note = "") {
  return {std::move(title), PageKind::History, std::move(panels), std::move(note)};
}

/// Accelerations, velocities and positions have the same three directions.
PageSpec motion(std::string title, const std::string& body, const std::string& quantity) {
  const bool position = quantity == "position";
  return history(std::move(title), {single("Orbital", body + ".orbital_" + quantity, position),
                                    single("Radial", body + ".radial_" + quantity),
                                    single("Axial", body + ".axial_" + quantity)});
}

PageSpec orientation(const std::string& body) {
  return history("Angular orientation",
                 {single("Theta", body + ".theta", true), single("Phi", body + ".phi", true),
                  single("Rotation", body + ".rotation", true)});
}

PageSpec angular_velocity(const std::string& size_title, const std::string& body,
                          const std::string& size) {
  return history("Angular velocity", {single(size_title, body + "." + size),
                                      single("Theta", body + ".angular_velocity_theta", true),
                                      single("Phi", body + ".angular_velocity_phi", true)});
}

PageSpec coordinates(std::string title, PageKind kind, const std::string& prefix,
                     const std::string& suffix = "") {
  return {std::move(title),
          kind,
          {single("X", prefix + "x" + suffix), single("Y", prefix + "y" + suffix),
           single("Z", prefix + "z" + suffix)},
          ""};
}

/// Columns of the file, by id.
class Columns {
 public:
  explicit Columns(const SolHeader& header) {
    for (const results::SolColumn& column : results::sol_columns(header)) ids_.insert(column.id);
  }
  [[nodiscard]] bool has(const std::string& id) const { return ids_.contains(id); }

 private:
  std::set<std::string> ids_;
};

std::vector<PageSpec> power_pages(const SolHeader& header) {
  const Columns columns(header);
  std::vector<PageSpec> pages{
      history("Overall power loss and life", {single("Power loss", "power.loss"),
                                              single("Churning share", "power.churning_fraction"),
                                              single("Fatigue life", "power.life")}),
      history("Applied moments", {both_races("X component", "race.applied_moment_x"),
                                  both_races("Y component", "race.applied_moment_y"),
                                  both_races("Z component", "race.applied_moment_z")}),
      history("Time-averaged wear rates",
              {single("Rolling element 1", "power.element1_wear_rate"),
               both_races("Races", "race.wear_rate"), single("Cage", "power.cage_wear_rate")})};
  const bool thermal = columns.has("thermal.inner_heat");
  const auto add_bulk = [&](const char* note) {
    if (columns.has("power.cage_temperature"))
      pages.push_back(history(
          "Bulk temperatures",
          {single("Rolling elements", "power.element_temperature"),
           both_races("Races", "race.temperature"), single("Cage", "power.cage_temperature")},
          note));
  };
  if (!thermal) {
    add_bulk(
        "This file does not contain temperatures of coolant, bore and housing, or heat flows.");
    return pages;
  }
  pages.push_back(history(
      "Bearing temperatures",
      {PanelSpec{"Coolant",
                 {{"inlet", "thermal.coolant_inlet"}, {"exit", "thermal.coolant_exit"}},
                 false},
       PanelSpec{"Bearing",
                 {{"outside diameter", "thermal.outside_diameter"}, {"bore", "thermal.bore"}},
                 false},
       single("Housing outside diameter", "thermal.housing")}));
  pages.push_back(history(
      "Average heat distribution in a thermal step",
      {single("Total heat", "thermal.total_heat"), single("To the coolant", "thermal.coolant_heat"),
       PanelSpec{"To the races",
                 {{"outer race", "thermal.outer_heat"}, {"inner race", "thermal.inner_heat"}},
                 false}}));
  add_bulk("");  // behind the manual's pages
  return pages;
}

std::vector<PageSpec> element_pages(const SolHeader& header) {
  const bool ball = header.bearing_type == kBall;
  const Columns columns(header);
  const std::string missing = "is not stored in this file.";

  std::vector<PageSpec> pages{motion("Accelerations", "element", "acceleration"),
                              motion("Velocity", "element", "velocity"),
                              motion("Position of the mass center", "element", "position"),
                              orientation("element"),
                              angular_velocity("Magnitude", "element", "angular_velocity"),
                              history("Race interactions 1: load and angle",
                                      {both_races("Contact load", "contact.load"),
                                       both_races("Contact angle", "contact.angle"),
                                       both_races("Spin/roll", "contact.spin_to_roll")})};
  PageSpec slip =
      history("Race interactions 2: slip and film", {both_races("Slip velocity", "contact.slip")});
  if (columns.has("contact.load_slip.inner"))
    slip.panels.push_back(both_races("Load × slip", "contact.load_slip"));
  else
    slip.note = "The integral of load times slip " + missing;
  slip.panels.push_back(both_races("Lubricant film", "contact.film"));
  if (!ball) {
    slip.note += slip.note.empty() ? "" : " ";
    slip.note += "Slip velocity: largest value of all slices (jumps when another slice has it).";
  }
  pages.push_back(std::move(slip));

  PageSpec heat = history("Race interactions 3: heat and temperature",
                          {both_races("Heat generation", "contact.heat")});
  if (columns.has("contact.temperature.inner")) {
    heat.panels.push_back(both_races("Contact temp. rise", "contact.temperature_rise"));
    heat.panels.push_back(both_races("Race contact temp.", "contact.temperature"));
  } else {
    heat.note = "The contact temperature " + missing;
  }
  pages.push_back(std::move(heat));

  const auto flanges = [&](const std::string& title, const std::string& race) {
    pages.push_back(history(title, {flange_pair("Normal load", "flange.force." + race),
                                    flange_pair("Gap", "flange.gap." + race),
                                    flange_pair("Heat generation", "flange.heat." + race)}));
  };
  if (!ball && header.outer_flange) flanges("Outer race flange interactions", "outer");
  if (!ball && header.inner_flange) flanges("Inner race flange interactions", "inner");
  if (columns.has("second_contact.load.inner")) {  // behind the manual's pages
    const std::string note = "0: no contact on this half, or the race is not split.";
    const auto panel = [](const char* title, const std::string& quantity) {
      return both_races(title, "second_contact." + quantity);
    };
    pages.push_back(history("Less loaded half of a split race: load and angle",
                            {panel("Contact load", "load"), panel("Contact angle", "angle"),
                             panel("Spin/roll", "spin_to_roll")},
                            note));
    pages.push_back(history("Less loaded half of a split race: slip and film",
                            {panel("Slip velocity", "slip"), panel("Load × slip", "load_slip"),
                             panel("Lubricant film", "film")},
                            note));
    pages.push_back(
        history("Less loaded half of a split race: heat and temperature",
                {panel("Heat generation", "heat"), panel("Contact temp. rise", "temperature_rise"),
                 panel("Race contact temp.", "temperature")},
                note));
  }
  if (columns.has("element.pocket_heat"))
    pages.push_back(history("Heat other than contact friction",
                            {both_races("Rolling resistance", "contact.rolling_heat"),
                             both_races("Contact damping", "contact.damping_heat"),
                             single("Cage pocket", "element.pocket_heat")}));
  return pages;
}

/// Contact angle of a pocket surface, or contact position on it; `where`: e.g. ".7.1".
PanelSpec pocket_contact(const SolHeader& header, const std::string& where,
                         const std::string& surface) {
  constexpr int kSpherical = 1, kCylindricalRollerPocket = -1;
  if (header.bearing_type != kBall && header.pocket_type != kCylindricalRollerPocket)
    return {"Contact position", {{surface, "pocket.position" + where}}, false};
  PanelSpec panel{"Contact angle", {{surface, "pocket.theta" + where}}, true};
  const std::string blank = surface.empty() ? "" : " ";
  if (header.bearing_type == kBall && header.pocket_type == kSpherical)
    panel.curves = {{surface + blank + "theta", "pocket.theta" + where},
                    {surface + blank + "phi", "pocket.phi" + where}};
  return panel;
}

void add_pocket_pages(std::vector<PageSpec>& pages, const SolHeader& header) {
  constexpr int kSurfacesPerPage = 2;
  const int surfaces = std::max(1, header.pocket_surfaces);
  const Columns columns(header);
  const auto place = [](int pocket, int surface) {
    return "." + std::to_string(pocket) + "." + std::to_string(surface);
  };
  // The count decides: a segment cut through a pocket has half a pocket more than in the header.
  for (int pocket = 1; columns.has("pocket.phi" + place(pocket, surfaces)); ++pocket) {
    for (int begin = 1; begin <= surfaces; begin += kSurfacesPerPage) {
      const int end = std::min(begin + kSurfacesPerPage - 1, surfaces);
      std::string title = "Pocket " + std::to_string(pocket) + " interaction";
      if (surfaces > kSurfacesPerPage)
        title += end == begin
                     ? ": guide surface " + std::to_string(end)
                     : ": guide surfaces " + std::to_string(begin) + " and " + std::to_string(end);
      PanelSpec force{"Normal force", {}, false}, gap{"Gap", {}, false}, contact;
      for (int surface = begin; surface <= end; ++surface) {
        const std::string where = place(pocket, surface);
        const std::string name = surfaces > 1 ? "surface " + std::to_string(surface) : "";
        force.curves.push_back({name, "pocket.force" + where});
        gap.curves.push_back({name, "pocket.gap" + where});
        PanelSpec one = pocket_contact(header, where, name);
        if (surface == begin)
          contact = std::move(one);
        else
          contact.curves.insert(contact.curves.end(), one.curves.begin(), one.curves.end());
      }
      const bool paired = header.bearing_type != kBall && surfaces % 2 == 0;
      pages.push_back(history(title, {force, gap, contact},
                              paired
                                  ? fmt::format("For positive cage rotation, surface {} is behind "
                                                "the roller and surface {} in front of it.",
                                                begin, end)
                                  : ""));
    }
  }
}

std::vector<PageSpec> cage_pages(const SolHeader& header) {
  const auto land = [](const std::string& title, const std::string& name) {
    return history(title, {single("Normal force", name + "_force"), single("Gap", name + "_gap"),
                           single("Contact angle", name + "_angle", true)});
  };
  std::vector<PageSpec> pages{
      history("Mass center velocities",
              {single("Whirl ratio", "cage.whirl_ratio"), single("Radial", "cage.radial_velocity"),
               single("Axial", "cage.axial_velocity")}),
      land("Cage to race interaction, land 1", "cage.land1"),
      land("Cage to race interaction, land 2", "cage.land2"),
      motion("Mass center acceleration", "cage", "acceleration"),
      coordinates("Mass center whirl orbit", PageKind::Orbit, "cage.", "_over_clearance"),
      motion("Position of the mass center", "cage", "position"),
      orientation("cage"),
      angular_velocity("Omega ratio", "cage", "speed_ratio")};
  add_pocket_pages(pages, header);
  pages.push_back(coordinates("Frequency spectrum of the mass center", PageKind::Spectrum, "cage.",
                              "_over_clearance"));
  return pages;
}

std::vector<PageSpec> race_pages() {
  const auto components = [](const std::string& title, const std::string& channel) {
    return history(title,
                   {single("X component", channel + "_x"), single("Y component", channel + "_y"),
                    single("Z component", channel + "_z")});
  };
  return {history("Mass center velocities",
                  {single("Orbital", "race.whirl_speed"), single("Radial", "race.radial_velocity"),
                   single("Axial", "race.axial_velocity")}),
          components("Applied forces", "race.applied_force"),
          components("Applied moments", "race.applied_moment"),
          motion("Mass center acceleration", "race", "acceleration"),
          coordinates("Mass center whirl orbit", PageKind::Orbit, "race."),
          history("Position of the mass center",
                  {single("X", "race.x"), single("Y", "race.y"), single("Z", "race.z")},
                  "Positions are relative to the unloaded position."),
          orientation("race"),
          angular_velocity("Magnitude", "race", "angular_velocity"),
          coordinates("Frequency spectrum of the mass center", PageKind::Spectrum, "race.")};
}

}  // namespace

std::vector<PageSpec> plot_pages(SolKind kind, const SolHeader& header) {
  switch (kind) {
    case SolKind::Power:
      return power_pages(header);
    case SolKind::Element:
      return element_pages(header);
    case SolKind::Cage:
      return cage_pages(header);
    case SolKind::Race:
      return race_pages();
    case SolKind::Animation:
      break;
  }
  throw InputError("SOL8 is an animation file without plot pages; open it with agore");
}

std::string subject(SolKind kind, const SolHeader& header) {
  switch (kind) {
    case SolKind::Power:
      return "power and life";
    case SolKind::Element:
      return "rolling element " + std::to_string(header.index);
    case SolKind::Cage:
      return header.segments > 1 ? "cage segment " + std::to_string(header.index - header.elements)
                                 : "cage";
    case SolKind::Race:
      return header.index <= header.elements + header.segments + 1 ? "outer race" : "inner race";
    case SolKind::Animation:
      break;
  }
  return "animation";
}

}  // namespace adore::adrplot
