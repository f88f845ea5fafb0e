#pragma once

#include "agore/picture_key.hpp"
#include "agore/sketch.hpp"
#include "agore/solid_view.hpp"

#include <memory>

namespace adore::agore {

/// Constant parts of a view, kept from frame to frame.
struct Kept {
  SolidLayer solid;
  CageOutlines cages;
  std::shared_ptr<Stamps> stamps = std::make_shared<Stamps>();  ///< of all views of a window
  KeyPicture key;
};

}  // namespace adore::agore
