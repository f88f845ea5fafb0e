#pragma once

namespace adore::scene {

/// Λ of a contact in oil whose film has collapsed; 0 would be "none known". Outputs show 0.
inline constexpr double kNoFilmLeft = 1e-9;

}  // namespace adore::scene
