#pragma once

#include "bearing/bearing.hpp"
#include "bearing/material.hpp"
#include "bearing/user_tables.hpp"
#include "scene/plan.hpp"

#include <array>
#include <functional>
#include <memory>
#include <string>

/// Functions of user routines while a deck becomes a model and a plan, independent of
/// their origin. A null pointer to this: there is no plug-in.
namespace adore::setup {

struct UserHooks {
  std::array<bool, 10> active{};  ///< ADRX0 to ADRX9
  std::string source;             ///< the plug-in, for messages
  /// ADRX0. @throws InputError
  std::function<bearing::Material(bearing::Part, const bearing::Material&)> material;
  /// ADRX8. @throws InputError
  std::function<void(bearing::UserTables&)> imperfections;
  /// ADRX5 and ADRX6, of the bearing as it is built so far. @throws InputError
  std::function<void(const bearing::Bearing&, bearing::UserSurface&)> surface;
  /// A line for the front part of PRINT.txt on what ADRX5 or ADRX6 gave.
  std::function<void(int hook, const std::string& line)> document;
  /// ADRX5: element k is out of round (scene/user_laws.hpp).
  std::function<void(std::size_t k, std::shared_ptr<const bearing::SurfaceSeries>)> out_of_round;
  bool balls_out_of_round = false;  ///< known when the scene is planned
  int slices = 0;                   ///< of rollers
  bool points = false;              ///< barrels touch at points, not in slices
  // Announcements of ADRX1, known when the scene is planned.
  std::array<bool, 2> drives{};         ///< races whose accelerations it gives
  bool moves_frame = false;             ///< it accelerates the base frame
  scene::SuppressedMotions suppressed;  ///< kDOF = 6
};

/// Does the plug-in take this routine's part?
[[nodiscard]] inline bool has_routine(const UserHooks* user, int hook) {
  return user != nullptr && user->active[static_cast<std::size_t>(hook)];
}

}  // namespace adore::setup
