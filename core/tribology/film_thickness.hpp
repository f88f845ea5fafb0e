#pragma once

/// Isothermal, fully flooded film thickness of elastohydrodynamic contacts. SI.
///   U = μ0 u/(E' R), G = α E', W = w/(E' R²) (point) or w'/(E' R) (line, w' load per length),
/// μ0 and α of the inlet at low pressure, u the mean speed of both surfaces, E' = 2/[(1-ν1²)/E1 +
/// (1-ν2²)/E2] (twice the modulus of contact mechanics). Regressions of numerical solutions, fitted
/// for U 1.7e-12 to 5e-11, W 1.1e-7 to 1.1e-6, G 2300 to 6800 and evaluated outside too.
/// W is never taken below 1e-9: W^-0.07 would grow without bound at no load.
namespace adore::tribology {

struct FilmThickness {
  double central = 0.0, minimum = 0.0;  ///< [m]
};

/// A regression for points (W of the load) or lines (W of the load per length):
///   h = c R U^s G^m W^-l (1 - e exp(-d k))
struct FilmRegression {
  double coefficient, speed, material, load;  ///< c, s, m, l
  double shape = 0.0, decay = 0.0;            ///< e, d
};
inline constexpr FilmRegression kPointCentral{2.69, 0.67, 0.53, 0.067, 0.61, 0.73},
    kPointMinimum{3.63, 0.68, 0.49, 0.073, 1.0, 0.68}, kLineCentral{3.06, 0.69, 0.56, 0.10},
    kLineMinimum{2.65, 0.70, 0.54, 0.13};
inline constexpr double kLeastLoadGroup = 1e-9;  ///< W is never taken below it

struct FilmInlet {
  double viscosity = 0.0;  ///< μ0 [Pa s]
  double alpha = 0.0;      ///< α [1/Pa]
  double speed = 0.0;      ///< u >= 0 [m/s]
  double modulus = 0.0;    ///< E' [Pa]
};

/// Point contact, entrained along the minor axis; Hamrock & Dowson 1977 III, k = a/b the ratio of
/// the half axes across and along the entrainment, for k >= 1:
///   h_c = 2.69 R U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k))
///   h_m = 3.63 R U^0.68 G^0.49 W^-0.073 (1 - e^(-0.68 k))
/// @param radius R of both bodies along the entrainment [m]
[[nodiscard]] FilmThickness point_film(const FilmInlet& inlet, double radius, double load,
                                       double k);

/// Point contact, any direction of entrainment; Chittenden, Dowson, Dunn & Taylor 1985, radii along
/// and across it:
///   h_c = 4.31 Re U^0.68 G^0.49 W^-0.073 {1 - exp[-1.23 (Rs/Re)^(2/3)]}, h_m: 3.68 and 0.67
[[nodiscard]] FilmThickness chittenden_point_film(const FilmInlet& inlet, double along,
                                                  double across, double load);

/// Line contact; central after Dowson & Toyoda 1979, 3.06 R G^0.56 U^0.69 W^-0.10, minimum after
/// Dowson 1968, 2.65 R G^0.54 U^0.7 W^-0.13. @param load per length [N/m]
[[nodiscard]] FilmThickness line_film(const FilmInlet& inlet, double radius, double load);

/// Line contact, minimum: Dowson & Higginson 1966, 1.6 R G^0.6 U^0.7 W^-0.13.
[[nodiscard]] double dowson_higginson_line_film(const FilmInlet& inlet, double radius, double load);

/// Line contact: Pan & Hamrock 1989, 2.922 R W^-0.166 U^0.692 G^0.470 and 1.714 R W^-0.128 U^0.694
/// G^0.568.
[[nodiscard]] FilmThickness pan_hamrock_line_film(const FilmInlet& inlet, double radius,
                                                  double load);

}  // namespace adore::tribology
