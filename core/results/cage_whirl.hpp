#pragma once

#include <array>
#include <string_view>
#include <vector>

/// How the cage's center goes round, over a window of a run.
///
/// With p = (y, z) the center, v its velocity, r = |p|, v_t the velocity about +X (θ from Z) and
/// ω_c the cage's mean angular velocity about X:
///   ratio      W = Σ r v_t / Σ r² / ω_c: the whirl speed, weighted by r², over the cage's
///   deviation  √(Σ (v_t - r W ω_c)² / Σ r²) / |ω_c|: how far the instantaneous whirl speed
///              leaves it; 0 for a circle run through evenly
///   orbit      √(mean |p - p̄|²) over the radial clearance of the guide lands: how far the center
///              moves about its own mean place
/// Both ratios stay finite where the center passes the axis. Sums are over stored instants, so the
/// interval of storing must resolve the whirl (five or more a turn of the cage).
///
/// Source of the classes: a steady whirl against an unsteady one by the scatter of the whirl speed,
/// as Ghaisas, Wassgren & Sadeghi, J. Tribol. 126 (2004) classify simulated cage motions [recalled,
/// medium]. The two limits below are estimates of this program.
namespace adore::results {

inline constexpr std::array<std::string_view, 4> kWhirlFigures{"whirl_ratio", "whirl_deviation",
                                                               "whirl_orbit", "whirl_class"};

/// Classes of the map. A resting cage keeps its position (gravity, drag); a whirling one
/// circles at a steady speed; an irregular one moves widely without a steady whirl.
enum class WhirlClass : unsigned char { Resting = 0, Whirling = 1, Irregular = 2 };
[[nodiscard]] std::string_view whirl_class_name(WhirlClass of);

inline constexpr double kRestingOrbit = 0.2;     ///< of the clearance: below it the cage rests
inline constexpr double kSteadyDeviation = 0.5;  ///< of |W|: below it a whirl is steady

struct Whirl {
  double ratio = 0.0, deviation = 0.0, orbit = 0.0;
  WhirlClass of = WhirlClass::Resting;
};

/// One instant: position over clearance, velocity over clearance [1/s], angular velocity about X.
struct CageInstant {
  double y = 0.0, z = 0.0, vy = 0.0, vz = 0.0, omega = 0.0;
};

[[nodiscard]] Whirl classify_whirl(const std::vector<CageInstant>& instants);

}  // namespace adore::results
