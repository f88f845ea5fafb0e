#pragma once

#include <cstddef>

/// Boundary between race_contacts.cpp and the translation units that are compiled once per
/// instruction set. Plain numbers and pointers only: a header with inline library code (Eigen,
/// std::vector) included there could leave AVX instructions in functions that the linker then uses
/// everywhere.
namespace adore::dynamics {

/// Height conventions of tribology::ContactSurface as the kernel needs them: h(ξ) = [sqrt(ρ²-ξ²)] +
/// offset.
enum class KernelHeight : unsigned char {
  ThroughEdge,   ///< the surface passes through the ends of the major axis on the undeformed ball
  HalfApproach,  ///< half the approach below the undeformed ball at the centre
  Undeformed     ///< touches the undeformed ball at the centre
};

struct RaceKernelInput {
  // Groove, load and ellipse: Q = K δ^1.5, a = major sqrt(δ), b = minor sqrt(δ).
  double centre_radius, offset, K, major, minor;
  double ball_radius;
  double rho;  ///< radius of the contact surface [m], 0 = flat
  KernelHeight height;
  bool traction;
  // Law of traction.
  bool two_slope;
  double A, B, C, D, u0;
  double slip_floor;  ///< ε² of the rounded slip sqrt(u² + ε²) [m²/s²], > 0
  // Quadrature rule (tribology::EllipseRule).
  bool split;
  double slip_scale;             ///< of the law, for the break points of a split rule [m/s]
  int major_nodes, minor_nodes;  ///< split: major nodes of one piece
  const double *s, *chord, *weight_s;
  const double *v, *weight_v, *weight_v1, *weight_v2;
  // Race pose and motion, base frame.
  double centre[3], axis[3], velocity[3], speed;
  bool tilts;
  double tilt[3];
  // Balls and results (see race_contacts.hpp).
  std::size_t n;
  const double *x, *r, *sin_theta, *cos_theta, *x_dot, *r_dot, *theta_dot;
  const double *omega_x, *omega_r, *omega_theta;
  double *F_x, *F_r, *F_theta, *M_x, *M_r, *M_theta;
  double *load, *heat, *load_slip;
};

struct RaceKernelSums {
  double force[3], moment[3];  ///< on the race, base frame, about P_j
  double elastic_energy, heat, load_slip;
};

using RaceKernel = RaceKernelSums (*)(const RaceKernelInput&) noexcept;

RaceKernelSums race_kernel_baseline(const RaceKernelInput& in) noexcept;
#if defined(__x86_64__)
RaceKernelSums race_kernel_avx2(const RaceKernelInput& in) noexcept;
RaceKernelSums race_kernel_avx512(const RaceKernelInput& in) noexcept;
#endif

}  // namespace adore::dynamics
