#pragma once

#include "results/cage_whirl.hpp"

/// Names that studies use of the law of cage whirl.
namespace adore::studies {

using results::CageInstant;
using results::classify_whirl;
using results::kRestingOrbit;
using results::kSteadyDeviation;
using results::kWhirlFigures;
using results::Whirl;
using results::whirl_class_name;
using results::WhirlClass;

}  // namespace adore::studies
