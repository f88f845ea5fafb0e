#pragma once

#include "agore/picture_key.hpp"
#include "agore/sketch.hpp"
#include "agore/solid_view.hpp"

#include <memory>

namespace adore::agore {

/// Constant parts of a view, kept from frame to frame.
struct ViewCache {
  SolidLayer solid;
  CageOutlines cages;
  std::shared_ptr<SpriteCache> stamps =
      std::make_shared<SpriteCache>();  ///< of all views of a window
  PictureLegend key;
};

}  // namespace adore::agore
