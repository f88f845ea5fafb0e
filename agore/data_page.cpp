#include "agore/fastest_contact.hpp"
#include "agore/race_speeds.hpp"
#include "agore/views.hpp"
#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::agore {
namespace {

/// Speeds by differences of three-digit angles are good to about 1 %; finer detail is not shown.
constexpr double kRatioSpan = 0.05;

/// A panel of one history, with its reason if it has no values. All panels of a page share their
/// times.
void add(desktop::ChartPage& page, const std::string& title, const std::string& name,
         const History& history, bool exact, bool ratio = false) {
  if (page.panels.empty() || page.panels.back().title != title)
    page.panels.push_back({title, history.unit, {}, false, ratio && !exact ? kRatioSpan : 0.0});
  desktop::ChartPanel& panel = page.panels.back();
  panel.curves.push_back({name, history.value, {}});
  panel.curves.back().low = history.low;
  panel.curves.back().high = history.high;
  if (!history.unknown.empty()) panel.message = history.unknown;
  if (page.x.size() < history.time.size()) page.x = history.time;
}

}  // namespace

desktop::ChartPage data_page(const Animation& animation, const ViewOptions& options) {
  desktop::ChartPage page;
  page.x_title = "Time";
  page.x_unit = "s";
  const auto k = static_cast<std::size_t>(options.element - 1);
  const bool exact = animation.motion != nullptr;
  const int segment = animation.pocket_part.at(k);
  switch (options.view) {
    case View::Bearing:
    case View::Section:
    case View::Solid: {
      // Without land forces the loads are drawn.
      const bool guided = animation.has_cage && (animation.land[0] || animation.land[1]);
      if ((options.view != View::Bearing || !guided) && animation.contacts) {
        page.title = fmt::format("Contact loads of element {}", options.element);
        const auto* second =
            animation.motion ? animation.motion->channel("second_contact.load") : nullptr;
        const bool both = second != nullptr && second->width > 0 &&
                          std::any_of(second->values.begin(), second->values.end(),
                                      [](double load) { return load > 0.0; });
        for (const auto& [race, name] :
             {std::pair<std::size_t, const char*>{0, "outer race"}, {1, "inner race"}}) {
          // Four curves would have no room for their names.
          const std::string panel = both ? (race == 0 ? "Outer load" : "Inner load") : "Load";
          add(page, panel, both ? "one half" : name, contact_load(animation, k, race), exact);
          if (both)
            add(page, panel, "other half", contact_load(animation, k, race, "second_contact.load"),
                exact);
        }
        break;
      }
      page.title = "Guide land force";
      for (std::size_t land = 0; land < 2; ++land)
        if (animation.land[land])
          add(page, "Force", "land " + std::to_string(land + 1),
              land_force(animation, land, segment), exact);
      if (page.panels.empty()) {
        page.x = animation.time;
        page.panels.push_back({"Force", animation.file.units[2], {}, false});
        page.panels.back().message =
            animation.has_cage ? "This cage has no guide land." : "This bearing has no cage.";
      } else if (page.panels.front().curves.size() == 1) {
        page.title += ", " + page.panels.front().curves.front().name;
      }
      page.title += animation.segment_remark(segment);
      break;
    }
    case View::Cage: {
      page.title = "Cage speed / " + divisor_text(animation, cage_speed_divisor(animation)) +
                   animation.segment_remark(segment);
      const History whirl = cage_whirl(animation, segment);
      std::string name = "Whirl";
      if (whirl.least_radius > 0.0) {
        const std::string least =
            desktop::pretty_quantity(whirl.least_radius, animation.file.units[0], 2);
        name += " (r > " + least + ")";
        page.note = "Whirl is undefined near the axis (r < " + least + ") and not drawn there.";
      }
      add(page, name, "", whirl, exact, true);
      add(page, "Rotation", "", cage_speed(animation, segment), exact, true);
      break;
    }
    case View::Raceways:
      page.title = fmt::format("Largest pressure, element {}", options.element);
      for (const auto& [race, name] :
           {std::pair<std::size_t, const char*>{0, "outer race"}, {1, "inner race"}})
        add(page, "Pressure", name, contact_load(animation, k, race, "contact.pressure"), exact);
      break;
    case View::Pocket:
      page.title = fmt::format("Force in pocket {}", options.element);
      add(page, "Force", "", pocket_force(animation, k), exact);
      break;
    case View::Element:
      page.title = fmt::format("Element {} / {}", options.element,
                               divisor_text(animation, element_speed_divisor(animation, k)));
      add(page, "Orbit", "", element_orbit_speed(animation, k), exact, true);
      add(page, "Rotation", "", element_spin(animation, k), exact, true);
      break;
    case View::OuterRace:
    case View::InnerRace: {
      const std::size_t r = options.view == View::OuterRace ? 0 : 1;
      page.title = "Race center";
      const char* names[] = {"X", "Y", "Z"};
      for (std::size_t c = 0; c < 3; ++c)
        add(page, names[c], "", race_position(animation, r, c), exact);
      break;
    }
    case View::Flange: {
      const std::size_t r = options.flange_race;
      page.title =
          fmt::format("{} flanges, element {}", r == 0 ? "Outer" : "Inner", options.element);
      for (const auto& [what, title] :
           {std::pair<const char*, const char*>{"force", "Load"}, {"gap", "Gap"}})
        for (std::size_t side = 0; side < 2; ++side)
          if (has_flange(animation, r, side))
            add(page, title, side == 0 ? "at −x" : "at +x",
                flange_history(animation, what, k, r, side), exact);
      break;
    }
  }
  note_missed_peaks(page, animation);
  page.band_note = "Min–max band between stored steps.";
  // Values after the end of RESULTS.h5 have fewer digits or are missing.
  if (animation.alone) page.marks.push_back({animation.motion->times().back(), "SOL8 only"});
  return page;
}

}  // namespace adore::agore
