#pragma once

#include "contact/ball_groove.hpp"
#include "statics/ball_model.hpp"
#include "statics/race_pose.hpp"

#include <array>
#include <limits>
#include <optional>

/// Where a ball stands in both grooves: the coordinates of contact/ball_groove.hpp, for exact or
/// small-angle kinematics of the inner race. Vectors in the azimuth frame (e_x, e_r, e_θ).
namespace adore::statics {

/// Of a ball in balance of friction (ball_friction.hpp), instead of the spin rule's: values at the
/// contacts `at` and their slopes there over s = (Q_o, Q_i, α_o, α_i, r).
struct LinearizedTractions {
  static constexpr std::size_t kPlaces = 5;
  struct Value {
    double value = 0.0;
    std::array<double, kPlaces> slope{};
  };
  std::array<Value, 2> along;    ///< along the major axes, on the ball [N]
  std::array<double, 2> into{};  ///< along the normals of the resultants of split races [N]
  Value orbital;                 ///< ω_m [rad/s]
  struct At {
    std::array<double, 2> load{};                ///< Q [N]
    std::array<double, 2> sin{}, cos{1.0, 1.0};  ///< of the contact angle
    double rho = 0.0;                            ///< r - d_m/2 [m]
  } at;
};

struct BallSite {
  double sin = 0.0, cos = 1.0;  ///< of the azimuth
  std::size_t own = 0;          ///< BallModel::seat
  SpinLaw law;
  double pitch_guess =
      std::numeric_limits<double>::quiet_NaN();  ///< where the least-heat search starts
  double axis_shift = 0.0;  ///< least heat: β by the law of the deck minus β at a constant
                            ///< coefficient (least_heat.hpp) [rad]
  std::optional<LinearizedTractions> tractions;
};

template <class P>
RacePose<P> inner_race_pose(const BallModel& m, const std::array<P, 5>& q) {
  RacePose<P> pose;
  pose.q = q;
  if (m.exact) {
    pose.centre = {q[0] + m.groove.centre_x[1], q[1], q[2]};
    pose.axis = tilted_axis(q[3], q[4]);
  }
  return pose;
}

/// Both races as one ball sees them: in its azimuth frame.
template <class P>
struct RacesInAzimuthFrame {
  std::array<Triple<P>, 2> centre{}, axis{};              ///< exact kinematics [m], unit vector
  std::array<P, 2> shift_x{0.0, 0.0}, shift_r{0.0, 0.0};  ///< of the groove centre: linear [m]
  P ahead = 0.0;  ///< azimuth of the ball in the inner race minus that of its seat: linear [rad]
};

template <class P>
RacesInAzimuthFrame<P> races_in_azimuth_frame(const BallModel& m, const BallSite& site,
                                              const RacePose<P>& inner) {
  RacesInAzimuthFrame<P> seen;
  const contact::GrooveGeometry& groove = m.seat(site.own).groove;
  const double s = site.sin, c = site.cos;
  if (m.exact) {
    if (m.outer_tilted) {
      const auto axis = tilted_axis(m.outer_tilt[0], m.outer_tilt[1]);
      seen.centre[0].x = groove.centre_x[0];
      seen.axis[0] = contact::to_azimuth(Triple<P>{axis.x, axis.y, axis.z}, s, c);
    }
    seen.centre[1] = contact::to_azimuth(inner.centre, s, c);
    seen.axis[1] = contact::to_azimuth(inner.axis, s, c);
    return seen;
  }
  const auto& q = inner.q;
  seen.shift_x[0] = groove.centre_radius[0] * (m.outer_tilt[0] * c + m.outer_tilt[1] * s);
  seen.shift_x[1] = q[0] + groove.centre_radius[1] * (q[3] * c + q[4] * s);
  seen.shift_r[1] = q[2] * c - q[1] * s;
  seen.ahead = (q[1] * c + q[2] * s) * (1.0 / groove.centre_radius[1]);
  return seen;
}

/// Ball centre relative to one groove-centre circle.
template <class S, class P = S>
struct GroovePosition {
  S xi = 0.0, eta = 0.0;  ///< along the race axis; radial, from the groove centre [m]
  Triple<P> a{};          ///< race axis
  Triple<S> e{};          ///< radial direction of the ball seen from it
};

/// Ball at (x, r = d_m/2 + rho). S: numbers of the ball, P: of the pose.
template <class S, class P>
std::array<GroovePosition<S, P>, 2> groove_positions(const BallModel& m, const BallSite& site,
                                                     const S& x, const S& rho,
                                                     const RacesInAzimuthFrame<P>& races) {
  std::array<GroovePosition<S, P>, 2> position;
  const BallInGrooves& seat = m.seat(site.own);
  const contact::GrooveGeometry& groove = seat.groove;
  for (std::size_t j = 0; j < 2; ++j) {
    GroovePosition<S, P>& p = position[j];
    if (m.exact && (j == 1 || m.outer_tilted)) {
      const Triple<P>& centre = races.centre[j];
      const S r = rho + 0.5 * m.balls.pitch_diameter;
      const Triple<S> d{x - centre.x, r - centre.y, S(-centre.z)};
      const Triple<P>& axis = races.axis[j];
      const Triple<S> k{S(axis.x), S(axis.y), S(axis.z)};
      const auto place = contact::groove_coordinates(d, k, groove.centre_radius[j]);
      p = {place.axial, place.lift, axis, place.e};
    } else {
      // Directions stay those of the azimuth frame.
      p.a = {P(1.0), P(0.0), P(0.0)};
      p.e = {S(0.0), S(1.0), S(0.0)};
      p.xi = x - groove.centre_x[j] - races.shift_x[j];
      p.eta = rho - (groove.centre_radius[j] - 0.5 * m.balls.pitch_diameter) - races.shift_r[j];
    }
  }
  GroovePosition<S, P>& inner = position[1];
  if (m.exact && site.own != 0) {
    inner.xi = inner.xi - (groove.centre_x[1] - m.groove.centre_x[1]);
  }
  if (seat.inner_slope != 0.0) {
    inner.eta = inner.eta - seat.inner_slope * (m.exact ? inner.e.z : S(races.ahead));
  }
  return position;
}

}  // namespace adore::statics
