#include "results/averages.hpp"

#include "results/motion.hpp"

#include <algorithm>
#include <cmath>

namespace adore::results {
namespace {

double largest_of(std::span<const double> loads) {
  double load = 0.0;
  for (const double one : loads) load = std::max(load, one);
  return load;
}

double largest_contact_load(const scene::Snapshot& snapshot) {
  double load = 0.0;
  for (const scene::ElementSnapshot& element : snapshot.elements)
    for (const scene::RaceContactSnapshot& contact : element.race)
      load = std::max(load, contact.load);
  return load;
}

}  // namespace

RunAverages::Totals RunAverages::totals(const scene::Snapshot& snapshot) {
  Totals totals;
  totals.time = snapshot.time;
  totals.shaft = snapshot.shaft_rotation;
  for (const scene::ElementSnapshot& element : snapshot.elements) totals.elements += element.theta;
  if (!snapshot.elements.empty()) totals.elements /= static_cast<double>(snapshot.elements.size());
  for (const scene::CageSnapshot& cage : snapshot.cages)
    totals.cage += cage.total_rotation / static_cast<double>(snapshot.cages.size());
  totals.heat = snapshot.energy.sum(scene::LedgerKind::Heat);
  for (std::size_t race = 0; race < 2; ++race)
    if (const auto* item = snapshot.energy.find("heat", static_cast<int>(race)))
      totals.race_heat[race] = item->value;
  return totals;
}

void RunAverages::add(const scene::Snapshot& snapshot) {
  const Totals before = last_totals_;
  last_totals_ = totals(snapshot);
  const scene::Vec3& force = snapshot.races[1].carried_force;
  if (started_) {
    const double passed = last_totals_.time - before.time;
    const scene::Vec3 impulse = 0.5 * passed * (force_ + force);
    impulse_ += impulse;
    if (!race_heat_known_)
      race_heat_known_ = true;
    else
      stored_step_sums_.add(
          passed,
          {last_totals_.shaft - before.shaft, last_totals_.elements - before.elements,
           last_totals_.cage - before.cage, last_totals_.heat - before.heat,
           last_totals_.race_heat[0] - before.race_heat[0],
           last_totals_.race_heat[1] - before.race_heat[1], impulse[0], impulse[1], impulse[2]});
  } else {
    max_load_time_ = last_totals_.time;
  }
  force_ = force;
  add_max_load(last_totals_.time, largest_contact_load(snapshot));
  residual_ = std::max(residual_, std::abs(snapshot.energy.residual()));
  power_loss_ = snapshot.power.total_loss;
  if (!started_) start_ = last_totals_;
  started_ = true;
  if (snapshot.cages.size() == 1)
    add_cage_position(last_totals_.time, snapshot.cages.front().position);
  if (snapshot.cages.size() < 2) return;
  scene::Vec3 mean = scene::Vec3::Zero();
  for (const scene::CageSnapshot& cage : snapshot.cages)
    mean += cage.mass_centre / static_cast<double>(snapshot.cages.size());
  add_cage_position(last_totals_.time, mean);
}

void RunAverages::add_loads(double time, std::span<const double> outer,
                            std::span<const double> inner) {
  if (started_) add_max_load(time, std::max(largest_of(outer), largest_of(inner)));
}

/// A run that continues from before its last sample passes that time twice: it counts once.
void RunAverages::add_max_load(double time, double largest) {
  const double passed = std::max(time - max_load_time_, 0.0);
  const double impulse = 0.5 * passed * (max_load_ + largest);
  max_load_integral_ += impulse;
  step_sums_.add(passed, {impulse});
  max_load_time_ += passed;
  max_load_ = largest;
  peak_load_ = std::max(peak_load_, largest);
}

void RunAverages::add_cage_position(double time, const scene::Vec3& position) {
  const double angle = orbit_motion(position, Vec3::Zero(), Vec3::Zero()).theta;
  whirl_angle_ = whirl_started_ ? nearest_branch(angle, whirl_angle_) : angle;
  if (!whirl_started_) whirl_start_angle_ = whirl_angle_;
  whirl_started_ = true;
  const double y = position[1], z = position[2], passed = time - last_center_time_;
  if (has_last_center_ && !(passed > 0.0))
    return;  // of a run that continues from before its last sample
  if (has_last_center_) {
    const double area = last_center_y_ * z - last_center_z_ * y;
    const double square =
        0.5 * passed *
        (last_center_y_ * last_center_y_ + last_center_z_ * last_center_z_ + y * y + z * z);
    swept_area_ += area;
    radius_squared_integral_ += square;
    whirl_sums_.add(passed, {area, square});
  }
  has_last_center_ = true;
  last_center_time_ = time;
  last_center_y_ = y;
  last_center_z_ = z;
}

MeanSeries RunAverages::series() const {
  MeanSeries out;
  if (last_totals_.shaft != start_.shaft) {
    out.orbital_ratio = stored_step_sums_.ratio(1, 0);
    out.cage_ratio = stored_step_sums_.ratio(2, 0);
    const double speed = (last_totals_.shaft - start_.shaft) / (last_totals_.time - start_.time);
    out.swept_whirl_ratio = whirl_sums_.ratio(0, 1);
    for (double& square : out.swept_whirl_ratio.s) square *= speed;
  }
  out.power_loss = stored_step_sums_.rate(3);
  out.heat_outer = stored_step_sums_.rate(4);
  out.heat_inner = stored_step_sums_.rate(5);
  out.heat_elsewhere = out.power_loss;
  for (std::size_t b = 0; b < out.heat_elsewhere.a.size(); ++b)
    out.heat_elsewhere.a[b] -= out.heat_outer.a[b] + out.heat_inner.a[b];
  for (std::size_t k = 0; k < 3; ++k) out.load[k] = stored_step_sums_.rate(6 + k);
  out.largest_load = step_sums_.rate(0);
  return out;
}

MeanErrors errors_of(const MeanSeries& series) {
  const auto half = [](const RatioSeries& one) { return ratio_half_width(one.a, one.s); };
  MeanErrors out;
  out.orbital_ratio = half(series.orbital_ratio);
  out.cage_ratio = half(series.cage_ratio);
  out.swept_whirl_ratio = half(series.swept_whirl_ratio);
  out.power_loss = half(series.power_loss);
  out.heat_outer = half(series.heat_outer);
  out.heat_inner = half(series.heat_inner);
  out.heat_elsewhere = half(series.heat_elsewhere);
  out.largest_load = half(series.largest_load);
  for (std::size_t k = 0; k < 3; ++k) out.load[k] = half(series.load[k]);
  return out;
}

Averages RunAverages::averages() const {
  Averages out;
  out.time = last_totals_.time - start_.time;
  const double turned = last_totals_.shaft - start_.shaft;
  if (turned != 0.0) {
    out.orbital_ratio = (last_totals_.elements - start_.elements) / turned;
    out.cage_ratio = (last_totals_.cage - start_.cage) / turned;
    out.whirl_ratio = (whirl_angle_ - whirl_start_angle_) / turned;
    if (radius_squared_integral_ > 0.0)
      out.swept_whirl_ratio = swept_area_ / radius_squared_integral_ * (out.time / turned);
  }
  out.power_loss = out.time > 0.0 ? (last_totals_.heat - start_.heat) / out.time : power_loss_;
  const double looked = max_load_time_ - start_.time;
  out.largest_load = looked > 0.0 ? max_load_integral_ / looked : max_load_;
  out.peak_load = peak_load_;
  out.largest_residual = residual_;
  out.load = out.time > 0.0 ? scene::Vec3(impulse_ / out.time) : force_;
  return out;
}

/// The one list of what MASTER keeps.
template <class Self, class Visit>
void RunAverages::visit(Self& self, Visit visit) {
  visit("average start time", self.start_.time);
  visit("average start shaft", self.start_.shaft);
  visit("average start elements", self.start_.elements);
  visit("average start cage", self.start_.cage);
  visit("average start heat", self.start_.heat);
  visit("average time", self.last_totals_.time);
  visit("average shaft", self.last_totals_.shaft);
  visit("average elements", self.last_totals_.elements);
  visit("average cage", self.last_totals_.cage);
  visit("average heat", self.last_totals_.heat);
  visit("average outer heat", self.last_totals_.race_heat[0]);
  visit("average inner heat", self.last_totals_.race_heat[1]);
  visit("average whirl start", self.whirl_start_angle_);
  visit("average whirl", self.whirl_angle_);
  visit("average swept time", self.last_center_time_);
  visit("average swept y", self.last_center_y_);
  visit("average swept z", self.last_center_z_);
  visit("average swept area", self.swept_area_);
  visit("average swept square", self.radius_squared_integral_);
  visit("average loss", self.power_loss_);
  visit("average force x", self.force_[0]);
  visit("average force y", self.force_[1]);
  visit("average force z", self.force_[2]);
  visit("average impulse x", self.impulse_[0]);
  visit("average impulse y", self.impulse_[1]);
  visit("average impulse z", self.impulse_[2]);
  visit("average largest time", self.max_load_time_);
  visit("average largest load", self.max_load_);
  visit("average largest impulse", self.max_load_integral_);
  visit("average peak load", self.peak_load_);
  visit("average largest residual", self.residual_);
}

void RunAverages::save(std::map<std::string, double>& state) const {
  if (!started_) return;
  visit(*this, [&](const char* key, double value) { state[key] = value; });
  state["average whirl started"] = whirl_started_ ? 1.0 : 0.0;
  state["average swept started"] = has_last_center_ ? 1.0 : 0.0;
  stored_step_sums_.save(state, "batch stored");
  step_sums_.save(state, "batch stepped");
  whirl_sums_.save(state, "batch whirled");
}

void RunAverages::restore(const std::map<std::string, double>& state) {
  *this = {};
  const auto whirl = state.find("average whirl started");
  if (whirl == state.end()) return;
  started_ = true;
  whirl_started_ = whirl->second != 0.0;
  visit(*this, [&](const char* key, double& value) {
    if (const auto found = state.find(key); found != state.end()) value = found->second;
  });
  race_heat_known_ = state.count("average outer heat") > 0;
  stored_step_sums_.restore(state, "batch stored");
  step_sums_.restore(state, "batch stepped");
  whirl_sums_.restore(state, "batch whirled");
  const auto swept = state.find("average swept started");  // earlier runs have none: from here on
  has_last_center_ = swept != state.end() && swept->second != 0.0;
  // Of runs that looked at loads in snapshots alone.
  if (state.count("average largest time") == 0) max_load_time_ = last_totals_.time;
}

}  // namespace adore::results
