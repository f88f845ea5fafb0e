#pragma once

#include "bearing/material.hpp"

/// Energy losses of a contact of two materials (contact/damping_law.hpp), from
/// resources/materials.json.
namespace adore::bearing {

struct ContactLosses {
  double loss_factor = 0.0;  ///< η at small amplitude [-]
  double impact_loss = 0.0;  ///< α: an impact at a small speed v returns at (1 - α v) v [s/m]
};

/// Losses of one material. A material that the deck or a routine gives has no specific losses:
/// those of AISI 52100 steel from E = 50 GPa on, of polyamide below [choice].
[[nodiscard]] ContactLosses contact_losses(const Material& material);

/// Means of both, weighted by (1-ν²)/E: the softer body stores and loses most of the energy.
[[nodiscard]] ContactLosses contact_losses(const Material& a, const Material& b);

}  // namespace adore::bearing
