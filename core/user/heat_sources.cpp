#include "user/heat_sources.hpp"

#include <cmath>

namespace adore::user {

void HeatSources::add(int kind, int element, int race, double heat, const Place& place,
                      const char* name) {
  kind_.push_back(kind);
  element_.push_back(element);
  race_.push_back(race);
  heat_.push_back(heat);
  for (const double one : {place.x, place.y, place.z}) place_.push_back(one);
  for (const double one : {place.across, place.along}) size_.push_back(one);
  name_.push_back(name);
}

HeatSources::HeatSources(const scene::Snapshot& snapshot, double element_radius)
    : step_size_(snapshot.step_size), total_(snapshot.energy.heat_rate()) {
  std::array<double, 2> of_races{}, of_flanges{};
  for (std::size_t j = 0; j < 2; ++j)
    for (const scene::ElementSnapshot& one : snapshot.elements) {
      load_.push_back(one.race[j].load);
      angle_.push_back(one.race[j].angle);
    }
  for (std::size_t i = 0; i < snapshot.elements.size(); ++i) {
    const scene::ElementSnapshot& one = snapshot.elements[i];
    x_.push_back(one.x);
    r_.push_back(one.r);
    theta_.push_back(one.theta);
    const double s = std::sin(one.theta), c = std::cos(one.theta);
    for (std::size_t j = 0; j < 2; ++j) {
      const scene::RaceContactSnapshot& contact = one.race[j];
      if (!(contact.load > 0.0)) continue;
      // One radius from the centre along the contact normal, which both angles measure from the
      // radial plane: positive when the inner race pushes towards +x.
      const double reach = j == 0 ? element_radius : -element_radius;
      const double x = one.x + reach * std::sin(contact.angle);
      const double r = one.r + reach * std::cos(contact.angle);
      add(ADORE_ELEMENT_RACE, static_cast<int>(i), static_cast<int>(j), contact.heat,
          {x, -r * s, r * c, contact.half_major, contact.half_minor},
          j == 0 ? "outer race contact" : "inner race contact");
      of_races[j] += contact.heat;
      for (const scene::FlangeContactSnapshot& flange : one.flange[j]) {
        if (!flange.present || !(flange.heat > 0.0)) continue;
        add(ADORE_ROLLER_FLANGE, static_cast<int>(i), static_cast<int>(j), flange.heat,
            {one.x, -one.r * s, one.r * c, 0.0, 0.0},
            j == 0 ? "outer race flange" : "inner race flange");
        of_flanges[j] += flange.heat;
      }
    }
  }
  for (const auto& item : snapshot.energy.items()) {
    if (item.term->kind != scene::LedgerKind::Heat) continue;
    double rest = item.rate;
    const auto j = static_cast<std::size_t>(item.race);
    if (item.term->id == "heat") rest -= of_races[j];
    if (item.term->id == "flange_heat")
      rest -= item.term->per_race() ? of_flanges[j] : of_flanges[0] + of_flanges[1];
    add(-1, -1, item.term->per_race() ? item.race : -1, rest, {}, item.place().data());
  }
}

adore_adrx9 HeatSources::arguments() const {
  adore_adrx9 out{};
  out.step_size = step_size_;
  out.total_heat = total_;
  out.n = static_cast<std::int64_t>(x_.size());
  out.x = x_.data();
  out.r = r_.data();
  out.theta = theta_.data();
  out.load = load_.data();
  out.contact_angle = angle_.data();
  out.sources = static_cast<std::int64_t>(heat_.size());
  out.source_kind = kind_.data();
  out.source_element = element_.data();
  out.source_race = race_.data();
  out.source_heat = heat_.data();
  out.source_place = place_.data();
  out.source_size = size_.data();
  out.source_name = name_.data();
  return out;
}

}  // namespace adore::user
