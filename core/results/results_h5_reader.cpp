#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "results/h5_layout.hpp"
#include "results/h5_process.hpp"
#include "results/results_h5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// Reader of RESULTS.h5: requests of callers are checked here and read by a separate process.
namespace adore::results {

struct H5Reader::Impl {
  explicit Impl(const std::filesystem::path& file) : path(file), process(file) {}
  std::filesystem::path path;
  h5::ReaderProcess process;
};

std::size_t H5Reader::ChannelInfo::size() const {
  std::size_t size = 1;
  for (std::size_t dim : dimensions) size *= dim;
  return size;
}

H5Reader::H5Reader(const std::filesystem::path& path) {
  reject_special_file(path);
  if (!is_plain_file(path))
    throw InputError(
        fmt::format("{}: there is no such file; give the RESULTS.h5 of a run", path.string()));
  impl_ = std::make_unique<Impl>(path);
}

H5Reader::H5Reader(H5Reader&&) noexcept = default;
H5Reader& H5Reader::operator=(H5Reader&&) noexcept = default;
H5Reader::~H5Reader() = default;

const std::string& H5Reader::version() const noexcept { return impl_->process.content().version; }
const std::string& H5Reader::run_id() const noexcept { return impl_->process.content().run_id; }
const std::vector<H5Reader::ChannelInfo>& H5Reader::channels() const noexcept {
  return impl_->process.content().channels;
}
std::size_t H5Reader::steps() const noexcept { return impl_->process.content().steps; }
const std::map<std::string, double>& H5Reader::geometry() const noexcept {
  return impl_->process.content().geometry;
}

const H5Reader::ChannelInfo* H5Reader::find(std::string_view id) const noexcept {
  const auto found = std::find_if(channels().begin(), channels().end(),
                                  [&](const ChannelInfo& info) { return info.id == id; });
  return found == channels().end() ? nullptr : &*found;
}

std::vector<long> H5Reader::step_numbers() const {
  constexpr double kLargest = 9e15;  // whole numbers beyond run together
  std::vector<long> out;
  for (double number : read("step")) {
    const bool whole = std::abs(number) < kLargest && number == std::round(number);
    if (!whole || (!out.empty() && number < static_cast<double>(out.back())))
      throw InputError(fmt::format("{}: the file is damaged (invalid step number {} in row {})",
                                   impl_->path.string(), number, out.size() + 1));
    out.push_back(static_cast<long>(number));
  }
  return out;
}

std::vector<double> H5Reader::read(std::string_view id, std::size_t first, std::size_t count,
                                   std::size_t every) const {
  const bool series = std::any_of(h5::kSeries.begin(), h5::kSeries.end(),
                                  [&](const h5::StepSeries& s) { return s.name == id; });
  const ChannelInfo* info = find(id);
  if (info == nullptr && !series)
    throw InputError(fmt::format("{}: the file has no channel '{}'", impl_->path.string(), id));
  if (every == 0 ||
      (count > 0 && (first >= steps() || (count - 1) > (steps() - 1 - first) / every)))
    throw InputError(
        fmt::format("{}: the file does not contain {}, starting at stored step {} with interval "
                    "{}; number of stored steps: {}",
                    impl_->path.string(), counted(count, "step"), first + 1, every, steps()));
  return impl_->process.read(std::string(id), info == nullptr ? 1 : info->size(), first, count,
                             every);
}

}  // namespace adore::results
