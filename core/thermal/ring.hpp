#pragma once

/// Elasticity of rings and discs under pressure and rotation: plane stress, free to expand along
/// the axis, linear elastic, axisymmetric. SI; radii [m], displacements outward [m], stresses
/// positive in tension [Pa]. Source: Lamé's thick ring and the rotating disc [timoshenko1970]. The
/// plane-stress limit is a ring whose width is not much larger than its wall; a long sleeve differs
/// by terms of order ν². A solid disc has inner radius 0. Functions of plain numbers, no errors:
/// the caller owns 0 <= a < b and E > 0.
namespace adore::thermal {

struct Elastic {
  double E = 0.0;    ///< elastic modulus [Pa]
  double nu = 0.0;   ///< Poisson's ratio [-]
  double rho = 0.0;  ///< density [kg/m^3]
};

/// Radial displacement at r of a ring a..b under internal pressure pa and external pressure pb [m]:
///   u = {(1-ν)(pa a² - pb b²) r + (1+ν) a² b² (pa - pb)/r} / {E (b² - a²)};
/// solid: u = -(1-ν) pb r/E.
[[nodiscard]] double pressure_displacement(double r, double a, double b, const Elastic& m,
                                           double pa, double pb);

/// Hoop stress of the same ring: {pa a² - pb b² + (pa - pb) a² b²/r²}/(b² - a²);  solid: -pb.
[[nodiscard]] double pressure_hoop_stress(double r, double a, double b, double pa, double pb);

/// Radial displacement at r of a ring a..b turning at w [rad/s] (either sign):
///   u = ρ w² r (3+ν)(1-ν)/(8E) [a² + b² - (1+ν)/(3+ν) r² + (1+ν)/(1-ν) a² b²/r²];  solid: a = 0.
[[nodiscard]] double centrifugal_displacement(double r, double a, double b, const Elastic& m,
                                              double w);
/// σ_t = (3+ν)/8 ρ w² [a² + b² + a² b²/r² - (1+3ν)/(3+ν) r²]
[[nodiscard]] double centrifugal_hoop_stress(double r, double a, double b, const Elastic& m,
                                             double w);
/// σ_r = (3+ν)/8 ρ w² [a² + b² - a² b²/r² - r²]; largest at r = √(ab)
[[nodiscard]] double centrifugal_radial_stress(double r, double a, double b, const Elastic& m,
                                               double w);

/// Pressure between an inner part a..c and an outer part c..b with diametral interference I [m]
/// [Pa]:
///   p = I/(2c [ ((b²+c²)/(b²-c²) + ν_out)/E_out + ((c²+a²)/(c²-a²) - ν_in)/E_in ]).
/// 0 when I <= 0 (loose: -I is the running clearance) and when either part has no wall (b <= c or a
/// >= c).
[[nodiscard]] double fit_pressure(double a, double c, double b, const Elastic& inner,
                                  const Elastic& outer, double interference);

/// Area-mean temperature of a ring with the logarithmic profile between the surface temperatures
/// Ta, Tb [K]:
///   Tm = Ta + (Tb - Ta) [b²/(b²-a²) - 1/(2 ln(b/a))].
/// With a constant coefficient both surfaces of the free ring move by exactly r α (Tm - T_room), so
/// one bulk temperature per ring is enough. Needs 0 < a < b.
[[nodiscard]] double mean_ring_temperature(double a, double b, double Ta, double Tb);

}  // namespace adore::thermal
