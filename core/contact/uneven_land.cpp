#include "contact/uneven_land.hpp"

#include "base/constants.hpp"
#include "base/gauss.hpp"
#include "base/root.hpp"

#include <algorithm>

namespace adore::contact {
namespace {

constexpr double kEndOfSpot = 1e-10;  ///< [rad]

/// Waves per turn of a profile, at least those of a circle off centre; an ellipse has two.
double waves_of(const LandProfile& land) {
  if (land.kind == LandProfile::Kind::Wave) return std::max(1.0, std::abs(land.variation_2));
  return land.kind == LandProfile::Kind::Ellipse ? 2.0 : 1.0;
}

/// δ and its slope at ψ.
std::array<double, 2> deviation(const LandProfile& land, double psi) noexcept {
  if (land.kind == LandProfile::Kind::Circle) return {0.0, 0.0};
  const auto [R, slope] = land.at(psi);
  return {R - land.radius, slope};
}

}  // namespace

UnevenLand::UnevenLand(const Shape& shape) : shape_(shape) {
  const auto of_cage = land_deviation_range(shape.cage), of_race = land_deviation_range(shape.race);
  const double most = shape.side > 0.0 ? of_cage[1] - of_race[0] : of_race[1] - of_cage[0];
  reach_ = shape.clearance - most;
  constexpr double kCellsPerWave = 16.0;
  const double waves = std::max(waves_of(shape.cage), waves_of(shape.race)) + 1.0;
  cells_ = static_cast<int>(std::ceil(kCellsPerWave * waves * shape.half_angle / kPi)) + 1;
}

UnevenLand::Overlap UnevenLand::overlap(const Place& at, double s) const noexcept {
  const double psi = at.phi + s, sine = std::sin(psi), cosine = std::cos(psi);
  const double sigma = shape_.side;
  const auto cage = deviation(shape_.cage, s + at.s0);
  const auto race = deviation(shape_.race, psi - at.beta);
  const double along = -at.e[0] * sine + at.e[1] * cosine;
  const double across = -at.e[0] * cosine - at.e[1] * sine;
  Overlap out;
  out.u = {-sine, cosine};
  out.m = sigma * (along + cage[0] - race[0]) - shape_.clearance;
  out.by_phi = sigma * (across - race[1]);
  out.by_s = out.by_phi + sigma * cage[1];
  return out;
}

double UnevenLand::end_of_spot(const Place& at, double out, double m_out, double in,
                               double m_in) const noexcept {
  return root_between(out, m_out, in, m_in, kEndOfSpot, [&](double s) { return overlap(at, s).m; });
}

double UnevenLand::extremum(const Place& at, double a, double slope_a, double b,
                            double slope_b) const noexcept {
  return root_between(a, slope_a, b, slope_b, kEndOfSpot,
                      [&](double s) { return overlap(at, s).by_s; });
}

void UnevenLand::add(const Place& at, double a, double b, SectionVisitor& sink) const noexcept {
  // Six points: exact to degree 11, and a cell is a sixteenth of a wave.
  constexpr std::array<GaussPoint, 6> kGauss6 = {
      {{-0.93246951420315202781, 0.17132449237917034504},
       {-0.66120938646626451366, 0.36076157304813860757},
       {-0.23861918608319690863, 0.46791393457269104739},
       {0.23861918608319690863, 0.46791393457269104739},
       {0.66120938646626451366, 0.36076157304813860757},
       {0.93246951420315202781, 0.17132449237917034504}}};
  const double half = 0.5 * (b - a), middle = 0.5 * (a + b);
  ContactSpotSection piece;
  for (const GaussPoint& point : kGauss6) {
    const Overlap here = overlap(at, middle + half * point.node);
    if (here.m <= 0.0) continue;
    const double pressed = shape_.stiffness * half * point.weight * here.m;
    piece.force[0] -= pressed * shape_.side * here.u[0];
    piece.force[1] -= pressed * shape_.side * here.u[1];
    piece.turning -= pressed * here.by_phi;
    piece.energy += 0.5 * pressed * here.m;
  }
  piece.load = std::hypot(piece.force[0], piece.force[1]);
  if (piece.load > 0.0) sink.take(piece);
}

void UnevenLand::cell(const Place& at, double a, const Overlap& at_a, double b, const Overlap& at_b,
                      SectionVisitor& sink) const noexcept {
  const bool in_a = at_a.m > 0.0, in_b = at_b.m > 0.0;
  if (in_a != in_b) {
    const double end =
        in_a ? end_of_spot(at, b, at_b.m, a, at_a.m) : end_of_spot(at, a, at_a.m, b, at_b.m);
    return in_a ? add(at, a, end, sink) : add(at, end, b, sink);
  }
  const bool turns = in_a ? at_a.by_s < 0.0 && at_b.by_s > 0.0 : at_a.by_s > 0.0 && at_b.by_s < 0.0;
  if (!turns) {
    if (in_a) add(at, a, b, sink);
    return;
  }
  const double top = extremum(at, a, at_a.by_s, b, at_b.by_s);
  const double m_top = overlap(at, top).m;
  if (in_a == (m_top > 0.0)) {
    if (in_a) add(at, a, b, sink);
    return;
  }
  if (in_a) {
    add(at, a, end_of_spot(at, top, m_top, a, at_a.m), sink);
    add(at, end_of_spot(at, top, m_top, b, at_b.m), b, sink);
  } else {
    add(at, end_of_spot(at, a, at_a.m, top, m_top), end_of_spot(at, b, at_b.m, top, m_top), sink);
  }
}

void UnevenLand::walk(const Place& at, SectionVisitor& sink) const noexcept {
  const double e = std::hypot(at.e[0], at.e[1]), limit = shape_.half_angle;
  if (reach_ > 0.0 && e <= reach_) return;
  const double width = 2.0 * limit / cells_;
  const auto stretch = [&](double low, double high) {
    const int first = std::max(0, static_cast<int>(std::floor((low + limit) / width)));
    const int last = std::min(cells_, static_cast<int>(std::ceil((high + limit) / width)));
    if (first >= last) return;
    double a = first * width - limit;
    Overlap at_a = overlap(at, a);
    for (int i = first; i < last; ++i) {
      const double b = (i + 1) * width - limit;
      const Overlap at_b = overlap(at, b);
      cell(at, a, at_a, b, at_b, sink);
      a = b;
      at_a = at_b;
    }
  };
  // Contact lies where σ e·u > reach.
  const double window = e > std::abs(reach_) ? std::acos(reach_ / e) : kPi;
  if (window > 0.5 * kPi) return stretch(-limit, limit);
  const double centre =
      std::remainder(std::atan2(-shape_.side * at.e[0], shape_.side * at.e[1]) - at.phi, 2.0 * kPi);
  for (const double turn : {-2.0 * kPi, 0.0, 2.0 * kPi}) {
    const double low = std::max(-limit, centre + turn - window);
    const double high = std::min(limit, centre + turn + window);
    if (low < high) stretch(low, high);
  }
}

UnevenLand::MinimumGap UnevenLand::minimum_gap(const Place& at) const noexcept {
  const double limit = shape_.half_angle, width = 2.0 * limit / cells_;
  MinimumGap best{-overlap(at, -limit).m, -limit};
  const auto offer = [&](double s) {
    const double gap = -overlap(at, s).m;
    if (gap < best.gap) best = {gap, s};
  };
  double a = -limit;
  Overlap at_a = overlap(at, a);
  for (int i = 0; i < cells_; ++i) {
    const double b = (i + 1) * width - limit;
    const Overlap at_b = overlap(at, b);
    offer(b);
    if (at_a.by_s > 0.0 && at_b.by_s < 0.0) offer(extremum(at, a, at_a.by_s, b, at_b.by_s));
    a = b;
    at_a = at_b;
  }
  return best;
}

}  // namespace adore::contact
