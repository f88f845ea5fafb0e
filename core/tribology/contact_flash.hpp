#pragma once

#include "bearing/material.hpp"

/// Temperature of a contact above its bodies (flash). SI. The mean heat flux over the contact goes
/// into both surfaces so that they have one temperature in it; each conducts inwards only, at the
/// rolling speed, as under a uniform flux on a circle of the half width along rolling
/// (flash_strip.hpp), which for fast surfaces is the moving band. Largest rise. Limits: both bodies
/// at one bulk temperature; no heat along the film.
namespace adore::tribology {

struct FlashContact {
  double heat = 0.0;        ///< dissipated [W]
  double area = 0.0;        ///< [m²]
  double half_width = 0.0;  ///< b along rolling [m]
  double speed = 0.0;       ///< of both surfaces through the contact [m/s], either sign
};
/// [K]; 0 without heat or area.
[[nodiscard]] double contact_flash(const FlashContact& contact, const bearing::Material& one,
                                   const bearing::Material& other);

}  // namespace adore::tribology
