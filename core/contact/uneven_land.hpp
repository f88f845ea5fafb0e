#pragma once

#include "contact/guide_land.hpp"

#include <array>
#include <cmath>

/// A guide land whose radius, or that of its race, varies around, in motion. SI, rad.
///
/// One slice of the cage's land, a circle's arc of azimuths s in [-a, a] about the z axis of its
/// segment (a = π: a whole cage), radius R_c + δ_c(s + s0); the race's land has the radius
/// R_c + σ c + δ_r, σ = +1 outer, -1 inner guidance. In the plane across the race axis, with u(ψ) =
/// (-sin ψ, cos ψ), e the vector from the race axis to the slice centre, ψ = φ + s and β the turn
/// of the race's marks, the overlap at s is
///   m(s) = σ e·u(ψ) + σ (δ_c(s + s0) - δ_r(ψ - β)) - c
/// to first order in m/R and e/R, as the closed form of circles (conformal.hpp). Foundation law:
///   U(e, φ, β) = ½ K ∫ max(m, 0)² ds,   K = 3πE*/16 · slice length,
///   on the cage  F = -∂U/∂e = -K σ ∫ m u ds,   turning it   T = -∂U/∂φ = -K ∫ m ∂m/∂φ ds
///   on the race  -F, and about its axis -T: U knows φ and β relative to the race only. [derived]
/// Without errors and with a = π, U is that of land_energy_per_length, and T = 0.
/// The integral runs between the exact ends of every spot (found to 1e-10 rad), so that F and T are
/// the gradient of U to rounding. Limits: slopes dδ/Rds of a few per cent (the gap is measured
/// along the radius); tilt enters through e and φ.
namespace adore::contact {

/// One stretch of a spot, at most a sixteenth of a wave long.
struct ContactSpotSection {
  std::array<double, 2> force{};  ///< on the cage, (y, z) across the race axis [N]
  double turning = 0.0;           ///< T [N m]
  double load = 0.0;              ///< |force| [N]
  double energy = 0.0;            ///< [J]
};

class UnevenLand {
 public:
  struct Shape {
    double side = 1.0;                      ///< σ
    LandProfile cage, race;                 ///< δ_c, δ_r about their nominal radii
    double clearance = 0.0;                 ///< c, radial [m]
    double stiffness = 0.0;                 ///< K [N/m per rad]
    double half_angle = 3.141592653589793;  ///< a
  };
  struct Place {
    std::array<double, 2> e{};  ///< (y, z) in axes of the race that need not turn with it [m]
    double phi = 0.0;           ///< azimuth of the segment's z axis in those axes
    double beta = 0.0;          ///< turn of the race in those axes
    double s0 = 0.0;            ///< azimuth of the segment in the cage
  };

  explicit UnevenLand(const Shape& shape);

  /// No spot can exist at this eccentricity, whatever the azimuths.
  [[nodiscard]] bool is_out_of_reach(double e2) const noexcept {
    return reach_ > 0.0 && e2 <= reach_ * reach_;
  }
  /// Calls visit(ContactSpotSection) for each stretch of contact. No allocation, no throw.
  template <class Visit>
  void visit(const Place& at, const Visit& visit) const noexcept {
    struct Forward final : SectionVisitor {
      explicit Forward(const Visit& to) : visit(to) {}
      void take(const ContactSpotSection& piece) noexcept override { visit(piece); }
      const Visit& visit;
    } sink(visit);
    walk(at, sink);
  }
  struct MinimumGap {
    double gap = 0.0;  ///< least of -m(s) [m]
    double s = 0.0;    ///< where
  };
  [[nodiscard]] MinimumGap minimum_gap(const Place& at) const noexcept;
  [[nodiscard]] const Shape& shape() const noexcept { return shape_; }

 private:
  struct SectionVisitor {
    virtual void take(const ContactSpotSection& piece) noexcept = 0;

   protected:
    ~SectionVisitor() = default;
  };
  /// m, ∂m/∂s and ∂m/∂φ.
  struct Overlap {
    double m = 0.0, by_s = 0.0, by_phi = 0.0;
    std::array<double, 2> u{};
  };
  [[nodiscard]] Overlap overlap(const Place& at, double s) const noexcept;
  void walk(const Place& at, SectionVisitor& sink) const noexcept;
  void cell(const Place& at, double a, const Overlap& at_a, double b, const Overlap& at_b,
            SectionVisitor& sink) const noexcept;
  void add(const Place& at, double a, double b, SectionVisitor& sink) const noexcept;
  [[nodiscard]] double end_of_spot(const Place& at, double out, double m_out, double in,
                                   double m_in) const noexcept;
  [[nodiscard]] double extremum(const Place& at, double a, double slope_a, double b,
                                double slope_b) const noexcept;

  Shape shape_;
  double reach_ = 0.0;  ///< least |e| that can touch [m]
  int cells_ = 0;       ///< of the whole arc
};

}  // namespace adore::contact
