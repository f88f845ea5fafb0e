#include "adrplot/plot_pages.hpp"

#include "base/errors.hpp"

#include <algorithm>

namespace adore::adrplot {
namespace {

using results::SolHeader;
using results::SolKind;

constexpr int kBall = 1;
constexpr int kPureNumber = 10;

/// Unit slots of element, cage and race files.
namespace slot {
constexpr int angular_acceleration = 1, acceleration = 2, angular_velocity = 3, velocity = 4,
              angle = 5, length = 6, force = 7, power = 8, temperature = 9, race_moment = 9;
}
/// Unit slots of the power file.
namespace power_slot {
constexpr int power = 1, life = 2, moment = 3, wear_rate = 4, temperature = 5;
}

PanelSpec single(std::string title, int unit_slot, int value, bool wraps = false) {
  return {title, unit_slot, {{"", value}}, wraps};
}

PanelSpec both_races(std::string title, int unit_slot, int outer) {
  return {std::move(title), unit_slot, {{"outer race", outer}, {"inner race", outer + 1}}, false};
}

PanelSpec flange_pair(std::string title, int unit_slot, int first) {
  return {
      std::move(title), unit_slot, {{"flange at −x", first}, {"flange at +x", first + 1}}, false};
}

PageSpec history(std::string title, std::vector<PanelSpec> panels, std::string note = "") {
  return {std::move(title), PageKind::History, std::move(panels), std::move(note)};
}

/// Accelerations and velocities share their three directions.
PageSpec motion(std::string title, int orbital_slot, int linear_slot, int first) {
  return history(std::move(title),
                 {single("Orbital", orbital_slot, first), single("Radial", linear_slot, first + 1),
                  single("Axial", linear_slot, first + 2)});
}

PageSpec position(int first) {
  return history("Position of the mass centre", {single("Orbital", slot::angle, first, true),
                                                 single("Radial", slot::length, first + 1),
                                                 single("Axial", slot::length, first + 2)});
}

PageSpec orientation(int first) {
  return history("Angular orientation", {single("Theta", slot::angle, first, true),
                                         single("Phi", slot::angle, first + 1, true),
                                         single("Rotation", slot::angle, first + 2, true)});
}

PageSpec angular_velocity(const std::string& size_title, int size_slot, int first) {
  return history("Angular velocity", {single(size_title, size_slot, first),
                                      single("Theta", slot::angle, first + 1, true),
                                      single("Phi", slot::angle, first + 2, true)});
}

PageSpec coordinates(std::string title, PageKind kind, int unit_slot, int first) {
  return {std::move(title),
          kind,
          {single("X", unit_slot, first), single("Y", unit_slot, first + 1),
           single("Z", unit_slot, first + 2)},
          ""};
}

std::vector<PageSpec> power_pages(const SolHeader& header) {
  constexpr int kListed = 17, kExtended = 26;
  std::vector<PageSpec> pages{
      history("Overall power loss and life",
              {single("Power loss", power_slot::power, 1), single("Churning share", kPureNumber, 2),
               single("Fatigue life", power_slot::life, 3)}),
      history("Applied moments", {both_races("X component", power_slot::moment, 4),
                                  both_races("Y component", power_slot::moment, 6),
                                  both_races("Z component", power_slot::moment, 8)}),
      history("Time-averaged wear rates", {single("Rolling element 1", power_slot::wear_rate, 10),
                                           both_races("Races", power_slot::wear_rate, 11),
                                           single("Cage", power_slot::wear_rate, 13)})};
  if (header.value_count < kExtended) {
    if (header.value_count >= kListed)
      pages.push_back(history("Bulk temperatures",
                              {single("Rolling elements", power_slot::temperature, 14),
                               both_races("Races", power_slot::temperature, 15),
                               single("Cage", power_slot::temperature, 17)},
                              "Coolant, bore and housing temperatures and the heat flows are not "
                              "stored in this file."));
    return pages;
  }
  pages.push_back(history(
      "Bearing temperatures",
      {PanelSpec{"Coolant", power_slot::temperature, {{"inlet", 18}, {"exit", 19}}, false},
       PanelSpec{
           "Bearing", power_slot::temperature, {{"outside diameter", 20}, {"bore", 21}}, false},
       single("Housing outside diameter", power_slot::temperature, 22)}));
  pages.push_back(history(
      "Average heat distribution in a thermal step",
      {single("Total heat", power_slot::power, 23), single("To the coolant", power_slot::power, 24),
       PanelSpec{
           "To the races", power_slot::power, {{"outer race", 25}, {"inner race", 26}}, false}}));
  return pages;
}

std::vector<PageSpec> element_pages(const SolHeader& header) {
  const bool ball = header.bearing_type == kBall;
  const int listed = ball ? 27 : 39;
  const bool extended = header.value_count >= listed + 6;
  const int load_slip = listed + 1, contact_rise = listed + 3, race_temperature = listed + 5;
  const std::string missing = "is not stored in this file.";

  std::vector<PageSpec> pages{
      motion("Accelerations", slot::angular_acceleration, slot::acceleration, 1),
      motion("Velocity", slot::angular_velocity, slot::velocity, 4),
      position(7),
      orientation(10),
      angular_velocity("Magnitude", slot::angular_velocity, 13),
      history("Race interactions 1: load and angle", {both_races("Contact load", slot::force, 16),
                                                      both_races("Contact angle", slot::angle, 18),
                                                      both_races("Spin/roll", kPureNumber, 20)})};
  PageSpec slip = history("Race interactions 2: slip and film",
                          {both_races("Slip velocity", slot::velocity, 22)});
  if (extended)
    slip.panels.push_back(both_races("Load × slip", slot::power, load_slip));
  else
    slip.note = "The integral of load times slip " + missing;
  slip.panels.push_back(both_races("Lubricant film", slot::length, 26));
  pages.push_back(std::move(slip));

  PageSpec heat = history("Race interactions 3: heat and temperature",
                          {both_races("Heat generation", slot::power, 24)});
  if (extended) {
    heat.panels.push_back(both_races("Contact temp. rise", slot::temperature, contact_rise));
    heat.panels.push_back(both_races("Race contact temp.", slot::temperature, race_temperature));
  } else {
    heat.note = "The contact temperature " + missing;
  }
  pages.push_back(std::move(heat));

  const auto flanges = [&](const std::string& title, int first) {
    pages.push_back(history(title, {flange_pair("Normal load", slot::force, first),
                                    flange_pair("Gap", slot::length, first + 2),
                                    flange_pair("Heat generation", slot::power, first + 4)}));
  };
  if (!ball && header.outer_flange) flanges("Outer race flange interactions", 28);
  if (!ball && header.inner_flange) flanges("Inner race flange interactions", 34);
  return pages;
}

/// Contact angle of a pocket surface, or the contact's position on it; `first` is the surface's
/// first value.
PanelSpec pocket_contact(const SolHeader& header, int first, const std::string& surface) {
  constexpr int kSpherical = 1, kCylindricalRollerPocket = -1;
  if (header.bearing_type != kBall && header.pocket_type != kCylindricalRollerPocket)
    return {"Contact position", slot::length, {{surface, first + 2}}, false};
  PanelSpec panel{"Contact angle", slot::angle, {{surface, first + 2}}, true};
  if (header.bearing_type == kBall && header.pocket_type == kSpherical)
    panel.curves = {{surface + (surface.empty() ? "" : " ") + "theta", first + 2},
                    {surface + (surface.empty() ? "" : " ") + "phi", first + 3}};
  return panel;
}

void add_pocket_pages(std::vector<PageSpec>& pages, const SolHeader& header) {
  constexpr int kCageValues = 24, kPerSurface = 4, kSurfacesPerPage = 2;
  const int surfaces = std::max(1, header.pocket_surfaces);
  // The count decides: a segment whose cut goes through a pocket carries half a pocket more than
  // the header says.
  const int pockets = (header.value_count - kCageValues) / (kPerSurface * surfaces);
  for (int pocket = 0; pocket < pockets; ++pocket) {
    for (int begin = 0; begin < surfaces; begin += kSurfacesPerPage) {
      const int end = std::min(begin + kSurfacesPerPage, surfaces);
      const bool many = surfaces > 1;
      std::string title = "Pocket " + std::to_string(pocket + 1) + " interaction";
      if (surfaces > kSurfacesPerPage)
        title += end - begin == 1 ? ": guide surface " + std::to_string(end)
                                  : ": guide surfaces " + std::to_string(begin + 1) + " and " +
                                        std::to_string(end);
      PanelSpec force{"Normal force", slot::force, {}, false}, gap{"Gap", slot::length, {}, false},
          contact;
      for (int surface = begin; surface < end; ++surface) {
        const int first = kCageValues + 1 + (pocket * surfaces + surface) * kPerSurface;
        const std::string name = many ? "surface " + std::to_string(surface + 1) : "";
        force.curves.push_back({name, first});
        gap.curves.push_back({name, first + 1});
        PanelSpec one = pocket_contact(header, first, name);
        if (surface == begin)
          contact = std::move(one);
        else
          contact.curves.insert(contact.curves.end(), one.curves.begin(), one.curves.end());
      }
      pages.push_back(history(title, {force, gap, contact}));
    }
  }
}

std::vector<PageSpec> cage_pages(const SolHeader& header) {
  const auto land = [](const std::string& title, int first) {
    return history(
        title, {single("Normal force", slot::force, first), single("Gap", slot::length, first + 1),
                single("Contact angle", slot::angle, first + 2, true)});
  };
  std::vector<PageSpec> pages{
      history("Mass centre velocities",
              {single("Whirl ratio", kPureNumber, 1), single("Radial", slot::velocity, 2),
               single("Axial", slot::velocity, 3)}),
      land("Cage to race interaction, land 1", 4),
      land("Cage to race interaction, land 2", 7),
      motion("Mass centre acceleration", slot::angular_acceleration, slot::acceleration, 10),
      coordinates("Mass centre whirl orbit", PageKind::Orbit, kPureNumber, 13),
      position(16),
      orientation(19),
      angular_velocity("Omega ratio", kPureNumber, 22)};
  add_pocket_pages(pages, header);
  pages.push_back(
      coordinates("Frequency spectrum of the mass centre", PageKind::Spectrum, kPureNumber, 13));
  return pages;
}

std::vector<PageSpec> race_pages() {
  const auto components = [](const std::string& title, int unit_slot, int first) {
    return history(title, {single("X component", unit_slot, first),
                           single("Y component", unit_slot, first + 1),
                           single("Z component", unit_slot, first + 2)});
  };
  return {
      motion("Mass centre velocities", slot::angular_velocity, slot::velocity, 1),
      components("Applied forces", slot::force, 4),
      components("Applied moments", slot::race_moment, 7),
      motion("Mass centre acceleration", slot::angular_acceleration, slot::acceleration, 10),
      coordinates("Mass centre whirl orbit", PageKind::Orbit, slot::length, 13),
      history("Position of the mass centre",
              {single("X", slot::length, 13), single("Y", slot::length, 14),
               single("Z", slot::length, 15)}),
      orientation(19),
      angular_velocity("Magnitude", slot::angular_velocity, 22),
      coordinates("Frequency spectrum of the mass centre", PageKind::Spectrum, slot::length, 13)};
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
  throw InputError(
      "this file holds an animation (SOL8), which has no plot pages; open it with agore");
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
