#pragma once

#include "bearing/bearing.hpp"

#include <cstddef>
#include <vector>

/// Which pocket is in which piece of a cage, and where. The frame of a piece has x along the cage
/// axis, its origin on the axis at mid width, and z through its angular middle; of a cage in one
/// piece it is the frame of the cage.
///
/// With N pockets and S pieces of n = N/S pockets each, cuts of the width c (record 7.1) are taken
/// out of the middle of the bars before the elements lSeg, or of the middle of their pockets
/// (record 7.0.1). A piece reaches ±(π/S - c/2) from its middle. A cut pocket is two halves (N106):
/// the one at the start of a piece lies at y < 0 of its pocket frame (towards +θ), the one at the
/// end of the piece before at y > 0; both keep the wall at |y| >= (d_m/2) tan(c/2). The element in
/// it touches both pieces.
namespace adore::contact {

struct SegmentPocket {
  std::size_t element = 0;
  int piece = 0;
  double azimuth = 0.0;  ///< of the pocket in the frame of its piece [rad]
  int half = 0;          ///< 0 whole, -1 at the start of the piece, +1 at its end
};

struct CagePieces {
  std::vector<double> middle;  ///< azimuth of each piece [rad]
  double half_angle = 0.0;     ///< that a piece reaches from its middle, π: the whole [rad]
  std::vector<SegmentPocket> pockets;      ///< one by element, in their order
  std::vector<SegmentPocket> last_halves;  ///< one by piece, when the cuts go through pockets
};

/// @param azimuths of the elements, evenly spaced [rad]
[[nodiscard]] CagePieces cage_pieces(const bearing::Cage& cage,
                                     const std::vector<double>& azimuths);

/// |y| of the edge of a half pocket in its pocket frame [m].
[[nodiscard]] double half_pocket_edge(const bearing::Cage& cage, double pitch_diameter) noexcept;

}  // namespace adore::contact
