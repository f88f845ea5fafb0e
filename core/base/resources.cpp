#include "base/resources.hpp"

#include "base/errors.hpp"

#include <string>

namespace adore::resources {

std::string_view get(std::string_view name) {
  for (const Resource& resource : all())
    if (resource.name == name) return resource.data;
  throw InternalError("no embedded file named " + std::string(name));
}

}  // namespace adore::resources
