#pragma once

#include "results/hdf5_handle.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

/// Layout of RESULTS.h5, common to writer and reader.
namespace adore::results::h5 {

/// Per-step numbers that are not channels.
struct StepSeries {
  std::string_view name, unit, description;
};
inline constexpr std::array kSeries = {
    StepSeries{"step", "-", "step number"}, StepSeries{"time", "s", "simulated time"},
    StepSeries{"step_size", "s", "last integration step"},
    StepSeries{"shaft_rotation", "rad", "inner minus outer race about x"}};

/// "contact.load" -> "/contact/load".
inline std::string dataset_path(std::string_view id) {
  std::string path = "/" + std::string(id);
  std::replace(path.begin(), path.end(), '.', '/');
  return path;
}

/// Access properties: newest format (single-writer mode needs it), and no failure where a file
/// system cannot lock.
inline Handle file_access_properties() {
  Handle list(H5Pcreate(H5P_FILE_ACCESS));
  H5Pset_libver_bounds(list, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  H5Pset_file_locking(list, true, true);
  return list;
}

}  // namespace adore::results::h5
