#include "base/errors.hpp"
#include "results/h5_layout.hpp"
#include "results/results_h5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

/// Reader of RESULTS.h5.
namespace adore::results {
namespace {

using namespace h5;

std::size_t rows_of(const Handle& dataset) {
  const Handle space(H5Dget_space(dataset));
  std::array<hsize_t, 8> dims{};
  if (H5Sget_simple_extent_ndims(space) > 8 ||
      H5Sget_simple_extent_dims(space, dims.data(), nullptr) < 1)
    return 0;
  return dims[0];
}

std::string read_text(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return {};
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT));
  const Handle type(H5Aget_type(attribute));
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) return {};
  const std::size_t size = H5Tget_size(type);
  if (size > (1U << 20)) return {};
  std::string text(size, '\0');
  if (H5Aread(attribute, type, text.data()) < 0) return {};
  return text.substr(0, text.find('\0'));
}

}  // namespace

struct H5Reader::Impl {
  std::filesystem::path path;
  Handle file;
  std::string version, run_id;
  std::vector<ChannelInfo> channels;
  std::map<std::string, double> geometry;
  std::size_t steps = 0;

  [[nodiscard]] ChannelInfo describe(const std::string& name) const {
    const Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT));
    ChannelInfo info;
    if (!dataset.valid()) return info;
    info.id = read_text(dataset, "id");
    info.label = read_text(dataset, "label");
    info.unit = read_text(dataset, "unit");
    info.frame = read_text(dataset, "frame");
    info.description = read_text(dataset, "description");
    const Handle space(H5Dget_space(dataset));
    std::array<hsize_t, 8> dims{};
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank >= 1 && rank <= 8) H5Sget_simple_extent_dims(space, dims.data(), nullptr);
    for (int k = 1; k < rank && rank <= 8; ++k)
      info.dimensions.push_back(dims[static_cast<std::size_t>(k)]);
    return info;
  }
};

std::size_t H5Reader::ChannelInfo::size() const {
  std::size_t size = 1;
  for (std::size_t dim : dimensions) size *= dim;
  return size;
}

H5Reader::H5Reader(const std::filesystem::path& path) : impl_(std::make_unique<Impl>()) {
  const Quiet quiet;
  impl_->path = path;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    throw InputError(
        fmt::format("{}: there is no such file; give the RESULTS.h5 of a run", path.string()));
  if (H5Fis_hdf5(path.c_str()) <= 0)
    throw InputError(fmt::format(
        "{}: this is no HDF5 file, or a damaged one; give the RESULTS.h5 of a run", path.string()));
  const Handle access = access_list();
  // A damaged file must not be tried for ever, as if a writer were about to mend it.
  H5Pset_metadata_read_attempts(access, 20);
  impl_->file = Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access));
  if (!impl_->file.valid()) impl_->file = Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access));
  if (!impl_->file.valid())
    throw InputError(fmt::format("{}: the file cannot be opened ({}); check its permissions",
                                 path.string(), h5::last_error()));
  const Handle root(H5Gopen2(impl_->file, "/", H5P_DEFAULT));
  impl_->version = read_text(root, "program");
  impl_->run_id = read_text(root, "run_id");
  if (H5Lexists(impl_->file, "step", H5P_DEFAULT) <= 0 || impl_->version.empty())
    throw InputError(
        fmt::format("{}: this HDF5 file holds no bearing results; give the RESULTS.h5 of a run",
                    path.string()));

  std::vector<std::string> names;
  H5Ovisit2(
      impl_->file, H5_INDEX_NAME, H5_ITER_NATIVE,
      [](hid_t, const char* name, const H5O_info_t* info, void* data) -> herr_t {
        if (info->type == H5O_TYPE_DATASET)
          static_cast<std::vector<std::string>*>(data)->emplace_back(name);
        return 0;
      },
      &names, H5O_INFO_BASIC);
  impl_->steps = std::numeric_limits<std::size_t>::max();
  for (const std::string& name : names) {
    ChannelInfo info = impl_->describe(name);
    const Handle dataset(H5Dopen2(impl_->file, name.c_str(), H5P_DEFAULT));
    impl_->steps = std::min(impl_->steps, rows_of(dataset));
    if (!info.id.empty()) impl_->channels.push_back(std::move(info));
  }
  // The order of the table where we know it, by name behind.
  const auto place = [](const ChannelInfo& info) {
    const auto all = adore::results::channels();
    return std::find_if(all.begin(), all.end(), [&](const Channel& c) { return c.id == info.id; }) -
           all.begin();
  };
  std::stable_sort(impl_->channels.begin(), impl_->channels.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });

  if (H5Lexists(impl_->file, "geometry", H5P_DEFAULT) > 0) {
    const Handle group(H5Gopen2(impl_->file, "geometry", H5P_DEFAULT));
    H5Aiterate2(
        group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr,
        [](hid_t object, const char* name, const H5A_info_t*, void* data) -> herr_t {
          const Handle attribute(H5Aopen(object, name, H5P_DEFAULT));
          const Handle space(H5Aget_space(attribute));
          double value = 0.0;
          if (H5Sget_simple_extent_npoints(space) == 1 &&
              H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) >= 0)
            (*static_cast<std::map<std::string, double>*>(data))[name] = value;
          return 0;
        },
        &impl_->geometry);
  }
}

H5Reader::H5Reader(H5Reader&&) noexcept = default;
H5Reader& H5Reader::operator=(H5Reader&&) noexcept = default;
H5Reader::~H5Reader() = default;

const std::string& H5Reader::version() const noexcept { return impl_->version; }
const std::string& H5Reader::run_id() const noexcept { return impl_->run_id; }
const std::vector<H5Reader::ChannelInfo>& H5Reader::channels() const noexcept {
  return impl_->channels;
}
std::size_t H5Reader::steps() const noexcept { return impl_->steps; }
const std::map<std::string, double>& H5Reader::geometry() const noexcept { return impl_->geometry; }

const H5Reader::ChannelInfo* H5Reader::find(std::string_view id) const noexcept {
  const auto found = std::find_if(impl_->channels.begin(), impl_->channels.end(),
                                  [&](const ChannelInfo& info) { return info.id == id; });
  return found == impl_->channels.end() ? nullptr : &*found;
}

std::vector<long> H5Reader::step_numbers() const {
  std::vector<long> out;
  for (double number : read("step")) out.push_back(static_cast<long>(number));
  return out;
}

std::vector<double> H5Reader::read(std::string_view id, std::size_t first, std::size_t count,
                                   std::size_t every) const {
  const Quiet quiet;
  const bool series = std::any_of(kSeries.begin(), kSeries.end(),
                                  [&](const StepSeries& s) { return s.name == id; });
  const ChannelInfo* info = find(id);
  if (info == nullptr && !series)
    throw InputError(fmt::format("{}: the file has no channel '{}'", impl_->path.string(), id));
  if (every == 0 ||
      (count > 0 && (first >= impl_->steps || (count - 1) > (impl_->steps - 1 - first) / every)))
    throw InputError(
        fmt::format("{}: {} steps from {} on, every {}, are asked for, but the file has {}",
                    impl_->path.string(), count, first + 1, every, impl_->steps));
  std::vector<hsize_t> start{first}, stride{every}, size{count};
  std::size_t width = 1;
  if (info != nullptr) {
    for (std::size_t dim : info->dimensions) {
      start.push_back(0);
      stride.push_back(1);
      size.push_back(dim);
    }
    width = info->size();
  }
  std::vector<double> values(count * width);
  if (values.empty()) return values;
  const Handle dataset(H5Dopen2(impl_->file, dataset_path(id).c_str(), H5P_DEFAULT));
  const Handle source(H5Dget_space(dataset));
  const Handle target(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr));
  if (H5Sget_simple_extent_ndims(source) != static_cast<int>(size.size()) ||
      H5Sselect_hyperslab(source, H5S_SELECT_SET, start.data(), stride.data(), size.data(),
                          nullptr) < 0 ||
      H5Dread(dataset, H5T_NATIVE_DOUBLE, target, source, H5P_DEFAULT, values.data()) < 0)
    throw InputError(fmt::format("{}: channel '{}' cannot be read ({}); the file is damaged",
                                 impl_->path.string(), id, h5::last_error()));
  return values;
}

}  // namespace adore::results
