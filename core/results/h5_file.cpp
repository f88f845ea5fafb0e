#include "results/h5_file.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "results/h5_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace adore::results::h5 {
namespace {

/// Limits far above what any run writes.
constexpr int kMaxDimensions = 8;
constexpr std::size_t kMaxDatasets = 4096, kMaxAttributes = 4096;
constexpr std::uint64_t kMaxValuesPerStep = 50'000'000;
constexpr std::size_t kMaxTextLength = std::size_t{1} << 14;
constexpr unsigned kMaxReadAttempts = 20;  ///< a writer may be in the middle of a block
/// Deflate makes at most 1032 bytes of one.
constexpr std::uint64_t kLargestCompression = 1032;

[[noreturn]] void damaged(const std::string& what) {
  throw InputError(fmt::format("the file is damaged ({})", what));
}

/// No control characters, which would reach a terminal.
void clean(std::string& text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\x7f'; }, '?');
}

/// Fixed-length text of an attribute.
std::string read_text(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return {};
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT));
  const Handle type(H5Aget_type(attribute)), space(H5Aget_space(attribute));
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 ||
      H5Sget_simple_extent_npoints(space) != 1)
    damaged(fmt::format("the attribute {} is not a string", name));
  const std::size_t size = H5Tget_size(type);
  if (size > kMaxTextLength) damaged(fmt::format("the attribute {} has {} bytes", name, size));
  std::string text(size, '\0');
  if (H5Aread(attribute, type, text.data()) < 0) damaged(last_error());
  text.resize(std::min(text.find('\0'), text.size()));
  clean(text);
  return text;
}

/// Only data within this file, and only filters that are part of the library.
bool plainly_stored(const Handle& dataset, bool& compressed) {
  const Handle creation(H5Dget_create_plist(dataset));
  if (!creation.valid() || H5Pget_external_count(creation) != 0) return false;
  const H5D_layout_t layout = H5Pget_layout(creation);
  if (layout != H5D_CHUNKED && layout != H5D_CONTIGUOUS) return false;
  const int filters = H5Pget_nfilters(creation);
  if (filters < 0 || filters > 3) return false;
  compressed = false;
  for (int k = 0; k < filters; ++k) {
    unsigned flags = 0, configuration = 0;
    std::size_t none = 0;
    const H5Z_filter_t filter = H5Pget_filter2(creation, static_cast<unsigned>(k), &flags, &none,
                                               nullptr, 0, nullptr, &configuration);
    if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE &&
        filter != H5Z_FILTER_FLETCHER32)
      return false;
    compressed = compressed || filter == H5Z_FILTER_DEFLATE;
  }
  return true;
}

bool holds_doubles(const Handle& dataset) {
  const Handle type(H5Dget_type(dataset));
  return H5Tget_class(type) == H5T_FLOAT && H5Tget_size(type) == sizeof(double);
}

std::vector<hsize_t> extent(const Handle& dataset, const std::string& path) {
  const Handle space(H5Dget_space(dataset));
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 1 || rank > kMaxDimensions)
    damaged(fmt::format("{} has {}", path, counted(rank, "dimension")));
  std::vector<hsize_t> dims(static_cast<std::size_t>(rank));
  if (H5Sget_simple_extent_dims(space, dims.data(), nullptr) != rank) damaged(last_error());
  return dims;
}

/// Names of datasets in the root and in its groups. No deeper: in a damaged file groups hold each
/// other in circles.
struct Walk {
  std::string group;  ///< "contact/"; empty in the root
  std::vector<std::string> names;
  std::size_t links = 0;
};

herr_t add_link(hid_t group, const char* name, const H5L_info_t* link, void* data) {
  Walk& walk = *static_cast<Walk*>(data);
  if (++walk.links > kMaxDatasets) return -1;
  H5O_info_t info;
  if (link->type != H5L_TYPE_HARD) return 0;
  if (H5Oget_info_by_name2(group, name, &info, H5O_INFO_BASIC, H5P_DEFAULT) < 0) return -1;
  if (info.type == H5O_TYPE_DATASET) walk.names.push_back(walk.group + name);
  if (info.type != H5O_TYPE_GROUP || !walk.group.empty()) return 0;
  walk.group = std::string(name) + "/";
  const herr_t done = H5Literate_by_name(group, name, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr,
                                         add_link, data, H5P_DEFAULT);
  walk.group.clear();
  return done;
}

}  // namespace

File::File(const std::filesystem::path& path) {
  if (H5Fis_hdf5(path.c_str()) <= 0)
    throw InputError("this is not an HDF5 file, or it is damaged; give the RESULTS.h5 of a run");
  const Handle access = file_access_properties();
  H5Pset_metadata_read_attempts(access, kMaxReadAttempts);
  file_ = Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access));
  if (!file_.valid()) file_ = Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access));
  if (!file_.valid())
    throw InputError(fmt::format(
        "the file cannot be opened ({}); check its permissions, or restore it", last_error()));
  const Handle root(H5Gopen2(file_, "/", H5P_DEFAULT));
  content_.version = read_text(root, "program");
  content_.run_id = read_text(root, "run_id");
  if (H5Lexists(file_, "step", H5P_DEFAULT) <= 0 || content_.version.empty())
    throw InputError("this HDF5 file contains no bearing results; give the RESULTS.h5 of a run");

  Walk walk;
  if (H5Literate(file_, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add_link, &walk) < 0)
    damaged(last_error());
  content_.steps = std::numeric_limits<std::size_t>::max();
  for (const std::string& name : walk.names) add_dataset(name);
  for (const StepSeries& series : kSeries)
    if (datasets_.count(std::string(series.name)) == 0)
      damaged(fmt::format("/{} is missing", series.name));

  // All values together can be no more than the file has room for.
  const std::uint64_t size = std::filesystem::file_size(path);
  std::uint64_t taken = 0;
  for (const auto& [id, dataset] : datasets_) {
    std::uint64_t width = sizeof(double) * dataset.width;
    if (dataset.compressed) width = width / kLargestCompression + 1;
    if (content_.steps > (size - taken) / width)
      damaged(fmt::format("the file is too short for the {} that it lists",
                          counted(content_.steps, "step")));
    taken += content_.steps * width;
  }

  // The order of the table where we know it, by name behind.
  const auto place = [](const H5Reader::ChannelInfo& info) {
    const auto all = adore::results::channels();
    return std::find_if(all.begin(), all.end(), [&](const Channel& c) { return c.id == info.id; }) -
           all.begin();
  };
  std::stable_sort(content_.channels.begin(), content_.channels.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
  read_geometry();
}

void File::add_dataset(const std::string& path) {
  const Handle dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT));
  bool compressed = false;
  if (!dataset.valid()) damaged(last_error());
  if (!plainly_stored(dataset, compressed) || !holds_doubles(dataset))
    damaged(fmt::format("{} is not stored in the format of this program", path));
  const std::vector<hsize_t> dims = extent(dataset, path);
  content_.steps = std::min<std::size_t>(content_.steps, dims[0]);
  H5Reader::ChannelInfo info;
  Dataset made{path, {}, 1, compressed};
  for (std::size_t k = 1; k < dims.size(); ++k) {
    if (dims[k] == 0 || dims[k] > kMaxValuesPerStep / made.width)
      damaged(fmt::format("{} has a size of {}", path, dims[k]));
    made.width *= dims[k];
    made.dimensions.push_back(dims[k]);
  }
  info.dimensions = made.dimensions;
  info.id = read_text(dataset, "id");
  // The series have no separate id.
  const std::string id = info.id.empty() ? path : info.id;
  if (!datasets_.emplace(id, std::move(made)).second) damaged(fmt::format("{} occurs twice", id));
  if (info.id.empty()) {
    const bool series = std::any_of(kSeries.begin(), kSeries.end(),
                                    [&](const StepSeries& s) { return s.name == path; });
    if (!series || dims.size() != 1) damaged(fmt::format("{} is not a channel", path));
    return;
  }
  info.label = read_text(dataset, "label");
  info.unit = read_text(dataset, "unit");
  info.frame = read_text(dataset, "frame");
  info.description = read_text(dataset, "description");
  content_.channels.push_back(std::move(info));
}

void File::read_geometry() {
  if (H5Lexists(file_, "geometry", H5P_DEFAULT) <= 0) return;
  const Handle group(H5Gopen2(file_, "geometry", H5P_DEFAULT));
  const herr_t done = H5Aiterate2(
      group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr,
      [](hid_t object, const char* name, const H5A_info_t*, void* data) -> herr_t {
        auto& geometry = *static_cast<std::map<std::string, double>*>(data);
        const Handle attribute(H5Aopen(object, name, H5P_DEFAULT));
        const Handle space(H5Aget_space(attribute)), type(H5Aget_type(attribute));
        double value = 0.0;
        if (H5Sget_simple_extent_npoints(space) != 1 || H5Tget_class(type) != H5T_FLOAT ||
            H5Tget_size(type) != sizeof(double) ||
            H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
          return -1;
        std::string key(name);
        clean(key);
        geometry[key] = value;
        return geometry.size() > kMaxAttributes ? -1 : 0;
      },
      &content_.geometry);
  if (done < 0) damaged("the bearing geometry cannot be read");
}

std::vector<double> File::read(const std::string& id, std::uint64_t first, std::uint64_t count,
                               std::uint64_t every) {
  const auto found = datasets_.find(id);
  if (found == datasets_.end()) throw InputError(fmt::format("the file has no channel '{}'", id));
  std::vector<hsize_t> start{first}, stride{every}, size{count};
  for (std::size_t dim : found->second.dimensions) {
    start.push_back(0);
    stride.push_back(1);
    size.push_back(dim);
  }
  std::vector<double> values(count * found->second.width);
  if (values.empty()) return values;
  if (open_channel_id_ != id) {
    open_dataset_ = Handle(H5Dopen2(file_, found->second.path.c_str(), H5P_DEFAULT));
    open_channel_id_ = id;
  }
  const Handle source(H5Dget_space(open_dataset_));
  const Handle target(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr));
  if (H5Sget_simple_extent_ndims(source) != static_cast<int>(size.size()) ||
      H5Sselect_hyperslab(source, H5S_SELECT_SET, start.data(), stride.data(), size.data(),
                          nullptr) < 0 ||
      H5Dread(open_dataset_, H5T_NATIVE_DOUBLE, target, source, H5P_DEFAULT, values.data()) < 0)
    throw InputError(
        fmt::format("channel '{}' cannot be read ({}); the file is damaged", id, last_error()));
  return values;
}

}  // namespace adore::results::h5
