#pragma once

#include <span>
#include <string_view>

/// Files compiled into the library (materials, example decks), so that an installed program needs
/// no data folder.
namespace adore::resources {

struct Resource {
  std::string_view name;  ///< e.g. "materials.json", "decks/ball.txt"
  std::string_view data;
};

/// Every embedded file, in the order of cmake/EmbedResources.cmake.
std::span<const Resource> all();

/// The content of one embedded file.
/// @throws adore::InternalError when no such file was embedded.
std::string_view get(std::string_view name);

}  // namespace adore::resources
