#pragma once

#include "tribology/laws/exponential.hpp"
#include "tribology/laws/heated_film.hpp"
#include "tribology/laws/two_slope.hpp"

/// The traction laws that the solver knows: their order is that of the alternatives of
/// tribology::TractionLaw. Seen by the race kernels (laws/contact_point.hpp).
namespace adore::tribology {

template <template <class...> class List>
using TractionLawsIn =
    List<TwoSlopeLaw, ExponentialLaw, HeatedFilmLaw<TwoSlopeLaw>, HeatedFilmLaw<ExponentialLaw>>;

template <class... Laws>
struct TypeList {};
using TractionLawList = TractionLawsIn<TypeList>;
/// Those that know no lubricant, first in the list.
using DryLawList = TypeList<TwoSlopeLaw, ExponentialLaw>;

/// The law of metal contact of a law with a film; any other law itself.
template <class Law>
[[gnu::always_inline]] inline const auto& dry(const Law& law) {
  if constexpr (requires { law.metal; })
    return law.metal;
  else
    return law;
}

}  // namespace adore::tribology
