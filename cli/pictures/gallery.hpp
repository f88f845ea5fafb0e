#pragma once

#include "cli/picture_commands.hpp"

namespace adore::cli {

/// `adore gallery`: all pages and views of runs as pictures, with an index. Without runs those of
/// the five example decks, and the quasi-static examples.
/// Reports unreadable texts of a page on stderr.
void draw_gallery(const GalleryRequest& request);

}  // namespace adore::cli
