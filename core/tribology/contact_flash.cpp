#include "tribology/contact_flash.hpp"

#include "tribology/flash_strip.hpp"

#include <cmath>

namespace adore::tribology {
namespace {

/// Heat flux per kelvin of rise [W/(m² K)]; 0 of a material whose thermal data are not known.
double conductance(const FlashContact& c, const bearing::Material& m) {
  if (!(m.conductivity > 0.0) || !(m.density > 0.0) || !(m.specific_heat > 0.0)) return 0.0;
  const double peclet =
      0.5 * std::abs(c.speed) * c.half_width * m.density * m.specific_heat / m.conductivity;
  return 1.0 / circle_flash(1.0, c.half_width, m.conductivity, peclet);
}

}  // namespace

double contact_flash(const FlashContact& contact, const bearing::Material& one,
                     const bearing::Material& other) {
  if (!(contact.heat > 0.0) || !(contact.area > 0.0) || !(contact.half_width > 0.0)) return 0.0;
  const double both = conductance(contact, one) + conductance(contact, other);
  return both > 0.0 ? contact.heat / contact.area / both : 0.0;
}

}  // namespace adore::tribology
