#pragma once

#include "results/h5_reader.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// Values of a run with motion at one of its stored steps, from RESULTS.h5. No Qt.
namespace adore::adrinput {

class RunMotionValues {
 public:
  /// @throws InputError for a file that is missing, damaged, or without a stored step
  explicit RunMotionValues(const std::filesystem::path& results_h5);

  [[nodiscard]] const std::vector<double>& times() const noexcept { return times_; }  ///< [s]
  [[nodiscard]] std::size_t step_at(double time) const;  ///< nearest stored step
  [[nodiscard]] int elements() const noexcept { return elements_; }
  /// "Step 40 (12.35 ms, 2.058 revolutions)."
  [[nodiscard]] std::string position(std::size_t step) const;
  /// Sentences: values of a rolling element (from 1), largest values of all, speeds, power loss.
  [[nodiscard]] std::vector<std::string> describe(std::size_t step, int element) const;

 private:
  [[nodiscard]] std::vector<double> values(const char* channel, std::size_t step) const;
  [[nodiscard]] std::string describe_element(std::size_t step, int element) const;
  [[nodiscard]] std::string describe_largest(std::size_t step) const;
  [[nodiscard]] std::string describe_bearing(std::size_t step) const;

  results::H5Reader reader_;
  std::vector<double> times_, turns_;
  std::vector<long> numbers_;
  int elements_ = 0;
};

}  // namespace adore::adrinput
