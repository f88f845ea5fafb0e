#pragma once

#include "bearing/bearing.hpp"
#include "listing/report.hpp"
#include "scene/snapshot.hpp"

/// Page 1c of a step: wear over the end of roller 1 and the flanges that it loads, by its load and
/// slip of this step.
///
/// The contact is found anew from the roller and its races (statics/roller_flanges.hpp) and has a
/// Hertz ellipse, half of it up the face `a`. Load per length up the face q = 3 Q/(4 a) (1 - s²),
/// s = y/a, slip u that of its center. Archard (manual 4.1.4): depth per time K/H q u/(2π r),
/// averaged over the circle that a place sweeps, r its distance from the bearing axis (flange) or
/// from the roller axis (end). 2π r times the depth, integrated over y, is K/H Q u [derived].
/// SI; depths are positive into the body. Limits: slip varies little over the ellipse; face and end
/// are taken as perpendicular to their axes; a contact at a corner or lip has the width of its
/// tube.
namespace adore::listing {

void print_flange_wear(Report& report, const scene::Snapshot& snapshot,
                       const bearing::Bearing& bearing);

}  // namespace adore::listing
