#pragma once

#include "bearing/bearing.hpp"
#include "results/averages.hpp"
#include "results/quantities.hpp"
#include "scene/plan.hpp"

#include <array>
#include <string>

/// The load that the elements carried on the mean, against the load that the deck asks for. A
/// dynamic run holds its races where the quasi-static solution put them: what they carry there
/// follows from the motion (other contact angles, gyroscopic moments, a finite number of orbiting
/// elements). A race that moves under its load (kFD = 0, mode 2) carries it in the mean of a long
/// time. A radial load that turns (record 9.3A) has no one value to compare with.
namespace adore::results {

/// Above this difference the run warns; a race in balance (mode 2) should carry its load at
/// every instant.
inline constexpr double kLoadWarning = 0.05, kBalanceWarning = 0.01;
/// Preload, centrifugal force or weight load contacts by much more than a small external load does.
/// A balance of the contacts to 1e-3 of their load does not count as a difference (limit 5 % of 1
/// %: 5e-4 of the largest contact load).
inline constexpr double kLoadFloor = 0.01;

struct MeanLoad {
  double time = 0.0;            ///< span of the mean [s]
  std::array<bool, 3> given{};  ///< directions whose load is given and stays: others are displaced
  std::array<bool, 3> moves{};  ///< a race moves under its load there
  bool tilts = false;           ///< a race turns freely about y or z
  bool shaken = false;          ///< a race vibrates (record 9.3B)
  bool balanced = false;        ///< mode 2: that race has no inertia
  scene::Vec3 asked = scene::Vec3::Zero(), mean = scene::Vec3::Zero();  ///< x, y, z [N]
  double contact = 0.0;  ///< largest contact load, mean over time [N]
  /// |mean - asked| over |asked| or, if larger, kLoadFloor of the largest contact load, over the
  /// directions with a given load; 0 when none is asked.
  [[nodiscard]] double departure() const;
};

[[nodiscard]] MeanLoad mean_load(const Averages& averages, const bearing::Bearing& bearing,
                                 const scene::ScenePlan& plan = {});

/// A sentence when the departure is above its bound, with the remedy; empty when not.
[[nodiscard]] std::string load_warning(const MeanLoad& load, UnitSystem units);

}  // namespace adore::results
