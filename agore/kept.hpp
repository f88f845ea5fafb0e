#pragma once

#include "agore/picture_key.hpp"
#include "agore/sketch.hpp"
#include "agore/solid_view.hpp"

#include <memory>

namespace adore::agore {

/// What a view keeps from frame to frame, because it does not change.
struct Kept {
  SolidLayer solid;
  CageOutlines cages;
  std::shared_ptr<Stamps> stamps = std::make_shared<Stamps>();  ///< of all views of a window
  KeyPicture key;
};

}  // namespace adore::agore
