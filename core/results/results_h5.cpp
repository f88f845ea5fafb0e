#include "results/results_h5.hpp"

#include "base/errors.hpp"
#include "base/version.hpp"
#include "base/word_checksum.hpp"
#include "base/write_error.hpp"
#include "base/write_folder.hpp"
#include "contact/groove.hpp"
#include "results/continuation.hpp"
#include "results/h5_driver.hpp"
#include "results/h5_layout.hpp"
#include "results/run_findings.hpp"
#include "results/sol_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <new>
#include <system_error>

namespace adore::results {
namespace {

using namespace h5;

constexpr int kFormat = 1;
constexpr std::size_t kMaxRank = 4;  ///< step, element, race, side
constexpr std::string_view kConventions =
    "SI units and radians, lives in hours. X is the bearing axis, Z points radially up. Azimuths "
    "are positive about +X and start at Z: y = -r sin(theta), z = r cos(theta). Frames: N = base, "
    "A = azimuth frame of the element (x axial, z radially outward), K = cage, P = pocket. "
    "Quaternions are w, x, y, z, from the body frame to the base frame. Order of races: outer, "
    "inner.";

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what) {
  throw WriteError(
      fmt::format("{}: {} ({}); check the folder, its permissions and the free disk space",
                  path.string(), what, h5::last_error()));
}

std::vector<hsize_t> dimensions(const Channel& channel, const Shape& shape) {
  const auto n = [](int value) { return static_cast<hsize_t>(value); };
  std::vector<hsize_t> out;
  switch (channel.per) {
    case Per::Run:
      break;
    case Per::Element:
      out = {n(shape.elements)};
      break;
    case Per::Contact:
      out = {n(shape.elements), 2};
      break;
    case Per::Second:
      out = {n(shape.split ? shape.elements : 0), 2};
      break;
    case Per::Flange:
      out = {n(shape.rollers ? shape.elements : 0), 2, 2};
      break;
    case Per::Pocket:
      out = {n(shape.elements + shape.last_halves), n(shape.pocket_surfaces)};
      break;
    case Per::Pair:
      out = {n(shape.pairs)};
      break;
    case Per::Cage:
      out = {n(shape.cages)};
      break;
    case Per::Land:
      out = {n(shape.cages), n(shape.lands)};
      break;
    case Per::Race:
      out = {2};
      break;
    case Per::Thermal:
      out = {n(shape.thermal ? 1 : 0)};
      break;
  }
  if (channel.components > 1) out.push_back(n(channel.components));
  return out;
}

std::string_view dimension_names(const Channel& channel) {
  const bool vector = channel.components > 1;
  switch (channel.per) {
    case Per::Run:
      return vector ? "step, component" : "step";
    case Per::Element:
      return vector ? "step, element, component" : "step, element";
    case Per::Contact:
    case Per::Second:
      return "step, element, race";
    case Per::Flange:
      return "step, element, race, side";
    case Per::Pocket:
      return "step, element, surface";
    case Per::Pair:
      return "step, element and the next";
    case Per::Cage:
      return vector ? "step, cage, component" : "step, cage";
    case Per::Land:
      return "step, cage, land";
    case Per::Race:
      return vector ? "step, race, component" : "step, race";
    case Per::Thermal:
      return "step, one";
  }
  return {};
}

void write_attribute(hid_t object, const std::string& name, std::string_view text) {
  const Handle type = string_datatype(text.size(), text);
  const Handle space(H5Screate(H5S_SCALAR));
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT));
  const std::string padded = text.empty() ? std::string(1, '\0') : std::string(text);
  H5Awrite(attribute, type, padded.data());
}

void write_attribute(hid_t object, const std::string& name, double value) {
  const Handle space(H5Screate(H5S_SCALAR));
  const Handle attribute(
      H5Acreate2(object, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT));
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
}

/// One dataset and the rows of its last chunk.
struct Series {
  Handle dataset;
  std::vector<hsize_t> dims;  ///< behind the step
  std::size_t width = 1;      ///< values per row
  int channel = -1;           ///< index into the run's table; -1: one of kSeries
  double* chunk = nullptr;    ///< rows of the last chunk; zeros after the last row at each write
  std::uint64_t sum = 0;      ///< checksum of its name and its values
};

/// Adds `count` rows from row `first` of each chunk to the checksums. One checksum waits for the
/// product of the word before, so one loop computes those of four datasets.
void add_to_sums(std::span<Series> all, std::size_t first, std::size_t count) {
  struct Lane {
    const double* at = nullptr;
    std::size_t left = 0;
    std::uint64_t* sum = nullptr;
  };
  std::array<Lane, 4> lanes;
  auto next = all.begin();
  while (true) {
    std::size_t words = std::numeric_limits<std::size_t>::max();
    for (Lane& lane : lanes) {
      if (lane.left == 0 && next != all.end()) {
        lane = {next->chunk + first * next->width, count * next->width, &next->sum};
        ++next;
      }
      words = std::min(words, lane.left);
    }
    if (words == 0) break;  // fewer than four are left
    std::array<std::uint64_t, 4> sums{*lanes[0].sum, *lanes[1].sum, *lanes[2].sum, *lanes[3].sum};
    for (std::size_t k = 0; k < words; ++k)
      for (std::size_t l = 0; l < 4; ++l)
        sums[l] = add_to_word_checksum(std::bit_cast<std::uint64_t>(lanes[l].at[k]), sums[l]);
    for (std::size_t l = 0; l < 4; ++l) {
      *lanes[l].sum = sums[l];
      lanes[l].at += words;
      lanes[l].left -= words;
    }
  }
  for (Lane& lane : lanes)
    if (lane.left > 0) *lane.sum = word_checksum_of_values({lane.at, lane.left}, *lane.sum);
}

}  // namespace

std::string_view coherent_unit(const UnitPair& unit) {
  if (&unit == &unit::kAngle) return "rad";
  if (&unit == &unit::kRotation) return "rad/s";
  if (&unit == &unit::kRotationRate) return "rad/s^2";
  demand(unit.si_factor == 1.0, "a channel has a unit that is not a coherent SI unit");
  return unit.si;
}

namespace {

/// @return x of the races' reference points at zero displacement
std::array<double, 2> add_balls(const bearing::BallGeometry& balls,
                                std::map<std::string, double>& out) {
  const std::array<double, 2> centre_x = contact::groove_geometry(balls).centre_x;
  out["contact_angle"] = balls.contact_angle;
  out["outer_groove_radius"] = balls.groove_factor[0] * balls.diameter;
  out["inner_groove_radius"] = balls.groove_factor[1] * balls.diameter;
  out["outer_shoulder_radius"] = balls.shoulder_diameter[0] / 2.0;
  out["inner_shoulder_radius"] = balls.shoulder_diameter[1] / 2.0;
  out["outer_race_centre_x"] = centre_x[0];
  out["inner_race_centre_x"] = centre_x[1];
  return centre_x;
}

std::array<double, 2> add_rollers(const bearing::Bearing& bearing,
                                  std::map<std::string, double>& out) {
  const bearing::RollerGeometry& rollers = *bearing.rollers();
  out["bearing_type"] = static_cast<double>(bearing.type);
  out["contact_angle"] = rollers.axis_angle;
  out["roller_length"] = rollers.length;
  out["roller_half_angle"] = rollers.half_angle;
  out["roller_mass_offset"] = bearing.roller_mass_offset;
  out["roller_crown_radius"] = rollers.crown_radius;
  out["roller_central_length"] =
      rollers.shape == bearing::RollerShape::Crowned ? rollers.central_length : 0.0;
  for (const auto& [side, end] : {std::pair{0U, "minus_x"}, {1U, "plus_x"}}) {
    out[fmt::format("roller_{}_corner_radius", end)] = rollers.corner_radius[side];
    out[fmt::format("roller_{}_end_radius", end)] = rollers.end_radius[side];  // 0: flat
  }
  out["outer_race_angle"] = rollers.race_angle[0];
  out["inner_race_angle"] = rollers.race_angle[1];
  out["outer_race_crown_radius"] = rollers.race_crown_radius[0];  // 0: none
  out["inner_race_crown_radius"] = rollers.race_crown_radius[1];
  for (const auto& [race, name] : {std::pair{0U, "outer"}, {1U, "inner"}})
    for (const auto& [side, end] : {std::pair{0U, "minus_x"}, {1U, "plus_x"}}) {
      const auto& flange = rollers.flange[race][side];
      if (!flange) continue;
      out[fmt::format("{}_flange_{}_height", name, end)] = flange->height;
      out[fmt::format("{}_flange_{}_layback", name, end)] = flange->layback;
    }
  return {};
}

}  // namespace

std::map<std::string, double> geometry_of(const bearing::Bearing& bearing) {
  std::map<std::string, double> out{{"elements", bearing.element_count()},
                                    {"outer_race_width", bearing.envelope.race_width[0]},
                                    {"inner_race_width", bearing.envelope.race_width[1]},
                                    {"cages", bearing.cage ? bearing.cage->segments.count : 0.0}};
  const std::array<double, 2> free_x =
      bearing.rollers() != nullptr ? add_rollers(bearing, out) : add_balls(bearing.balls(), out);
  out["outer_race_free_x"] = free_x[0];  // the race's center less its stored displacement
  out["inner_race_free_x"] = free_x[1];
  const Sol8Geometry g = make_sol8_geometry(bearing);
  for (const Sol8GeometryField& field : kSol8Geometry) out[field.name] = g.*field.value;
  if (!bearing.cage) return out;
  out["cage_width"] = bearing.cage->width;
  out["pocket_code"] = bearing::pocket_code(*bearing.cage, bearing.rollers() != nullptr);
  out["pocket_cone_angle"] = bearing.cage->cone_angle;
  for (std::size_t i = 0; i < bearing.cage->pocket_faces.size(); ++i) {  // record 7.3, at +y
    const bearing::RollerPocketFace& face = bearing.cage->pocket_faces[i];
    const std::string name = fmt::format("pocket_face{}_", i + 1);
    for (const auto& [axis, letter] : {std::pair{0, "x"}, {1, "y"}, {2, "z"}}) {
      out[name + letter] = face.centre[axis];
      out[name + "angle_" + letter] = face.angles[axis];
    }
    out[name + "width"] = face.width;
    out[name + "length"] = face.length;
  }
  if (bearing.cage->segments.count > 1)  // the element, from 1, of the first segment's first pocket
    out["first_pocket"] = shape_of(bearing).first_pocket + 1.0;
  out["lands"] = static_cast<double>(bearing.cage->lands.size());
  for (std::size_t i = 0; i < bearing.cage->lands.size(); ++i) {
    const bearing::GuideLand& land = bearing.cage->lands[i];
    const std::string name = fmt::format("land{}_", i + 1);
    out[name + "guide"] = static_cast<double>(land.guide);  // 0 none, 1 outer, 2 inner race
    out[name + "diameter"] = land.diameter;
    out[name + "width"] = land.width;
    out[name + "edge"] = land.edge;
    out[name + "clearance"] = land.clearance / 2.0;
  }
  return out;
}

struct H5Writer::Impl {
  explicit Impl(ChannelTable of_records) : table(std::move(of_records)) {}

  ChannelTable table;
  std::filesystem::path path;
  Shape shape;
  std::size_t rows = kBlock;   ///< of a chunk
  std::size_t block = kBlock;  ///< of a write
  std::chrono::steady_clock::time_point flushed = std::chrono::steady_clock::now();
  std::size_t written = 0, waiting = 0;  ///< rows
  struct Free {
    void operator()(double* memory) const noexcept { std::free(memory); }
  };
  std::unique_ptr<double, Free> chunks;  ///< of all datasets; zero pages cost nothing before use
  Handle file;
  std::vector<Series> series;
  bool broken = false;

  [[nodiscard]] std::span<const Channel> channels() const { return table.all(); }
  void set_block(int most) {
    double bytes = sizeof(double) * kSeries.size();
    for (const Channel& channel : channels())
      bytes += static_cast<double>(sizeof(double) * channel_size(channel, shape));
    rows = static_cast<std::size_t>(steps_per_block(bytes));
    block = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(most, 1)), 1, rows);
  }
  Series plan(int channel) const {
    Series made;
    made.channel = channel;
    if (channel >= 0) made.dims = dimensions(channels()[static_cast<std::size_t>(channel)], shape);
    demand(made.dims.size() < kMaxRank, "a channel has more dimensions than RESULTS.h5 allows");
    for (hsize_t size : made.dims) made.width *= size;
    if (channel >= 0) made.sum = checksum(channels()[static_cast<std::size_t>(channel)].id);
    return made;
  }
  /// The bytes of a file with every dataset and no step.
  std::string empty_file(const bearing::Bearing& bearing, const FindingsText& findings);
  /// Puts such a file there and opens it for growing.
  void open_empty(const WritePath& place, const bearing::Bearing& bearing,
                  const FindingsText& findings);

  /// Calls use(series, path, series name or channel) for every dataset that this bearing has; /step
  /// comes last, so that its length is the number of complete rows.
  template <class Use>
  void for_each(Use use) {
    for (std::size_t c = 0; c < channels().size(); ++c) {
      Series made = plan(static_cast<int>(c));
      if (made.width > 0) use(std::move(made), dataset_path(channels()[c].id));
    }
    for (auto name = kSeries.rbegin(); name != kSeries.rend(); ++name) {
      Series made = plan(-1);
      made.sum = checksum(name->name);
      use(std::move(made), dataset_path(name->name));
    }
  }

  /// @param creation list of properties, of which the chunk is set here: one list serves all
  void create_dataset(Series made, const std::string& name, const Handle& creation) {
    std::vector<hsize_t> size{0}, most{H5S_UNLIMITED}, chunk{rows};
    for (hsize_t dim : made.dims) {
      size.push_back(dim);
      most.push_back(dim);
      chunk.push_back(dim);
    }
    const int rank = static_cast<int>(size.size());
    const Handle space(H5Screate_simple(rank, size.data(), most.data()));
    H5Pset_chunk(creation, rank, chunk.data());
    made.dataset = Handle(
        H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
    if (!made.dataset.valid()) fail(path, "a dataset cannot be created");
    if (made.channel >= 0) {
      const Channel& channel = channels()[static_cast<std::size_t>(made.channel)];
      write_attribute(made.dataset, "id", channel.id);
      write_attribute(made.dataset, "label", channel.label);
      write_attribute(made.dataset, "unit", coherent_unit(*channel.unit));
      write_attribute(made.dataset, "frame", channel.frame);
      write_attribute(made.dataset, "description", channel.help);
      write_attribute(made.dataset, "dimensions", dimension_names(channel));
    } else {
      const auto found = std::find_if(kSeries.begin(), kSeries.end(), [&](const StepSeries& s) {
        return dataset_path(s.name) == name;
      });
      write_attribute(made.dataset, "unit", found->unit);
      write_attribute(made.dataset, "description", found->description);
      write_attribute(made.dataset, "dimensions", "step");
    }
    series.push_back(std::move(made));
  }

  [[nodiscard]] static Handle dataset_access() {
    Handle access(H5Pcreate(H5P_DATASET_ACCESS));
    H5Pset_chunk_cache(access, 1, 0, 1.0);  // whole chunks are written past the cache
    return access;
  }

  void make_chunks() {
    std::size_t width = 0;
    for (const Series& one : series) width += one.width;
    chunks.reset(static_cast<double*>(std::calloc(rows * width, sizeof(double))));
    if (!chunks) throw std::bad_alloc();
    double* next = chunks.get();
    for (Series& one : series) {
      one.chunk = next;
      next += rows * one.width;
    }
  }

  void create_groups() {
    const Handle creation(H5Pcreate(H5P_GROUP_CREATE));
    H5Pset_obj_track_times(creation, false);
    std::vector<std::string> made;
    const auto group = [&](const std::string& name) {
      if (std::find(made.begin(), made.end(), name) != made.end()) return;
      made.push_back(name);
      const Handle handle(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT));
      if (!handle.valid()) fail(path, "a group cannot be created");
    };
    for (const Channel& channel : channels())
      group(std::string(channel.id.substr(0, channel.id.find('.'))));
    group("geometry");
  }

  void start_single_writer() {
    if (H5Fstart_swmr_write(file) < 0) fail(path, "the file cannot be prepared for further steps");
  }

  void write_waiting() {
    if (waiting == 0) return;
    if (broken)
      throw InputError(fmt::format(
          "{}: no further steps can be stored after an earlier write error", path.string()));
    // A chunk that is not full is written again, as a whole and at the same place, with its next
    // rows. So the bytes do not depend on the times of the writes (decision 760).
    const std::size_t first = written % rows, filled = first + waiting;
    for (Series& one : series)
      std::fill(one.chunk + filled * one.width, one.chunk + rows * one.width, 0.0);
    const auto put = [&](Series& one) {
      std::array<hsize_t, kMaxRank> size{written + waiting}, offset{written - first};
      std::copy(one.dims.begin(), one.dims.end(), size.begin() + 1);
      return H5Dset_extent(one.dataset, size.data()) >= 0 &&
             H5Dwrite_chunk(one.dataset, H5P_DEFAULT, 0, offset.data(),
                            rows * one.width * sizeof(double), one.chunk) >= 0;
    };
    // Every other dataset is on its way to the disk before /step, written last, counts the rows.
    // The second flush gives back what the library holds ready for /step.
    bool ok = true;
    {
      const HeldWrites held(file);
      for (std::size_t k = 0; ok && k + 1 < series.size(); ++k) ok = put(series[k]);
    }
    ok = ok && write_error(file) == 0 && H5Fflush(file, H5F_SCOPE_LOCAL) >= 0 &&
         put(series.back()) && H5Dflush(series.back().dataset) >= 0 &&
         H5Fflush(file, H5F_SCOPE_LOCAL) >= 0;
    const int error = write_error(file);
    if (!ok || error != 0) {
      broken = true;  // /step, written last, counts the steps that are in all of them
      throw WriteError(fmt::format(
          "{}: writing to the file failed ({}); free some disk space or choose another disk",
          path.string(), error != 0 ? std::generic_category().message(error) : h5::last_error()));
    }
    add_to_sums(series, first, waiting);
    written += waiting;
    waiting = 0;
    flushed = std::chrono::steady_clock::now();
  }
};

int H5Writer::steps_per_block(double step_bytes) noexcept {
  constexpr double kBytes = 4.0 * 1024 * 1024;
  return std::clamp(static_cast<int>(kBytes / std::max(step_bytes, 1.0)), kLeastBlock, kBlock);
}

H5Writer::H5Writer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
H5Writer::H5Writer(H5Writer&&) noexcept = default;
H5Writer& H5Writer::operator=(H5Writer&&) noexcept = default;
H5Writer::~H5Writer() {
  if (!impl_) return;
  const Hdf5Lock quiet;
  try {
    if (!impl_->broken) flush();
  } catch (const std::exception&) {
    // Errors cannot be reported here; flush() reports them.
  }
  impl_->series.clear();
  impl_->file.reset();
}

std::string H5Writer::Impl::empty_file(const bearing::Bearing& bearing,
                                       const FindingsText& findings) {
  constexpr std::size_t kGrowth = 1 << 16;
  const Handle creation(H5Pcreate(H5P_FILE_CREATE)), access = file_access_properties();
  H5Pset_obj_track_times(creation, false);
  H5Pset_fapl_core(access, kGrowth, false);
  // With a unique name: the library treats files in memory with the same name as one file.
  const std::string alone = fmt::format("RESULTS.h5 in memory, {}", static_cast<const void*>(this));
  file = Handle(H5Fcreate(alone.c_str(), H5F_ACC_TRUNC, creation, access));
  if (!file.valid()) fail(path, "the file cannot be created");
  create_groups();
  {
    const Handle root(H5Gopen2(file, "/", H5P_DEFAULT));
    write_attribute(root, "program", std::string(kProgramVersion) + bearing.user_version);
    write_attribute(root, "format", static_cast<double>(kFormat));
    write_attribute(root, "run_id", bearing.run_id);
    write_attribute(root, "conventions", kConventions);
    write_attribute(root, FindingsText::kList, findings.list);
    write_attribute(root, FindingsText::kSum, findings.sum);
    const Handle geometry(H5Gopen2(file, "geometry", H5P_DEFAULT));
    for (const auto& [name, value] : geometry_of(bearing)) write_attribute(geometry, name, value);
  }
  const Handle datasets(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(datasets, false);  // the same run gives the same bytes
  for_each([&](Series made, const std::string& name) {
    create_dataset(std::move(made), name, datasets);
  });
  series.clear();
  H5Fflush(file, H5F_SCOPE_GLOBAL);
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  std::string bytes(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
  if (size <= 0 || H5Fget_file_image(file, bytes.data(), bytes.size()) < 0)
    fail(path, "the file cannot be created");
  file.reset();
  clear_open_mark(bytes);
  return bytes;
}

void H5Writer::Impl::open_empty(const WritePath& place, const bearing::Bearing& bearing,
                                const FindingsText& findings) {
  const std::string bytes = empty_file(bearing, findings);
  write_file_atomically(place, bytes);
  const Handle access = file_access_properties();
  use_safe_driver(access, place.folder());
  file = Handle(H5Fopen(place.name().c_str(), H5F_ACC_RDWR, access));
  if (!file.valid()) fail(path, "the file cannot be created");
  start_single_writer();  // opens again what is open, so it comes first
  const Handle past_cache = dataset_access();
  for_each([&](Series made, const std::string& dataset) {
    made.dataset = Handle(H5Dopen2(file, dataset.c_str(), past_cache));
    if (!made.dataset.valid()) fail(path, "a dataset cannot be created");
    series.push_back(std::move(made));
  });
  make_chunks();
}

H5Writer H5Writer::create(const WritePath& place, const bearing::Bearing& bearing,
                          const ChannelTable& table, int block, std::span<const Finding> findings) {
  const Hdf5Lock quiet;
  auto impl = std::make_unique<Impl>(table);
  impl->path = place.path();
  impl->shape = shape_of(bearing);
  impl->set_block(block);
  impl->open_empty(place, bearing, findings_text(findings));
  return H5Writer(std::move(impl));
}

namespace {

/// Throws unless the file belongs to this run and has a dataset of the right sizes for every
/// channel.
void check_file(const H5Reader& file, const std::filesystem::path& path,
                const bearing::Bearing& bearing, const ChannelTable& table) {
  check_run_id(path, file.run_id(), bearing.run_id);
  const Shape shape = shape_of(bearing);
  for (const Channel& channel : table.all()) {
    const std::vector<hsize_t> wanted = dimensions(channel, shape);
    if (channel_size(channel, shape) == 0) continue;
    const H5Reader::ChannelInfo* found = file.find(channel.id);
    if (found != nullptr && std::equal(wanted.begin(), wanted.end(), found->dimensions.begin(),
                                       found->dimensions.end()))
      continue;
    if (found == nullptr)
      throw InputError(fmt::format(
          "{}: the file does not contain the channel {}. An earlier version of Adore wrote the "
          "file, or the file is incomplete. The file can be displayed, but not continued. Start "
          "new files with kIcOpt = -1, or run the deck in another folder",
          path.string(), channel.id));
    throw InputError(
        fmt::format("{}: the size of the channel {} does not match this bearing. Restore the file "
                    "of this run, or start new files with kIcOpt = -1",
                    path.string(), channel.id));
  }
}

}  // namespace

void H5Writer::check(const std::filesystem::path& path, const bearing::Bearing& bearing,
                     const ChannelTable& table) {
  check_file(H5Reader(path), path, bearing, table);
}

std::filesystem::path H5Writer::unfinished_path(const std::filesystem::path& path) {
  return path.parent_path() / fmt::format(".{}.new", path.filename().string());
}

H5Writer H5Writer::continue_after(const WritePath& place, const bearing::Bearing& bearing,
                                  const ChannelTable& table, long last_step, int block,
                                  std::span<const Finding> findings) {
  const std::filesystem::path path = place.path();
  const H5Reader old(path);
  check_file(old, path, bearing, table);
  const std::vector<long> steps = old.step_numbers();
  const auto rows = static_cast<std::size_t>(
      std::upper_bound(steps.begin(), steps.end(), last_step) - steps.begin());
  const Hdf5Lock quiet;
  auto impl = std::make_unique<Impl>(table);
  impl->path = path;
  impl->shape = shape_of(bearing);
  impl->set_block(block);
  // A new file, and the steps that stay: the bytes are those of a run that was never interrupted,
  // and damage of the old file is found before it is given up.
  const std::string next = unfinished_path(place.name()).string();
  try {
    impl->open_empty({place.folder(), next}, bearing, findings_text(findings));
    while (impl->written < rows) {
      impl->waiting = std::min(rows - impl->written, impl->rows);
      std::size_t name = kSeries.size();
      for (Series& one : impl->series) {
        const std::string_view id = one.channel < 0
                                        ? kSeries[--name].name
                                        : table.all()[static_cast<std::size_t>(one.channel)].id;
        const std::vector<double> values = old.read(id, impl->written, impl->waiting);
        std::copy(values.begin(), values.end(), one.chunk);
      }
      impl->write_waiting();
    }
    check_writable_file(place);
    place.folder().rename(next, place.folder(), place.name());
  } catch (...) {
    place.folder().remove(next);
    throw;
  }
  return H5Writer(std::move(impl));
}

void H5Writer::write(const StepRecord& record) {
  demand(record.shape == impl_->shape && record.values.size() == impl_->channels().size(),
         "a record has other bodies or channels than the file RESULTS.h5");
  const std::array<double, 4> own{static_cast<double>(record.step), record.time, record.step_size,
                                  record.shaft_rotation};
  const std::size_t row = (impl_->written + impl_->waiting) % impl_->rows;
  std::size_t next = kSeries.size();
  for (const Series& one : impl_->series) {
    double* const to = one.chunk + row * one.width;
    if (one.channel < 0)
      *to = own[--next];
    else
      std::copy_n(record.values[static_cast<std::size_t>(one.channel)].data(), one.width, to);
  }
  ++impl_->waiting;
  constexpr std::chrono::seconds kFlushInterval{1};
  if (row + 1 == impl_->rows || impl_->waiting + impl_->written % impl_->block >= impl_->block ||
      std::chrono::steady_clock::now() - impl_->flushed >= kFlushInterval)
    flush();
}

std::uint64_t H5Writer::sum() const noexcept {
  std::uint64_t total = 0;
  for (const Series& one : impl_->series) total += one.sum;
  return total;
}

void H5Writer::flush() {
  const Hdf5Lock quiet;
  impl_->write_waiting();
}

void H5Writer::close() {
  const Hdf5Lock quiet;
  impl_->write_waiting();
  impl_->series.clear();
  H5Fflush(impl_->file, H5F_SCOPE_GLOBAL);
  if (const int error = write_error(impl_->file); error != 0) {
    impl_->broken = true;
    throw WriteError(
        fmt::format("{}: the end of the file cannot be written ({}); free some disk space or "
                    "choose another disk",
                    impl_->path.string(), std::generic_category().message(error)));
  }
  impl_->file.reset();
}

}  // namespace adore::results
