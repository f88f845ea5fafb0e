#pragma once

#include "calculators/adapter.hpp"

#include <vector>

namespace adore::calculators {

/// Families tribology_film, _thermalFactor, _starvation, _viscosity, _newtonFilm,
/// _shearThinningFilm, _viscoelasticStrip, _flashStrip, _journalBearing, _pocketFilm, _churning.
std::vector<Adapter> film_adapters();
std::vector<Adapter> hydrodynamic_adapters();

}  // namespace adore::calculators
