#pragma once

#include "tribology/laws/exponential.hpp"
#include "tribology/laws/film_law_of.hpp"
#include "tribology/laws/heated_film.hpp"
#include "tribology/laws/measured_film.hpp"
#include "tribology/laws/shear_thinning_law.hpp"
#include "tribology/laws/two_slope.hpp"
#include "tribology/laws/user_law.hpp"
#include "tribology/laws/visco_elastic_film.hpp"

/// The traction laws that the solver knows: their order is that of the alternatives of
/// tribology::TractionLaw. Seen by the race kernels (laws/contact_point.hpp).
namespace adore::tribology {

using HeatedFilmLaw = FilmTractionLaw<HeatedFilm>;
using MeasuredViscosityFilmLaw = FilmTractionLaw<MeasuredViscosityFilm>;
using ThinningFilmLaw = FilmTractionLaw<ShearThinningFriction>;
using ViscoElasticFilmLaw = FilmTractionLaw<ViscoElasticFilm>;

template <template <class...> class List>
using TractionLawsIn = List<TwoSlopeLaw, ExponentialLaw, HeatedFilmLaw, MeasuredViscosityFilmLaw,
                            ThinningFilmLaw, ViscoElasticFilmLaw, UserTractionLaw>;

template <class... Laws>
struct TypeList {};
using TractionLawList = TractionLawsIn<TypeList>;

}  // namespace adore::tribology
