#include "contact/cage_pieces.hpp"

#include "base/constants.hpp"

#include <cmath>

namespace adore::contact {

CagePieces cage_pieces(const bearing::Cage& cage, const std::vector<double>& azimuths) {
  const bearing::Segmentation& cut = cage.segments;
  const std::size_t count = azimuths.size();
  CagePieces out;
  out.pockets.resize(count);
  for (std::size_t i = 0; i < count; ++i) out.pockets[i] = {i, 0, azimuths[i], 0};
  if (!cut.several()) {
    out.middle = {0.0};
    out.half_angle = kPi;
    return out;
  }
  const auto pieces = static_cast<std::size_t>(cut.count);
  const std::size_t share = count / pieces;
  const double pitch = 2.0 * kPi / static_cast<double>(count);
  // From the middle of a piece to its first pocket.
  const double first = -0.5 * pitch * static_cast<double>(cut.through_pockets ? share : share - 1);
  out.half_angle = kPi / static_cast<double>(pieces) - 0.5 * cut.cut_angle;
  for (std::size_t k = 0; k < pieces; ++k) {
    const auto element = [&](std::size_t j) {
      return (static_cast<std::size_t>(cut.first) + k * share + j) % count;
    };
    out.middle.push_back(azimuths[element(0)] - first);
    const int piece = static_cast<int>(k);
    for (std::size_t j = 0; j < share; ++j)
      out.pockets[element(j)] = {element(j), piece, first + pitch * static_cast<double>(j),
                                 cut.through_pockets && j == 0 ? -1 : 0};
    if (cut.through_pockets) out.last_halves.push_back({element(share), piece, -first, 1});
  }
  return out;
}

double half_pocket_edge(const bearing::Cage& cage, double pitch_diameter) noexcept {
  return 0.5 * pitch_diameter * std::tan(0.5 * cage.segments.cut_angle);
}

}  // namespace adore::contact
