#pragma once

#include "scene/snapshot.hpp"
#include "user/adore_user.h"

#include <vector>

/// Where heat arises at one instant, for ADRX9: contacts of elements and races one by one with
/// place and size, roller ends at flanges, and of every other item of the energy ledger what it
/// dissipates as a whole. Their sum is the ledger's heat rate, by construction: what the detail of
/// a ledger item leaves of it (the integrals of a snapshot are those of the run) is a source of its
/// own.
namespace adore::user {

class HeatSources {
 public:
  HeatSources(const scene::Snapshot& snapshot, double element_radius);
  /// Points into this object and the snapshot's ledger terms.
  [[nodiscard]] adore_adrx9 arguments() const;

 private:
  struct Place {
    double x = 0.0, y = 0.0, z = 0.0, across = 0.0, along = 0.0;
  };
  void add(int kind, int element, int race, double heat, const Place& place, const char* name);

  double step_size_, total_;
  std::vector<double> x_, r_, theta_, load_, angle_, heat_, place_, size_;
  std::vector<std::int32_t> kind_, element_, race_;
  std::vector<const char*> name_;
};

}  // namespace adore::user
