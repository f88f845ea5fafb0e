#pragma once

#include "agore/picture_key.hpp"
#include "agore/sketch.hpp"
#include "agore/solid_view.hpp"

namespace adore::agore {

/// What a view keeps from frame to frame, because it does not change.
struct Kept {
  SolidLayer solid;
  CageOutlines cages;
  Stamps stamps;
  KeyPicture key;
};

}  // namespace adore::agore
