#include "life/contact_shape.hpp"

namespace adore::life {

ContactShape contact_shape(double major_axis, double land, double length) noexcept {
  constexpr double kLineFrom = 1.5;
  const double reach = major_axis + land;
  if (land >= major_axis || reach > kLineFrom * length) return ContactShape::Line;
  return reach < length ? ContactShape::Point : ContactShape::Between;
}

}  // namespace adore::life
