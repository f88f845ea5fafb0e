#pragma once

#include "tribology/laws/exponential.hpp"
#include "tribology/laws/film_law_of.hpp"
#include "tribology/laws/heated_film.hpp"
#include "tribology/laws/measured_film.hpp"
#include "tribology/laws/thinning_film.hpp"
#include "tribology/laws/two_slope.hpp"
#include "tribology/laws/user_law.hpp"
#include "tribology/laws/visco_elastic_film.hpp"

/// The traction laws that the solver knows: their order is that of the alternatives of
/// tribology::TractionLaw. Seen by the race kernels (laws/contact_point.hpp).
namespace adore::tribology {

using HeatedFilmLaw = FilmLawOf<HeatedFilm>;
using MeasuredFilmLaw = FilmLawOf<MeasuredFilm>;
using ThinningFilmLaw = FilmLawOf<ThinningFilm>;
using ViscoElasticFilmLaw = FilmLawOf<ViscoElasticFilm>;

template <template <class...> class List>
using TractionLawsIn = List<TwoSlopeLaw, ExponentialLaw, HeatedFilmLaw, MeasuredFilmLaw,
                            ThinningFilmLaw, ViscoElasticFilmLaw, UserLaw>;

template <class... Laws>
struct TypeList {};
using TractionLawList = TractionLawsIn<TypeList>;

}  // namespace adore::tribology
