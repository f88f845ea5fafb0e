#pragma once

#include "tribology/laws/exponential.hpp"
#include "tribology/laws/two_slope.hpp"

/// The traction laws that the solver knows: their order is that of the alternatives of
/// tribology::TractionLaw. Seen by the race kernels (laws/contact_point.hpp).
namespace adore::tribology {

template <template <class...> class List>
using TractionLawsIn = List<TwoSlopeLaw, ExponentialLaw>;

template <class... Laws>
struct TypeList {};
using TractionLawList = TractionLawsIn<TypeList>;

}  // namespace adore::tribology
