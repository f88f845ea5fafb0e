#include "base/version.hpp"
#include "base/write_error.hpp"
#include "results/hdf5_handle.hpp"
#include "runs/solver_stamp.hpp"
#include "studies/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

/// Made in memory and written like every small file: whole or not at all. No date is stored, so
/// that equal tables are equal bytes.
namespace adore::studies {
namespace {

using results::h5::Handle;

class TableWriter {
 public:
  explicit TableWriter(const std::filesystem::path& path) : path_(path) {
    const Handle access(H5Pcreate(H5P_FILE_ACCESS));
    constexpr std::size_t kGrowth = std::size_t{1} << 20;
    H5Pset_fapl_core(access, kGrowth, 0);
    // The name is not used: nothing goes to the disk.
    file_ = Handle(checked(H5Fcreate("study", H5F_ACC_TRUNC, H5P_DEFAULT, access)));
    plain_ = Handle(H5Pcreate(H5P_DATASET_CREATE));
    H5Pset_obj_track_times(plain_, 0);
    links_ = Handle(H5Pcreate(H5P_LINK_CREATE));
    H5Pset_create_intermediate_group(links_, 1);
  }

  void attribute(hid_t object, const char* name, const std::string& text) const {
    const Handle type = results::h5::string_datatype(text.size(), text);
    const Handle space(H5Screate(H5S_SCALAR));
    const Handle attribute(
        checked(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT)));
    std::string padded = text;
    padded.resize(std::max<std::size_t>(text.size(), 1));
    check(H5Awrite(attribute, type, padded.data()));
  }
  void attribute(const char* name, const std::string& text) const { attribute(file_, name, text); }

  void numbers(const std::string& name, const std::string& unit,
               const std::vector<double>& values) const {
    const Handle set = dataset(name, H5T_IEEE_F64LE, values.size());
    if (!values.empty())
      check(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    if (!unit.empty()) attribute(set, "unit", unit);
  }

  void whole(const std::string& name, const std::vector<long>& values) const {
    const Handle set = dataset(name, H5T_STD_I64LE, values.size());
    if (!values.empty())
      check(H5Dwrite(set, H5T_NATIVE_LONG, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  }

  /// Of one length, padded: every HDF5 program reads that.
  void texts(const std::string& name, const std::vector<std::string>& values) const {
    std::size_t width = 1;
    for (const std::string& value : values) width = std::max(width, value.size());
    std::string all(width * values.size(), '\0');
    for (std::size_t i = 0; i < values.size(); ++i)
      std::copy(values[i].begin(), values[i].end(), all.begin() + static_cast<long>(i * width));
    const Handle type = results::h5::string_datatype(width, all);
    const Handle set = dataset(name, type, values.size());
    if (!values.empty()) check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data()));
  }

  [[nodiscard]] std::string bytes() const {
    check(H5Fflush(file_, H5F_SCOPE_GLOBAL));
    const ssize_t size = H5Fget_file_image(file_, nullptr, 0);
    if (size <= 0) fail();
    std::string out(static_cast<std::size_t>(size), '\0');
    if (H5Fget_file_image(file_, out.data(), out.size()) != size) fail();
    return out;
  }

 private:
  [[noreturn]] void fail() const {
    throw WriteError(fmt::format("{}: the table cannot be created ({})", path_.string(),
                                 results::h5::last_error()));
  }
  void check(herr_t result) const {
    if (result < 0) fail();
  }
  [[nodiscard]] hid_t checked(hid_t id) const {
    if (id < 0) fail();
    return id;
  }
  [[nodiscard]] Handle dataset(const std::string& name, hid_t type, std::size_t rows) const {
    const std::array<hsize_t, 1> size{rows};
    const Handle space(H5Screate_simple(1, size.data(), nullptr));
    return Handle(
        checked(H5Dcreate2(file_, name.c_str(), type, space, links_, plain_, H5P_DEFAULT)));
  }

  std::filesystem::path path_;
  Handle file_, plain_, links_;
};

}  // namespace

std::string table_h5(const StudyTable& table, const std::string& kind,
                     const std::filesystem::path& path) {
  const results::h5::Hdf5Lock quiet;
  const TableWriter file(path);
  file.attribute("program", std::string(kProgramVersion));
  file.attribute("solver", std::string(runs::solver_stamp()));
  file.attribute("study", kind);
  file.attribute("conventions",
                 "every dataset has one row per run; variables are in the units of the deck, "
                 "quantities in SI units; values of the dataset \"exit\": 0 done, 1 crashed, 2 "
                 "input rejected, 3 failed, -1 not finished");
  file.whole("run", table.run);
  file.whole("exit", table.exit);
  for (const TableColumn& column : table.variables)
    file.numbers("variables/" + column.name, column.unit, column.values);
  for (const TableColumn& column : table.quantities)
    file.numbers("quantities/" + column.name, column.unit, column.values);
  if (!table.deck.empty()) file.texts("deck", table.deck);
  if (!table.label.empty()) file.texts("case", table.label);
  file.texts("message", table.message);
  return file.bytes();
}

}  // namespace adore::studies
