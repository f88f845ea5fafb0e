#include "dynamics/held_rollers.hpp"

#include "base/symmetric_eigen.hpp"
#include "contact/slice_circle.hpp"
#include "contact/slice_table.hpp"
#include "dynamics/effects/roller_races.hpp"
#include "dynamics/race_contacts.hpp"

#include <algorithm>
#include <cmath>

namespace adore::dynamics {

namespace {

RollerSpringsKernel kernel_of(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512) return roller_springs_avx512;
  if (set == InstructionSet::Avx2) return roller_springs_avx2;
#endif
  (void)set;
  return roller_springs_baseline;
}

}  // namespace

/// One race with its flanges at a roller.
struct QuasiStaticRollers::Contact {
  contact::RacePose pose;
  contact::MeridianRotation turn;
  statics::PairPotential potential;
  double r = 0.0, side = 0.0;  ///< r' [m], s [N]
  Vec3 axis = Vec3::UnitX();   ///< of the roller, on (A, y', e)

  [[nodiscard]] Vec3 to_meridian(const Vec3& v) const {
    const Vec3 of_race = pose.direction(v);
    const contact::Triple<double> out = turn.to_meridian({of_race[0], of_race[1], of_race[2]});
    return {out.x, out.y, out.z};
  }
  [[nodiscard]] Vec3 back(const Vec3& v) const {
    const contact::Triple<double> out = turn.from_meridian({v[0], v[1], v[2]});
    return pose.direction_from_race({out.x, out.y, out.z});
  }
  /// On the roller, base axes.
  [[nodiscard]] Vec3 force() const {
    return back({-potential.gradient(0), -side, -potential.gradient(1)});
  }
  /// Its rate, base axes.
  [[nodiscard]] Vec3 force_rate(const Vec3& velocity, const Vec3& omega) const {
    const Vec3 v = to_meridian(velocity), of_axis = to_meridian(omega).cross(axis);
    const double round = v[1] / r, t = axis[2], f = axis[1];
    const statics::Vec4 rates(v[0], v[2], of_axis[2] + f * round, of_axis[1] - t * round);
    const statics::Vec4& g = potential.gradient;
    const statics::Vec4 g_rates = potential.hessian * rates;
    const double side_rate =
        (g_rates(2) * f + g(2) * rates(3) - g_rates(3) * t - g(3) * rates(2) - side * v[2]) / r;
    return back({-g_rates(0), -(side_rate + g(1) * round), -(g_rates(1) - side * round)});
  }
};

QuasiStaticRollers::QuasiStaticRollers(
    statics::RollerModel model, const bearing::Imperfections& errors, ElementMasses masses,
    std::span<const std::shared_ptr<const bearing::SurfaceSeries>> out_of_round)
    : model_(std::move(model)),
      kernel_(kernel_of(chosen_instruction_set())),
      masses_(std::move(masses)) {
  for (std::size_t j = 0; j < 2; ++j) {
    for (const statics::RollerContactGeometry& body : model_.bodies)
      slices_[j].push_back(contact::roller_race_slices(
          body.race[j], body.slices, model_.slicing.width, model_.law[j], model_.E_star[j]));
    if (const auto* const table = bearing::table_of(errors.race[j].given.get())) {
      surface_[j] = errors.race[j].given;
      max_approach_offset_[j] = contact::nearest(*table);
    } else if (!errors.race[j].ideal()) {
      wavy_[j] = contact::make_wavy_race(errors.race[j], model_.race[j],
                                         model_.rollers.race_radius(static_cast<int>(j)),
                                         model_.rollers.crown_radius);
    }
    for (const auto& lobe : out_of_round) {
      lobes_[j].emplace_back();
      if (lobe)
        lobes_[j].back() = lobe_as_race_error(*lobe, j, model_.race[j],
                                              model_.rollers.race_radius(static_cast<int>(j)),
                                              model_.rollers.crown_radius);
    }
  }
}

QuasiStaticRollers::Contact QuasiStaticRollers::contact(const Evaluation& e, std::size_t i,
                                                        std::size_t j,
                                                        const Vec3& centre) const noexcept {
  Contact out;
  const RaceBody& race = e.race[j];
  out.pose = {race.position, race.to_base};
  const Vec3 C = out.pose.point(centre);
  out.turn = contact::meridian_rotation(C[1], C[2], out.r);
  out.axis = out.to_meridian(e.attitude[i].col(0));
  const statics::Vec4 p(C[0], out.r, out.axis[2], out.axis[1]);
  contact::RaceSlicesView slices = contact::view_of(slices_[j][slices_[j].size() == 1 ? 0 : i]);
  if (wavy_[j])
    slices.race = wavy_[j]
                      ->at(contact::azimuth_in_rotated_race(out.turn, std::cos(race.turn_beyond),
                                                            std::sin(race.turn_beyond)))
                      .surface;
  if (!lobes_[j].empty() && lobes_[j][i]) {
    contact::WavyRace lobe = *lobes_[j][i];
    lobe.ideal = slices.race;
    slices.race = lobe.at(azimuth_in_roller(e.attitude[i], out.back(Vec3::UnitZ()), j)).surface;
  }
  std::vector<double> radius;
  if (const bearing::SurfaceTable* const table = bearing::table_of(surface_[j].get())) {
    const auto psi = contact::azimuth_in_rotated_race(out.turn, std::cos(race.turn_beyond),
                                                      std::sin(race.turn_beyond));
    radius.assign(slices.radius, slices.radius + slices.count);
    contact::apply_table_to_slices(*table, std::atan2(psi.sine, psi.cosine), radius.data(),
                                   nullptr);
    slices.radius = radius.data();
    for (double& around : slices.around) around += max_approach_offset_[j];
  }
  const statics::SliceRotations axes = statics::slice_rotations(p(2), p(3));
  if (!contact::is_certainly_open(slices, p(0), p(1), axes.a)) {
    RollerSprings springs;
    kernel_(slices, axes, p(0), p(1), springs);
    using Rows = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
    out.potential.gradient = Eigen::Map<const statics::Vec4>(springs.gradient);
    out.potential.hessian = Eigen::Map<const Rows>(&springs.hessian[0][0]);
    out.potential.total = springs.load;
    out.potential.stiffness = springs.stiffness;
  }
  // How a flange's gap curves is left out: 1/R of its contact against 1.5/δ.
  for (const statics::FlangeEndPair& flange : model_.body(i).flanges)
    if (flange.race == static_cast<int>(j) && !flange.is_certainly_open(p))
      statics::add_flange_force(flange, p, false, out.potential);
  const statics::Vec4& g = out.potential.gradient;
  out.side = (g(2) * out.axis[1] - g(3) * out.axis[2]) / out.r;
  return out;
}

void QuasiStaticRollers::springs(const Evaluation& e, std::span<const std::size_t> held,
                                 std::span<ContactLinearization> out) noexcept {
  for (std::size_t k = 0; k < held.size(); ++k) {
    const std::size_t i = held[k];
    ContactLinearization& of = out[k];
    of.normal.setZero();
    of.stiffness.setZero();
    const Vec3 to_middle = -model_.mass_offset * e.attitude[i].col(0), omega = e.element_omega(i);
    for (std::size_t j = 0; j < 2; ++j) {
      of.race[j].setZero();
      of.turning[j].setZero();
      of.along[j].setIdentity();
      const Contact c = contact(e, i, j, e.element_centre(i) + to_middle);
      if (!(c.potential.total > 0.0)) continue;
      const Vec3 force = e.to_cylindrical(i, c.force());
      const Vec2 n = force.head<2>() / std::max(force.norm(), 1e-300);
      of.along[j] -= n * n.transpose();
      for (int axis = 0; axis < 3; ++axis)
        of.race[j].col(axis) =
            -e.to_cylindrical(i, c.force_rate(e.to_base(i, Vec3::Unit(axis)), Vec3::Zero()));
      of.turning[j] = e.to_cylindrical(i, c.force_rate(omega.cross(to_middle), omega));
      of.normal += force;
      of.stiffness += of.race[j];
    }
  }
}

Vec2 QuasiStaticRollers::normal_force(const Evaluation& e, std::size_t i) const noexcept {
  const Vec3 C = e.element_centre(i) - model_.mass_offset * e.attitude[i].col(0);
  Vec3 force = Vec3::Zero();
  for (std::size_t j = 0; j < 2; ++j) force += contact(e, i, j, C).force();
  return e.to_cylindrical(i, force).head<2>();
}

/// Newton over (x, r) with the exact Hessian: eigenvalues are taken as positive, those of nothing
/// leave the roller where it is; the step is limited to max_free_displacement() and halved until
/// |G| falls.
QuasiStaticPosition QuasiStaticRollers::balanced(const Evaluation& e, std::size_t i,
                                                 const Vec2& force) const {
  constexpr int kIterations = 60;
  const double mass = masses_[i].mass, r0 = e.elements.r[i];
  const double momentum = mass * r0 * r0 * e.elements.theta_dot[i];
  const Vec3 base = -model_.mass_offset * e.attitude[i].col(0);
  struct Balance {
    Vec2 residual = Vec2::Zero();
    Mat2 stiffness = Mat2::Zero();
    double load = 0.0, size = 0.0;  // size: of the forces that balance
  };
  const auto at = [&](const Vec2& place) {
    Balance out;
    const double r = place[1];
    const double centrifugal = momentum * momentum / (mass * r * r * r);
    out.residual = force + Vec2(0.0, centrifugal);
    out.stiffness(1, 1) = 3.0 * centrifugal / r;
    out.size = force.norm() + centrifugal;
    const Vec3 C = e.to_base(i, place[0], r, 0.0) + base;
    for (std::size_t j = 0; j < 2; ++j) {
      const Contact c = contact(e, i, j, C);
      if (!(c.potential.total > 0.0)) continue;
      out.residual += e.to_cylindrical(i, c.force()).head<2>();
      for (int axis = 0; axis < 2; ++axis)
        out.stiffness.col(axis) -=
            e.to_cylindrical(i, c.force_rate(e.to_base(i, Vec3::Unit(axis)), Vec3::Zero()))
                .head<2>();
      out.load = std::max(out.load, c.potential.total);
      out.size += c.potential.total;
    }
    return out;
  };
  Vec2 place(e.elements.x[i], r0);
  Balance now = at(place);
  QuasiStaticPosition out;
  for (int n = 0; n < kIterations; ++n) {
    const SymmetricEigen<2> eigen =
        symmetric_eigen<2>(Mat2(0.5 * (now.stiffness + now.stiffness.transpose())));
    const double largest = eigen.values.cwiseAbs().maxCoeff();
    Vec2 step = Vec2::Zero(), held = Vec2::Zero();
    for (int k = 0; k < 2; ++k) {
      const Vec2 mode = eigen.vectors.col(k);
      const double stiffness = std::abs(eigen.values[k]), load = mode.dot(now.residual);
      if (!(stiffness > 1e-9 * largest)) continue;
      step += mode * (load / stiffness);
      held += mode * load;
    }
    if (held.norm() <= 1e-12 * now.size) {
      out.solved = true;
      break;
    }
    if (const double length = step.norm(); length > max_free_displacement())
      step *= max_free_displacement() / length;
    Balance next = at(place + step);
    for (int half = 0; half < 30 && !(next.residual.norm() < now.residual.norm()); ++half) {
      step *= 0.5;
      next = at(place + step);
    }
    if (!(next.residual.norm() < now.residual.norm())) {
      out.solved = held.norm() <= 1e-9 * now.size;
      break;
    }
    place += step;
    now = next;
  }
  out.x = place[0];
  out.r = place[1];
  out.speed = momentum / (mass * out.r * out.r);
  out.load = now.load;
  return out;
}

}  // namespace adore::dynamics
