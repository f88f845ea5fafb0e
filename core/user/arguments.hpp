#pragma once

#include "user/adore_user.h"

#include <cstddef>

/// Contents of the structures of adore_user.h after their first member, in one place: checks,
/// copies and the transfer to another process walk through this list.
namespace adore::user {

/// visit.in(pointer, count) for each array that is read, visit.out(pointer, count, columns, stride)
/// for each that is written (of `stride` values a row the first `columns` count), visit.values(
/// first, count) and visit.flags(first, count) for numbers of the structure itself that are
/// written.
template <class Visit>
void visit_arguments(adore_call& call, Visit&& visit) {
  const auto plain = [&visit](auto*& pointer, std::int64_t count) {
    visit.out(pointer, static_cast<std::size_t>(count), 0, 0);
  };
  const auto in = [&visit](auto*& pointer, std::int64_t count) {
    visit.in(pointer, static_cast<std::size_t>(count));
  };
  switch (call.hook) {
    case 0: {
      auto& a = reinterpret_cast<adore_adrx0&>(call);
      visit.values(&a.density, 10);
      return;
    }
    case 1: {
      auto& a = reinterpret_cast<adore_adrx1&>(call);
      visit.flags(a.drives, 8);
      visit.flags(&a.kink_count, 1);
      visit.values(a.start_velocity, 6);
      visit.values(a.start_spin, 2);
      visit.values(&a.longest_step, 1);
      visit.values(a.kinks, 8);
      visit.values(a.force, 6);
      visit.values(a.moment, 6);
      visit.values(a.acceleration, 6);
      visit.values(a.angular_acceleration, 6);
      visit.values(a.frame_acceleration, 3);
      visit.values(a.frame_omega, 3);
      visit.values(a.frame_angular_acceleration, 3);
      return;
    }
    case 2:
    case 3:
    case 4: {
      auto& a = reinterpret_cast<adore_force&>(call);
      in(a.element, a.n);
      in(a.surface, a.n);
      in(a.gap, a.n);
      in(a.gap_rate, a.n);
      in(a.built_in, a.n);
      plain(a.force, a.n);
      return;
    }
    case 5:
    case 6: {
      auto& a = reinterpret_cast<adore_surface&>(call);
      in(a.axial, a.n);
      in(a.azimuth, a.n);
      plain(a.radius, a.n);
      plain(a.curvature_factor, a.n);
      return;
    }
    case 7: {
      auto& a = reinterpret_cast<adore_adrx7&>(call);
      const std::int64_t all = a.points * a.stride;
      visit.values(&a.slip_scale, 1);
      visit.flags(&a.wants_points, 1);
      in(a.slip, all);
      in(a.pressure, all);
      for (const double** one : {&a.load, &a.peak_pressure, &a.half_major, &a.half_minor,
                                 &a.entrainment, &a.curvature, &a.middle_slip})
        in(*one, a.n);
      visit.out(a.kappa, static_cast<std::size_t>(all), static_cast<std::size_t>(a.n),
                static_cast<std::size_t>(a.stride));
      return;
    }
    case 8: {
      auto& a = reinterpret_cast<adore_adrx8&>(call);
      for (double** one : {&a.diameter, &a.crown_radius, &a.length, &a.central_length,
                           &a.land_offset, &a.pocket_clearance1, &a.pocket_clearance2,
                           &a.pocket_thickness, &a.pocket_axial, &a.pocket_angular})
        plain(*one, a.n);
      plain(a.pocket_tilt, 3 * a.n);
      visit.values(&a.mass, 1);
      visit.values(a.moments, 3);
      visit.values(a.geometric_centre, 3);
      visit.values(a.frame, 3);
      return;
    }
    case 9: {
      auto& a = reinterpret_cast<adore_adrx9&>(call);
      for (const double** one : {&a.x, &a.r, &a.theta}) in(*one, a.n);
      in(a.load, 2 * a.n);
      in(a.contact_angle, 2 * a.n);
      in(a.source_kind, a.sources);
      in(a.source_element, a.sources);
      in(a.source_race, a.sources);
      in(a.source_heat, a.sources);
      in(a.source_place, 3 * a.sources);
      in(a.source_size, 2 * a.sources);
      in(a.source_name, a.sources);
      visit.flags(&a.wants_channels, 1);
      in(a.channel_name, a.channels);
      in(a.channel_size, a.channels);
      in(a.channel_first, a.channels);
      in(a.channel_value, a.channel_values);
      return;
    }
    default:
      return;
  }
}

}  // namespace adore::user
