#pragma once

/// Slip at points of the edge of a contact ellipse, many at a time: plain loops, compiled per
/// instruction set with the same bytes on each (core/CMakeLists.txt). ellipse_traction.hpp has the
/// equations.
namespace adore::tribology {

/// Kinematics and surface of one contact.
struct EdgeContact {
  double u_c, u_t;       ///< slip at the ball centre without the W terms [m/s]
  double W_c, W_t, W_n;  ///< [rad/s]
  double a, b;           ///< half axes [m]
  double rho;            ///< radius of the surface [m]; 0: flat
  double h0;             ///< its height over the ball centre in the middle [m]
};

/// At n points s = ξ/a, |s| <= 1, of the edge: the larger |u_c| of its two sides, |u_t| with its
/// sign, and the sum of their squares.
void edge_slips(const EdgeContact& contact, int n, const double* s, double* across, double* rolling,
                double* squares) noexcept;

}  // namespace adore::tribology
