#include "assembly/duplex_pair.hpp"

#include "assembly/preload.hpp"

namespace adore::assembly {
namespace {

struct Pair {
  BearingSet set;
  BearingSetState unloaded;
};

Pair pair_of(const runs::Prepared& row, double preload) {
  Assembly assembly;
  assembly.rows.resize(2);
  assembly.rows[1].orientation = -1;
  Pair out;
  // Without moments the distance does not matter.
  const double half = 0.5 * row.bearing.pitch_diameter();
  for (const int orientation : {1, -1})
    out.set.rows.push_back(
        {RowModel(row, RowCondition::Mounted), orientation, orientation > 0 ? -half : half, 0.0});
  set_offsets(out.set, assembly, offset_for_force(out.set, assembly, preload));
  out.unloaded = solve_bearing_set(out.set, std::array<double, 5>{}).state;
  return out;
}

}  // namespace

DuplexPair duplex_pair(const runs::Prepared& row, double preload) {
  const Pair pair = pair_of(row, preload);
  const Mat5& K = pair.unloaded.stiffness;
  return {total_offset(pair.set), K(0, 0), K(2, 2)};
}

std::optional<double> duplex_unloading_force(const runs::Prepared& row, double preload) {
  const Pair pair = pair_of(row, preload);
  for (const Unloading& one : unloading_forces(pair.set, pair.unloaded, [] {}))
    if (one.force > 0.0) return one.force;
  return std::nullopt;
}

}  // namespace adore::assembly
