#pragma once

/// Whether a roller against a race counts as a point or as a line contact in fatigue life.
namespace adore::life {

enum class ContactShape : unsigned char {
  Point,   ///< one ellipse that ends inside the roller
  Line,    ///< the roller carries over its whole effective length
  Between  ///< neither: the shorter of both lives counts
};

/// Rule of Harris (recalled): with 2a the major axis that the Hertz ellipse of the roller's crown
/// would have and l the effective length, below 2a = l a point, above 2a = 1.5 l a line, else
/// between. A straight land in the middle of the roller adds to the ellipse, and one that is longer
/// than the ellipse is a line for any ends (choice of this project: the rule is for crowns
/// without a land).
/// @param major_axis 2a [m], > 0; infinite: no crown @param land >= 0 [m] @param length l > 0 [m]
[[nodiscard]] ContactShape contact_shape(double major_axis, double land, double length) noexcept;

}  // namespace adore::life
