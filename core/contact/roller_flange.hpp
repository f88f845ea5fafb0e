#pragma once

#include "contact/hertz.hpp"
#include "contact/race_surface.hpp"
#include "contact/roller_profile.hpp"

/// Contact of a roller end with a flange (rib) of a race. Race frame, SI, rad.
///
/// Flange face [choice]. In the meridian plane, g = unit vector along the raceway generator towards
/// the roller (flange at -x: (cos α, -sin α); at +x the opposite), n_r = raceway normal out of the
/// race (inner (sin α, cos α), outer the opposite), layback γ >= 0, root x0 on the raceway:
///   t = cos γ n_r - sin γ g   (up the face)
///   m = cos γ g + sin γ n_r   (unit normal towards the roller)
///   τ(X) = (X - x0)·t,  σ(X) = (X - x0)·m
/// valid up to τ <= h = H/cos γ, H the flange height along n_r.
/// γ is measured from the perpendicular to the raceway. A layback λ from the radial plane is
/// γ = λ + α_i (inner, -x), λ - α_i (inner, +x), λ - α_o (outer, -x), λ + α_o (outer, +x)
/// [derived].
///
/// Gap = least σ over the points of the roller end with τ <= h [choice]; no lower limit on τ
/// (undercut). Continuous in the pose; zero exactly where face, corner or lip touch; positive open,
/// negative overlap. At a lip that overlaps it is the least signed distance of the lip from the
/// end instead of one along m, so that under a motion of the roller gap' = n·v(X) everywhere and a
/// force along n with a potential of the gap is its gradient (along m it would be n/(n·m))
/// [derived]. Both agree where the gap is 0, and on the face.
/// Spherical end, centre E, in the meridian plane of E [derived]:
///   τ_E <= h: gap = σ_E - R_e, X = E - R_e m, height τ_E                                    (face)
///   else, open: gap = σ_E - √(R_e² - (τ_E - h)²), X = x0 + h t + gap m, normal (E - X)/R_e  (lip)
///   else: gap = √(σ_E² + (τ_E - h)²) - R_e, normal from the lip to E                        (lip)
/// X further from the roller axis than the cap radius: the corner torus touches instead (C1, since
/// both are tangent).
/// Corner torus (and flat end) [derived]: on the face min over χ of σ(Y(χ)) - r_c, Y on the ring,
/// X = Y - r_c m; on the lip the least distance (open: along m) from the lip circle to the end
/// surface. The smaller gap wins: where two places of an end touch alike the gap has a kink, and
/// the force changes from one to the other.
///
/// Skew moves the contact on a dome sideways by (R_e - L/2) φ r_X/r_E: 1 mrad can be a millimetre.
/// r_E -> 0 (dome centre on the bearing axis) is degenerate: sphere and rib fit along an arc; check
/// with dome_center_axis_distance. Not unique, so that point and stiffness jump: layback, tilt and
/// skew all zero at a flat end (face on face; keep γ >= 1 mrad), pure tilt of a flat end towards an
/// outer lip (two rim points; one is returned). Limits: rigid bodies but for the contact; one
/// contact per end and flange; stress at lips and edges is not Hertzian.
namespace adore::contact {

struct Flange {
  int side = bearing::kInner;         ///< race that carries it
  int at = -1;                        ///< -1 at the -x end of the roller, +1 at +x
  double layback = 0.0;               ///< γ [rad]
  double height = 0.0;                ///< H along the raceway normal [m]
  double race_half_angle = 0.0;       ///< α of its raceway, 0 for cylinders [rad]
  double root_x = 0.0, root_r = 0.0;  ///< x0 [m]
};

/// A flange made ready: two-component vectors are (x, r).
struct FlangeFace {
  double root_x = 0.0, root_r = 0.0;
  double t_x = 0.0, t_r = 0.0, m_x = 0.0, m_r = 0.0, g_x = 0.0, g_r = 0.0;
  double reach = 0.0;  ///< h = H/cos γ [m]

  [[nodiscard]] double sigma(double x, double r) const noexcept {
    return (x - root_x) * m_x + (r - root_r) * m_r;
  }
  [[nodiscard]] double coordinate_along_flange(double x, double r) const noexcept {
    return (x - root_x) * t_x + (r - root_r) * t_r;
  }
};
/// @throws InputError when height is not positive or layback not in 0 to π/2.
[[nodiscard]] FlangeFace flange_face(const Flange& flange);

struct FlangeContact {
  enum class Mode : unsigned char {
    Face,    ///< dome, or corner of a flat end, on the face
    Lip,     ///< beyond the height: the edge of the flange touches; count and report, stress is not
             ///< Hertzian
    Corner,  ///< a domed end touches the face with its corner: the contact has left the cap
    None     ///< the end does not reach the flange anywhere: gap infinite
  } mode = Mode::None;
  enum class Surface : unsigned char {
    Cap,
    Disc,
    Torus
  } surface = Surface::Cap;    ///< part of the roller that touches
  double gap = 0.0;            ///< [m]; infinite for None
  Vec3 point = Vec3::Zero();   ///< X on the roller [m]
  Vec3 normal = Vec3::Zero();  ///< unit, into the roller
  double steepness = 1.0;      ///< |∇gap| over motions of X; below 1 where a lip crosses a sharp
                               ///< corner [-]
  double height = 0.0;         ///< τ(X) along the face [m]
  double from_axis = 0.0;      ///< distance of X from the roller axis [m]
  bool on_cap = false;         ///< domed ends: the contact of the whole sphere lies on the cap
  double sphere_gap = 0.0;     ///< domed ends: gap as if the sphere had no limit [m]
};

/// Contact of one end of a roller with centre C and axis a, in the race frame. Hot path: no throw,
/// no allocation. The dome on its face is closed form; corners cost a scan of 16 points and a
/// safeguarded Newton iteration, lips a scan of 16 points and a root, open ones a search.
[[nodiscard]] FlangeContact flange_contact(const FlangeFace& face, const RollerEnd& end,
                                           const Vec3& centre, const Vec3& axis) noexcept;

/// The same where they overlap; the gap of an open lip is its least distance from the end, which no
/// motion of the roller's points by less closes. For forces.
[[nodiscard]] FlangeContact flange_contact_for_forces(const FlangeFace& face, const RollerEnd& end,
                                                      const Vec3& centre,
                                                      const Vec3& axis) noexcept;

/// Distance of the dome centre from the race axis [m]; must be positive and not small beside the
/// roller.
[[nodiscard]] double dome_center_axis_distance(const RollerEnd& end, const Vec3& centre,
                                               const Vec3& axis) noexcept;

/// |x0| of a flange at which an aligned, flat-ended cylindrical roller, seated on that race, has
/// half the play: L/2 - r_c + r_c/cos γ - r_c tan γ + play/2 [derived].
[[nodiscard]] double flat_end_root_distance(double length, double corner_radius, double layback,
                                            double play) noexcept;

/// Puts the root on the raceway generator through `on_raceway` so that an ideal roller (any ends)
/// in the pose C, a can travel `travel` along the generator until it touches; 0: touches in this
/// pose (tapered rib).
/// @throws InputError when no place on the generator gives contact.
[[nodiscard]] Flange placed_flange(Flange flange, const RollerEnd& end, const Vec3& centre,
                                   const Vec3& axis, const std::array<double, 2>& on_raceway,
                                   double travel);

/// Relative principal curvatures at the contact [1/m] [derived]. Dome on face: along t 1/R_e,
/// across 1/R_e + m_r/r_X. Corner: tube 1/r_c, ring (-n·e_ρ)/distance from the roller axis, not
/// below 1/(50 ρ_c) (the ellipse would be longer than the end) [choice]; sharp edges, of roller or
/// lip, as tubes of 0.1 mm [choice]. Principal planes at ω: A + B = ½Σκ, B - A = ½√(Δ1² + Δ2² +
/// 2Δ1Δ2 cos 2ω) [recalled, Hertz].
struct FlangeCurvature {
  RelativeCurvature relative{};
  double along = 0.0,
         across = 0.0;  ///< up the face and around the bearing axis (dome on face) [1/m]
};
[[nodiscard]] FlangeCurvature flange_curvature(const RollerEnd& end, const Vec3& axis,
                                               const FlangeContact& contact) noexcept;
inline constexpr double kEdgeTube = 1e-4;  ///< radius given to sharp edges [m] [choice]

/// Normal load K δ^1.5, δ = -gap, C1 at 0. K at the actual contact.
struct FlangeLoad {
  HertzConstants hertz;
  FlangeCurvature curvature;
  double load = 0.0;  ///< [N]; 0 when open
};
/// @throws InputError from hertz_constants when a dome is flatter around the bearing than its rib
/// (R_e >= r_X/sin(α_i - γ)).
[[nodiscard]] FlangeLoad flange_load(const RollerEnd& end, const Vec3& axis,
                                     const FlangeContact& contact, double E_star);

}  // namespace adore::contact
