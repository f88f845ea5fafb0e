#pragma once

#include "base/finding.hpp"
#include "base/write_folder.hpp"
#include "bearing/bearing.hpp"
#include "results/channels.hpp"
#include "results/h5_reader.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// RESULTS.h5: every channel at full precision, SI and radians, self-describing.
///
/// One extendible dataset per channel, named after it: "contact.load" is /contact/load with
/// dimensions [step][element][race]; its attributes tell label, unit, frame, meaning and
/// dimensions. /step, /time, /step_size and /shaft_rotation hold one value per stored step.
/// /geometry has the sizes a picture needs as attributes [m], and outer_race_free_x,
/// inner_race_free_x: where a race's center stands when its stored displacement is zero. The file
/// is written in HDF5's single-writer mode: it can be read while it grows, and any HDF5 program
/// opens it after the writer was killed or the disk was full; the last block may then be longer in
/// some datasets than in /step, which is written last.
namespace adore::results {

class H5Writer {
 public:
  /// Steps that are collected before they go to the file as one block, which is also the chunk of
  /// its datasets: as many as 4 MB hold, 64 to 256.
  static constexpr int kLeastBlock = 64, kBlock = 256;
  [[nodiscard]] static int steps_per_block(double step_bytes) noexcept;

  /// A new file, replacing what was there; `table` is that of the records. `block` at most;
  /// smaller blocks lose less when the process is killed. A block that has waited for a second
  /// goes to the file with the next step although it is not full.
  /// @param findings of the run before its first step
  /// @throws InputError when it cannot be written.
  static H5Writer create(const WritePath& place, const bearing::Bearing& bearing,
                         const ChannelTable& table, int block = kBlock,
                         std::span<const Finding> findings = {});
  /// Continues a file: checks run code and sizes, copies the steps <= `last_step` into a
  /// new file, which replaces the old one when complete.
  /// @throws InputError with the mismatch or read error; the old file is unchanged.
  static H5Writer continue_after(const WritePath& place, const bearing::Bearing& bearing,
                                 const ChannelTable& table, long last_step, int block = kBlock,
                                 std::span<const Finding> findings = {});

  /// Path of the new file of continue_after(): left behind if the process is killed there.
  [[nodiscard]] static std::filesystem::path unfinished_path(const std::filesystem::path& path);

  /// The checks of continue_after() alone; nothing is touched. @throws InputError
  static void check(const std::filesystem::path& path, const bearing::Bearing& bearing,
                    const ChannelTable& table);

  H5Writer(H5Writer&&) noexcept;
  H5Writer& operator=(H5Writer&&) noexcept;
  ~H5Writer();  ///< closes; errors are lost here, so call close() at the end of a run

  void write(const StepRecord& record);
  /// Hands everything so far to the system. @throws InputError (disk full ...)
  void flush();
  /// Checksum of the values of all steps that the file has (file_sums.hpp).
  [[nodiscard]] std::uint64_t sum() const noexcept;
  /// Writes what waits and closes the file: its bytes are final. Nothing can be written any more.
  void close();

 private:
  struct Impl;
  explicit H5Writer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Content of /geometry: SOL8's twelve values and additional ones (widths, angles, pocket
/// shape).
[[nodiscard]] std::map<std::string, double> geometry_of(const bearing::Bearing& bearing);

}  // namespace adore::results
