#pragma once

#include "bearing/fits.hpp"
#include "bearing/imperfections.hpp"
#include "bearing/lubrication.hpp"
#include "bearing/material.hpp"
#include "bearing/pocket_shape.hpp"
#include "bearing/rollers.hpp"
#include "bearing/thermal_inputs.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// The SI model of one bearing, input of the physics, independent of the deck. Plain values in
/// SI and radians. Arrays of two are [0] = outer race ("1" in the deck), [1] = inner race ("2").
/// Frames (design §6): base frame N at the ball plane of the unloaded bearing, X bearing axis, Z
/// radial up; azimuth θ about +X from Z: y = -r sin θ, z = r cos θ; azimuth frame A: x axial, z
/// radially outward, y = z × x.
namespace adore::bearing {

using Vec3 = Eigen::Vector3d;
enum Race : int { kOuter = 0, kInner = 1 };

/// Ball and groove geometry (record 5A) after the free state has been resolved: exactly one of
/// contact angle and clearance is independent (N39), both are filled here.
struct BallGeometry {
  int count = 0;                ///< nRe
  double diameter = 0.0;        ///< D [m]
  double pitch_diameter = 0.0;  ///< d_m [m]
  double contact_angle =
      0.0;                 ///< free contact angle α0 [rad], >= 0; 0 for a radial bearing with play
  double clearance = 0.0;  ///< diametral clearance Pd of the circular grooves [m]; < 0 is
                           ///< interference (then α0 = 0)
  std::array<double, 2> groove_factor{};  ///< f = groove radius / D, > 0.5
  /// x of the planes of the groove centers at zero displacement, base frame, outer and inner [m]:
  /// the datum of every displacement (decision 140). Empty: where unloaded balls just touch both
  /// grooves at contact_angle. Bearings given by their clearance have {0, 0}, bearings in operation
  /// the planes of the bearing on the bench.
  std::optional<std::array<double, 2>> groove_plane;
  std::array<double, 2> shim{};               ///< grinding shim of a split race [m], 0 = not split
  std::array<double, 2> shoulder_diameter{};  ///< [m], reports only
  std::array<double, 2> roughness{};          ///< composite rms [m]
};

struct Envelope {  ///< record 4 [m]
  double bore = 0.0, outer_diameter = 0.0, shaft_bore = 0.0, housing_diameter = 0.0;
  std::array<double, 2> race_width{};
};

/// A hypothetical traction curve κ(u), u = slip speed [m/s] (record 10.1, four forms reduced to
/// two, N44, N45).
struct TractionCurve {
  enum class Form : unsigned char {
    Exponential,  ///< κ = (A + B u) exp(-C u) + D
    TwoSlope      ///< κ = A + B u for u <= u0, A + B u0 + C (u - u0) above
  };
  Form form = Form::Exponential;
  double A = 0.0, B = 0.0, C = 0.0,
         D = 0.0;   ///< A [-], B [s/m], C [s/m], D [-] (D unused by TwoSlope)
  double u0 = 0.0;  ///< [m/s], TwoSlope only
};

struct GuideLand {  ///< record 7.2.i
  enum class Guide : unsigned char { None, Outer, Inner };
  Guide guide = Guide::None;
  double diameter = 0.0;   ///< on the cage [m]
  double width = 0.0;      ///< [m]
  double edge = 0.0;       ///< signed distance cage center -> outer edge [m]
  double clearance = 0.0;  ///< diametral [m]
  LandErrors of_cage, of_race;
  /// A circle in a circle.
  [[nodiscard]] bool ideal() const noexcept { return of_cage.ideal() && of_race.ideal(); }
};

/// Inertia of one rigid body about its mass center. Ideal shapes have their principal axes along
/// the geometric ones and their mass center in the geometric center; records 6 and 7.7 may say
/// otherwise.
struct Inertia {
  double mass = 0.0;                     ///< [kg]
  Vec3 moments = Vec3::Zero();           ///< principal, about x, y, z [kg m^2]
  Vec3 geometric_centre = Vec3::Zero();  ///< from the mass center, geometric axes [m]
  Vec3 frame = Vec3::Zero();             ///< angles from the principal to the geometric axes [rad]
};

/// Deviations of a pocket from the nominal one (record 7.4).
struct PocketDeviation {
  std::array<double, 2> clearance{};  ///< I, II, diametral [m]
  double thickness = 0.0;             ///< of the wall [m]
  double axial = 0.0;                 ///< of the center, along the cage's axis [m]
  double angular = 0.0;               ///< of the center's azimuth [rad]
  Vec3 tilt = Vec3::Zero();           ///< of the pocket's frame, angles about x, y, z in turn [rad]
  [[nodiscard]] bool is_zero() const noexcept {
    return clearance[0] == 0.0 && clearance[1] == 0.0 && thickness == 0.0 && axial == 0.0 &&
           angular == 0.0 && tilt.isZero(0.0);
  }
};

/// Guide face of a roller's cage pocket (record 7.3); its mate is the mirror image in the pocket's
/// x-z plane (N36). Pocket frame: x along the roller, z outward, y = z × x.
struct RollerPocketFace {
  Vec3 angles = Vec3::Zero();  ///< η, ξ, λ from pocket to face frame; y of that frame is the normal
                               ///< away from the roller [rad]
  Vec3 centre = Vec3::Zero();  ///< of the face [m]
  double width = 0.0;          ///< along its z [m]
  double length = 0.0;         ///< along its x [m]
};

/// How a cage or a piece of it starts (records 9.6, 9.6.k).
struct CageStartState {
  double whirl_ratio = 0.0;          ///< wvRatio
  double speed_ratio = 1.0;          ///< avRatio
  Vec3 start_offset = Vec3::Zero();  ///< cageGcPos [m]
  Vec3 start_angles = Vec3::Zero();  ///< η, ξ, λ [rad]
};

/// Equal pieces that a cage is cut into by planes through its axis (record 7.0.1).
struct Segmentation {
  int count = 1;
  bool through_pockets = false;  ///< else through the middle of the bars
  int first = 0;                 ///< element that the first piece starts with, from 0
  double cut_angle = 0.0;        ///< taken out between two pieces [rad]
  [[nodiscard]] bool several() const noexcept { return count > 1; }
};

/// Its sizes are those of the whole, uncut cage.
struct Cage : CageStartState {
  double outer_diameter = 0.0, inner_diameter = 0.0, width = 0.0;  ///< [m]
  double clearance_outer = 0.0,
         clearance_inner = 0.0;  ///< diametral, unguided surfaces and outputs only (N90) [m]
  PocketShape pocket = PocketShape::Cylindrical;
  double pocket_clearance_1 = 0.0, pocket_clearance_2 = 0.0;  ///< diametral [m]
  /// Of all pockets; its clearances are in pocket_clearance_1 and 2 already, and 0 here.
  PocketDeviation every_pocket;
  std::vector<PocketDeviation> pocket_deviation;  ///< of the first pockets; empty: all identical
  /// Of pocket i from 0, the two above together.
  [[nodiscard]] PocketDeviation deviation_of(std::size_t i) const {
    if (i >= pocket_deviation.size()) return every_pocket;
    PocketDeviation out = pocket_deviation[i];
    out.thickness += every_pocket.thickness;
    out.axial += every_pocket.axial;
    out.angular += every_pocket.angular;
    out.tilt += every_pocket.tilt;
    return out;
  }
  std::vector<RollerPocketFace> pocket_faces;  ///< of rollers, in place of a window; may be empty
  double cone_angle = 0.0;                     ///< [rad]
  std::vector<GuideLand> lands;
  Material material;
  Inertia inertia;  ///< from ideal geometry (contact/cage_inertia) or given; of each piece
  Segmentation segments;
  std::vector<CageStartState> later_segment_starts;  ///< of the second piece and those behind it
  [[nodiscard]] const CageStartState& start_of(std::size_t piece) const {
    return piece == 0 ? *this : later_segment_starts.at(piece - 1);
  }
};

/// How the inner-race equilibrium of the quasi-static solution is constrained, order x, y, z, about
/// y, about z (kFS1-5). Inner race relative to outer race; rotations about P, the center of the
/// inner groove-center circle.
struct StaticConstraints {
  std::array<bool, 5> displacement_given{};  ///< false: force or moment given
  std::array<double, 5> load{};              ///< [N, N, N, N m, N m], applied to the inner race
  std::array<double, 5>
      displacement{};  ///< [m, m, m, rad, rad]; first guess where the load is given (0: none)
  std::array<double, 2> outer_misalignment{};  ///< about y, z [rad]
};

enum class SpinRule : unsigned char { MinimumHeat, RaceControl, Prescribed };  ///< kAngVel

/// One bearing with its operating conditions, ready for statics and dynamics.
struct Bearing {
  std::string run_id;
  std::string user_version;  ///< of routines of the user: "+my laws 1"; empty: none
  Type type = Type::Ball;
  std::variant<BallGeometry, RollerGeometry> elements;  ///< balls of Type::Ball, else rollers
  Envelope envelope;
  Material element_material;  ///< of the rolling elements
  std::array<Material, 2> race_material;
  Inertia element_inertia;  ///< of one ball, or of a nominal roller: x along its own axis, about
                            ///< its mass center
  std::optional<Inertia> first_inertia;  ///< of element 1, where it has its own (kReIP = 1)
  double roller_mass_offset = 0.0;  ///< s_G: roller mass center along its axis from mid length [m]
  std::array<Inertia, 2> race_inertia;
  std::optional<Cage> cage;
  TractionCurve race_traction;                    ///< element to race
  std::optional<TractionCurve> pocket_traction;   ///< element to cage
  std::optional<TractionCurve> land_traction;     ///< cage to race
  std::optional<TractionCurve> element_traction;  ///< element to element, without cage
  std::optional<TractionCurve> flange_traction;   ///< roller end to race flange
  std::optional<Lubrication> lubrication;         ///< between elements and races; kTrac > 0
  std::optional<Churning> churning;               ///< kChrn > 0
  std::optional<CageFilms> cage_films;            ///< kPocHydro or kGsHydro
  std::optional<ThermalInputs> thermal;           ///< kTherm = 1
  Imperfections imperfections;  ///< of balls and races; rollers keep their own in RollerGeometry
  StaticConstraints constraints;
  SpinRule spin_rule = SpinRule::RaceControl;
  double spin_angle = 0.0;  ///< angVelOrient [rad], Prescribed only: angle of the spin axis from x
  std::array<double, 2> speed{};  ///< Ω of each race about its own axis [rad/s]
  Vec3 gravity = Vec3::Zero();    ///< [m/s^2], base frame
  std::array<double, 2> race_temperature{293.15, 293.15};  ///< [K]
  double element_temperature = 293.15, cage_temperature = 293.15,
         room_temperature = 293.15;          ///< [K]
  std::optional<double> medium_temperature;  ///< of coolant and churning medium, once found [K]
  Mounting mounting;                         ///< fits, housing and shaft
  std::optional<OperatingFits>
      operating;  ///< set once the geometry is the operating one (thermal/operating.hpp)

  /// For balls only. @throws std::bad_variant_access for rollers
  [[nodiscard]] const BallGeometry& balls() const { return std::get<BallGeometry>(elements); }
  [[nodiscard]] BallGeometry& balls() { return std::get<BallGeometry>(elements); }
  /// Null: a ball bearing.
  [[nodiscard]] const RollerGeometry* rollers() const noexcept {
    return std::get_if<RollerGeometry>(&elements);
  }
  [[nodiscard]] RollerGeometry* rollers() noexcept {
    return std::get_if<RollerGeometry>(&elements);
  }

  // Common members of both.
  [[nodiscard]] int element_count() const noexcept {
    return std::visit([](const auto& one) { return one.count; }, elements);
  }
  [[nodiscard]] double element_diameter() const noexcept {
    return std::visit([](const auto& one) { return one.diameter; }, elements);
  }
  [[nodiscard]] double pitch_diameter() const noexcept {
    return std::visit([](const auto& one) { return one.pitch_diameter; }, elements);
  }
};

}  // namespace adore::bearing
