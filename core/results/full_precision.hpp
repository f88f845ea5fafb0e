#pragma once

#include "results/sol_file.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// What RESULTS.h5 beside a classic file adds to it. The classic files alone are enough to plot and
/// to play; where the HDF5 file of the same run lies in their folder, its numbers are used.
namespace adore::results {

/// Replaces the values of a SOL1-SOL7 file by those of RESULTS.h5 in the same folder: all digits,
/// and numbers where the file shows stars. Columns without a channel, and steps that RESULTS.h5
/// does not hold, keep what they have.
/// Returns an empty text when values were replaced, else why the file was left as it is, for
/// example that there is no RESULTS.h5, or that it is of another run: its run code differs, or a
/// number beyond the digits that the classic file shows. Never throws for a bad RESULTS.h5.
[[nodiscard]] std::string use_full_precision(SolFile& file);

/// Contact of one rolling element with the two races (outer, inner).
struct ContactFrame {
  std::array<double, 2> load{};  ///< in `load_unit`
  std::array<double, 2> slip{};  ///< largest slip speed in the contact, in `slip_unit`
};

/// Contacts of all elements at the frames of a SOL8 file, and what that file lacks of the shape of
/// the pockets.
struct ContactFrames {
  std::string load_unit, slip_unit;
  std::vector<std::vector<ContactFrame>> frames;  ///< [frame][element]
  double largest_load = 0.0;                      ///< over all frames and elements
  int pocket_code = 0;                            ///< kPocType
  double roller_length = 0.0;                     ///< in the file's unit; 0 for balls
};

/// From RESULTS.h5 in the folder of a SOL8 file. Empty, with the reason in `why_not`, when there is
/// none, when it is of another run, or when it lacks one of the frames.
[[nodiscard]] std::optional<ContactFrames> contacts_beside(const Sol8File& file,
                                                           std::string& why_not);

}  // namespace adore::results
