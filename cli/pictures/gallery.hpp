#pragma once

#include "cli/picture_commands.hpp"

namespace adore::cli {

/// `adore gallery`: every page and every view of runs as pictures, with a list of them. Without
/// runs those of the five example decks, and the quasi-static examples.
/// Says on stderr which words of a page cannot be read.
void draw_gallery(const GalleryRequest& request);

}  // namespace adore::cli
