#include "thermal/ring.hpp"

#include <cmath>

namespace adore::thermal {

double pressure_displacement(double r, double a, double b, const Elastic& m, double pa, double pb) {
  if (a <= 0.0) return -(1.0 - m.nu) * pb * r / m.E;
  const double a2 = a * a, b2 = b * b;
  return ((1.0 - m.nu) * (pa * a2 - pb * b2) * r + (1.0 + m.nu) * a2 * b2 * (pa - pb) / r) /
         (m.E * (b2 - a2));
}

double pressure_hoop_stress(double r, double a, double b, double pa, double pb) {
  if (a <= 0.0) return -pb;
  const double a2 = a * a, b2 = b * b;
  return (pa * a2 - pb * b2 + (pa - pb) * a2 * b2 / (r * r)) / (b2 - a2);
}

double centrifugal_displacement(double r, double a, double b, const Elastic& m, double w) {
  const double a2 = a * a, b2 = b * b;
  const double hole = a > 0.0 ? (1.0 + m.nu) / (1.0 - m.nu) * a2 * b2 / (r * r) : 0.0;
  return m.rho * w * w * r * (3.0 + m.nu) * (1.0 - m.nu) / (8.0 * m.E) *
         (a2 + b2 - (1.0 + m.nu) / (3.0 + m.nu) * r * r + hole);
}

double centrifugal_hoop_stress(double r, double a, double b, const Elastic& m, double w) {
  const double a2 = a * a, b2 = b * b;
  const double hole = a > 0.0 ? a2 * b2 / (r * r) : 0.0;
  return (3.0 + m.nu) / 8.0 * m.rho * w * w *
         (a2 + b2 + hole - (1.0 + 3.0 * m.nu) / (3.0 + m.nu) * r * r);
}

double centrifugal_radial_stress(double r, double a, double b, const Elastic& m, double w) {
  const double a2 = a * a, b2 = b * b;
  const double hole = a > 0.0 ? a2 * b2 / (r * r) : 0.0;
  return (3.0 + m.nu) / 8.0 * m.rho * w * w * (a2 + b2 - hole - r * r);
}

double fit_pressure(double a, double c, double b, const Elastic& inner, const Elastic& outer,
                    double interference) {
  if (!(interference > 0.0) || b <= c || a >= c) return 0.0;
  const double a2 = a * a, b2 = b * b, c2 = c * c;
  const double compliance =
      ((b2 + c2) / (b2 - c2) + outer.nu) / outer.E + ((c2 + a2) / (c2 - a2) - inner.nu) / inner.E;
  return interference / (2.0 * c * compliance);
}

double mean_ring_temperature(double a, double b, double Ta, double Tb) {
  return Ta + (Tb - Ta) * (b * b / (b * b - a * a) - 1.0 / (2.0 * std::log(b / a)));
}

}  // namespace adore::thermal
