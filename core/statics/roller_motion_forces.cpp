#include "statics/roller_motion_forces.hpp"

#include "base/errors.hpp"
#include "contact/roller_flange.hpp"
#include "statics/roller_flanges.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace adore::statics {
namespace {

Vec3 vector_of(const Triple<double>& v) { return {v.x, v.y, v.z}; }

/// Axes of a race of revolution, whose first one is given.
Mat3 race_axes(const Vec3& axis) {
  Mat3 out;
  out.col(0) = axis;
  out.col(1) = Vec3::UnitZ().cross(axis).normalized();
  out.col(2) = axis.cross(out.col(1));
  return out;
}

}  // namespace

RollerMotionForces::RollerMotionForces(const bearing::Bearing& bearing, const RollerModel& model,
                                       double load)
    : bearing_(bearing),
      model_(model),
      kernel_(roller_kernel()),
      load_(load),
      radius_(0.5 * model.rollers.diameter) {
  for (std::size_t j = 0; j < 2; ++j) {
    for (const RollerContactGeometry& body : model.bodies) {
      const SliceSet set = model.slices(j, body);
      slices_[j].push_back(
          contact::roller_race_slices(set.race, set.slices, set.width, set.law, model.E_star[j]));
    }
    const tribology::RaceFilmInputs surface =
        roller_film_surface(bearing, j, model.E_star[j], false);
    law_[j] = roller_race_law(bearing, surface);
    if (bearing.lubrication && bearing.lubrication->meniscus > 0.0) {
      demand(law_[j].has_film(), "oil without a film");
      rolls_ = true;
      rolling_[j] = tribology::rolling_resistance(tribology::lubricant_of(*bearing.lubrication),
                                                  *bearing.lubrication, surface);
    }
  }
  if (bearing.flange_traction) flange_law_ = *bearing.flange_traction;
  if (bearing.churning) drag_.emplace(bearing);
  const double T = std::sqrt(model.mass * radius_ / load_);
  units_ << radius_, radius_, 1.0, 1.0, 1.0 / T, 2.0 * radius_ / (model.rollers.pitch_diameter * T);
}

RollerMotionAction RollerMotionForces::at(const RollerState& roller, const Vec6& u,
                                          const Races<double>& races,
                                          const RollerMotionAction* same_outer) const {
  RollerMotionAction out;
  const RollerModel& m = model_;
  const contact::MeridianRotation azimuth = azimuth_rotation(roller);
  const double cos_tilt = std::cos(u[kPlaceTilt]), sin_tilt = std::sin(u[kPlaceTilt]);
  const double cos_skew = std::cos(u[kPlaceSkew]);
  const Vec3 a(cos_skew * cos_tilt, std::sin(u[kPlaceSkew]), cos_skew * sin_tilt);
  const Vec3 C(u[kPlaceX], 0.0, u[kPlaceR]);
  const double orbit = u[kPlaceOrbit];
  contact::RigidMotion motion;
  motion.origin = C;
  motion.velocity = orbit * Vec3::UnitX().cross(C);
  motion.omega = orbit * Vec3::UnitX() + u[kPlaceSpin] * a;

  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // about C
  const std::size_t body = slices_[0].size() == 1 ? 0 : roller.number;
  if (same_outer != nullptr) {
    force = same_outer->by_outer.head<3>();
    moment = same_outer->by_outer.tail<3>();
  }
  for (std::size_t j = same_outer != nullptr ? 1 : 0; j < 2; ++j) {
    const contact::RacePose pose{vector_of(azimuth.to_meridian(races[j].centre)),
                                 race_axes(vector_of(azimuth.to_meridian(races[j].axis)))};
    const contact::RigidMotion race{pose.centre, Vec3::Zero(),
                                    bearing_.speed[j] * pose.axes.col(0)};
    contact::RollerInMeridian in = contact::roller_in_meridian(pose, race, C, a, motion);
    const Vec3 spin = pose.direction(u[kPlaceSpin] * a);
    in.roller.spin = in.turn.to_meridian<double>({spin[0], spin[1], spin[2]});
    const contact::RaceSlicesView view = contact::view_of(slices_[j][body]);
    in.roller.open = contact::is_certainly_open(view, in.roller.x, in.roller.r, in.roller.axes.a);
    RollerKernelAction action{};
    RollerResistanceLoad rolled{};
    RollerKernelInput input{&view,
                            true,
                            1,
                            &in.roller,
                            nullptr,
                            &action,
                            true,
                            law_[j].index(),
                            law_[j].address(),
                            law_[j].regularization_slip_squared(),
                            nullptr,
                            rolls_ ? &rolling_[j] : nullptr,
                            &rolled};
    kernel_(input);
    const auto back = [&](const double(&v)[3]) { return in.back(pose, {v[0], v[1], v[2]}); };
    Vec3 of_race = back(action.force) + back(rolled.force);
    Vec3 about_C = back(action.moment) + back(rolled.moment);
    out.race[j] = action.load;
    out.heat.traction[j] = action.heat;
    out.heat.load_slip[j] = action.load_slip;
    out.heat.rolling[j] = rolled.heat;

    const Vec4 p(in.roller.x, in.roller.r, in.roller.axes.a.z, in.roller.axes.a.y);
    for (const FlangeEndPair& pair : m.body(roller.number).flanges) {
      if (pair.race != static_cast<int>(j) || pair.is_certainly_open(p)) continue;
      const contact::FlangeContact touch = contact::flange_contact_for_forces(
          pair.face, pair.end, Vec3(p(0), 0.0, p(1)), vector_of(in.roller.axes.a));
      if (!(touch.gap < 0.0)) continue;
      const auto to_frame = [&](const Vec3& v) { return in.back(pose, {v[0], v[1], v[2]}); };
      const double load = touch.steepness * contact::hertz_load(pair.K, -touch.gap);
      const Vec3 n = to_frame(touch.normal), X = pose.centre + to_frame(touch.point);
      const Vec3 slip = contact::contact_slip(race, motion, X, n);
      const double square = slip.squaredNorm();
      const double per_slip =
          load * flange_law_.visit_regularized([&](const auto& law) { return law(square); });
      const Vec3 push = load * n + per_slip * slip;
      of_race += push;
      about_C += (X - C).cross(push);
      out.flange += load;
      out.heat.flange[j] += per_slip * square;
    }
    force += of_race;
    moment += about_C;
    if (j == 0) {
      out.by_outer << of_race, about_C;
      continue;
    }
    Vec3 on_race = of_race;
    if (const double lean = m.body(roller.number).inner_slope; lean != 0.0) {
      RollerKernelAction normal{};
      input.out = &normal;
      input.traction = false;
      input.rolling = nullptr;
      kernel_(input);
      on_race += in.back(pose, {0.0, lean * normal.force[2] / in.roller.r, 0.0});
    }
    const Vec3 on_shaft = about_C + (C - pose.centre).cross(on_race);
    const Triple<double> F = azimuth.from_meridian<double>({on_race[0], on_race[1], on_race[2]});
    const Triple<double> M = azimuth.from_meridian<double>({on_shaft[0], on_shaft[1], on_shaft[2]});
    out.load << F.x, F.y, F.z, M.y, M.z;
  }

  const Vec3 from_C = m.mass_offset * a, G = C + from_C;
  Vec3 about_G = moment - from_C.cross(force);
  if (drag_) {
    const Vec3 V = motion.at(G) - bearing_.speed[0] * Vec3::UnitX().cross(G);
    force -= drag_->element_force_per_speed(V.norm()) * V;
    const double w = (motion.omega - bearing_.speed[0] * Vec3::UnitX()).dot(a);
    about_G -= drag_->element_spin(std::abs(w)) * w * a;
  }
  const double W = orbit + m.frame_speed;
  force += m.mass * W * W * Vec3(0.0, G[1], G[2]);
  force[2] += m.mass * (m.field.z() * roller.cos - m.field.y() * roller.sin);
  const double along = bearing_.element_inertia.moments.x(),
               across = bearing_.element_inertia.moments.y();
  const Vec3 omega = W * Vec3::UnitX() + u[kPlaceSpin] * a;
  const Vec3 H = across * omega + (along - across) * omega.dot(a) * a;
  about_G -= W * Vec3::UnitX().cross(H);

  const double by_load = 1.0 / load_;
  const double inertia = m.mass * radius_ * radius_, by_moment = by_load / radius_;
  out.rates << by_load * force[0], by_load * force[2], -by_moment * inertia / across * about_G[1],
      by_moment * inertia / across * (cos_tilt * about_G[2] - sin_tilt * about_G[0]),
      by_moment * inertia / along * about_G.dot(a), -by_load * force[1];
  return out;
}

}  // namespace adore::statics
