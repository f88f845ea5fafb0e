#pragma once

#include "results/hdf5_handle.hpp"
#include "results/results_h5.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// RESULTS.h5 as the HDF5 library reads it, every size checked against the file's length and fixed
/// limits before it is used. The library itself crashes, loops and takes any amount of memory on
/// crafted bookkeeping, so only the process of h5_process.hpp opens files with this.
namespace adore::results::h5 {

/// Contents of a file except the numbers.
struct Content {
  std::string version, run_id;
  std::vector<H5Reader::ChannelInfo> channels;
  std::map<std::string, double> geometry;
  std::size_t steps = 0;
};

class File {
 public:
  /// @throws InputError when the file is none of ours or damaged: a clause without its name.
  explicit File(const std::filesystem::path& path);

  [[nodiscard]] const Content& content() const noexcept { return content_; }

  /// Values of one channel ("contact.load") or series ("time") of the steps first, first + every,
  /// ... @throws InputError
  [[nodiscard]] std::vector<double> read(const std::string& id, std::uint64_t first,
                                         std::uint64_t count, std::uint64_t every);

 private:
  struct Dataset {
    std::string path;
    std::vector<std::size_t> dimensions;  ///< behind the step
    std::uint64_t width = 1;              ///< values per step
    bool compressed = false;
  };
  void add_dataset(const std::string& path);
  void read_geometry();

  Handle file_;
  Content content_;
  std::map<std::string, Dataset> datasets_;  ///< by id
  Handle open_dataset_;                      ///< the dataset that was read last
  std::string open_channel_id_;
};

}  // namespace adore::results::h5
