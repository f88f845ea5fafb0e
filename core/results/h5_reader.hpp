#pragma once

#include "results/quantities.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Reading RESULTS.h5; what is in it: results_h5.hpp.
namespace adore::results {

/// Reads RESULTS.h5, also while it grows and after its writer was killed. A separate process
/// reads it (h5_process.hpp), so that a damaged or crafted file causes a message, not a crash.
class H5Reader {
 public:
  /// @throws InputError when the file is missing, none of ours or damaged.
  explicit H5Reader(const std::filesystem::path& path);
  H5Reader(H5Reader&&) noexcept;
  H5Reader& operator=(H5Reader&&) noexcept;
  ~H5Reader();

  struct ChannelInfo {
    std::string id, label, unit, frame, description;
    std::vector<std::size_t> dimensions;     ///< behind the step: {elements, 2} for contacts ...
    [[nodiscard]] std::size_t size() const;  ///< values per step
  };
  [[nodiscard]] const std::string& version() const noexcept;
  [[nodiscard]] const std::string& run_id() const noexcept;
  [[nodiscard]] const std::vector<ChannelInfo>& channels() const noexcept;
  /// nullptr when the file has no such channel (no cage ...).
  [[nodiscard]] const ChannelInfo* find(std::string_view id) const noexcept;
  /// Complete steps in the file when it was opened.
  [[nodiscard]] std::size_t steps() const noexcept;
  [[nodiscard]] std::vector<long> step_numbers() const;
  /// Values of the steps first, first + every, ... (`count` of them), step by step. Also for
  /// "time", "step_size" and "shaft_rotation". @throws InputError for an unknown channel or steps
  /// beyond the end.
  [[nodiscard]] std::vector<double> read(std::string_view id, std::size_t first, std::size_t count,
                                         std::size_t every = 1) const;
  /// All steps.
  [[nodiscard]] std::vector<double> read(std::string_view id) const { return read(id, 0, steps()); }
  /// Attributes of /geometry, SI.
  [[nodiscard]] const std::map<std::string, double>& geometry() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Name of a unit pair's coherent SI unit: "rad" for deg, "rad/s" for rpm ...
[[nodiscard]] std::string_view coherent_unit(const UnitPair& unit);

}  // namespace adore::results
