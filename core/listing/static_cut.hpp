#pragma once

#include "listing/solution_tables.hpp"

/// Radial cut through the most loaded element: where its contacts lie on the raceways, and how far
/// they are from the raceways' edges. Tables for plots, in metres, x along the bearing's axis, r
/// the distance from it, in the azimuth plane of that element.
///
/// "cut": one row with the element's number, azimuth and loads, and per race and side, as "outer -x
/// margin", the distance along the raceway from the edge of the contact to where the raceway or the
/// roller ends (negative: over the edge); NaN where the deck gives no edge, or without a contact.
/// "cut outer race", "cut inner race", "cut element": outlines "x", "r".
/// "cut outer contact", "cut inner contact": the raceway from one edge of the contact to the other.
/// Balls and their grooves stand at the angles of the solution; rollers, whose displacements no eye
/// would see at this scale, at their nominal place.
namespace adore::listing {

void add_cut(StaticTables& out, const statics::StaticSolution& solution,
             const bearing::Bearing& bearing);
void add_cut(StaticTables& out, const statics::RollerSolution& solution,
             const bearing::Bearing& bearing);

}  // namespace adore::listing
