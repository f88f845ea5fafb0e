#pragma once

#include "listing/solution_tables.hpp"

/// Radial section through the most loaded element: positions of its contacts on the raceways, and
/// their distances from the raceway edges. Tables for plots, in meters, x along the bearing axis, r
/// the distance from it, in the azimuth plane of that element.
///
/// "cut": one row with the element's number, azimuth and loads, and per race and side, as "outer -x
/// margin", the distance along the raceway from the edge of the contact to where the raceway or the
/// roller ends (negative: over the edge); NaN where the deck gives no edge, or without a contact.
/// "cut outer race", "cut inner race", "cut element": outlines "x", "r".
/// "cut outer contact", "cut inner contact": the raceway from one edge of the contact to the other.
/// Balls and their grooves are drawn at the angles of the solution; rollers, whose displacements
/// would be invisible at this scale, at their nominal position.
namespace adore::listing {

void add_radial_section(StaticTables& out, const statics::StaticSolution& solution,
                        const bearing::Bearing& bearing);
void add_radial_section(StaticTables& out, const statics::RollerSolution& solution,
                        const bearing::Bearing& bearing);

}  // namespace adore::listing
