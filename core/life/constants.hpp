#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Constants of the life models, read once from the embedded life_constants.json, each with the
/// word for its origin: seen (in a public source), recalled (literature by memory),
/// derived or calibrated (this project), manual, deck, option. The word is printed with the
/// value.
namespace adore::life {

/// A number and where it comes from.
struct SourcedValue {
  double value = 0.0;
  std::string origin;
};

/// A contact whose Lundberg-Palmgren capacity load has life 1e6 revolutions in every stress model.
struct CalibrationContact {
  double diameter = 0.0;                  ///< of the rolling element [m]
  double conformity = 0.0, length = 0.0;  ///< f of a point contact, or l [m] of a line contact
  double gamma = 0.0;
  int count = 0;
};

struct AisoKappaRange {
  double from = 0.0, to = 0.0, c = 0.0, p = 0.0;  ///< κ range, coefficients
};
/// a_ISO = 0.1 [1 - (constant - c/κ^p)^inner (x/m)^load]^outer
struct AisoFormula {
  std::vector<AisoKappaRange> bands;
  double constant = 0.0, inner = 1.0, load = 0.0, outer = 0.0, thrust_divisor = 1.0;
};

struct LifeConstants {
  SourcedValue point_constant, line_constant;  ///< A [N/mm^1.8], B [N/mm^(50/27)]
  SourcedValue stress_exponent, depth_exponent, point_slope, line_slope;  ///< c, h, e
  SourcedValue zaretsky_exponent;                                         ///< life exponent 9
  // Calibration of the stress models.
  double elastic_modulus = 0.0, poisson_ratio = 0.0, harris_limit = 0.0;
  CalibrationContact point, line;
  SourcedValue iso_equivalent_limit;  ///< [Pa]
  // STLE.
  std::map<std::string, double> stle_material, stle_process;
  std::vector<std::pair<double, double>> film_table;  ///< Λ, factor
  std::string stle_origin;                            ///< of all STLE tables
  // Tallian-type.
  double asperity_slope = 0.0, asperity_traction = 0.0, asperity_exponent = 0.0,
         asperity_life_factor = 0.0;
  std::map<int, std::pair<double, double>> stle_by_code;  ///< material, process
  struct TallianDefaults {
    double material = 1.0, process = 1.0, contamination = 1.0;
  };
  std::map<int, TallianDefaults> tallian_by_code;
  // ISO 281.
  double reduction_ball = 0.0, reduction_ball_double = 0.0, reduction_roller = 0.0,
         reduction_thrust_roller = 0.0;
  double thrust_roller_constant = 0.0;  ///< f_c of thrust rollers at 90° over λη γ^(2/9) [N, mm]
  std::map<std::string, double> rating_factor;  ///< b_m by bearing type
  double table_conformity_radial = 0.0, table_conformity_thrust = 0.0;
  struct RelativeLoadRow {
    double relative_load = 0.0, e = 0.0, Y = 0.0;  ///< f0 Fa/C0
  };
  struct LoadFactors {
    double X = 0.0;
    std::vector<RelativeLoadRow> rows;
  };
  LoadFactors deep_groove, spindle;  ///< contact angles of 0 and of 15 degrees
  struct AngularContactRow {
    double degrees = 0.0, X = 0.0, Y = 0.0, e = 0.0;
  };
  std::vector<AngularContactRow> angular;
  std::vector<std::pair<double, double>> static_factor;  ///< γ, f0
  AisoFormula aiso_ball, aiso_roller;
  std::map<std::string, std::pair<double, double>> contamination;  ///< C1, C2 by code
  // ISO 16281.
  double ball_inner = 0.0, ball_outer = 0.0, ball_bracket = 0.0;
  double roller_inner = 0.0, roller_outer = 0.0, roller_bracket = 0.0, roller_reduction = 0.0,
         roller_lamina_load = 0.0;
};

/// Parsed on first use; never changes.
[[nodiscard]] const LifeConstants& constants();

/// Fatigue limit (von Mises) of a material of the table and its provenance; empty where none is
/// known [Pa].
[[nodiscard]] std::optional<SourcedValue> fatigue_limit_of_code(int code);

}  // namespace adore::life
