#include "bindings.hpp"
#include "results/convert.hpp"
#include "results/h5_reader.hpp"
#include "results/table.hpp"

#include <filesystem>
#include <limits>

/// Readers of the files of a run.
namespace adore::python {
namespace {

using results::H5Reader;

/// The whole of a step-by-step file as one array.
py::tuple read_table(const std::string& path) {
  results::ResultTable table;
  std::vector<double> values;
  std::size_t rows = 0;
  {
    const py::gil_scoped_release release;
    table = results::file_kind(path) == results::FileKind::ResultsH5
                ? results::results_h5_table(path)
                : results::sol_table(path);
    for (std::vector<double> row; table.next(row); ++rows)
      values.insert(values.end(), row.begin(), row.end());
  }
  py::list columns;
  for (const results::TableColumn& column : table.columns)
    columns.append(py::make_tuple(column.id, column.label, column.unit));
  const auto count = static_cast<py::ssize_t>(table.columns.size());
  return py::make_tuple(table.header, columns,
                        to_array(std::move(values), {static_cast<py::ssize_t>(rows), count}),
                        table.note());
}

py::array read_channel(const H5Reader& reader, const std::string& id, std::size_t first,
                       std::optional<std::size_t> count, std::size_t every) {
  if (every == 0) throw InputError("every = 0: the interval of steps must be at least 1");
  const H5Reader::ChannelInfo* info = reader.find(id);
  const std::size_t steps = reader.steps();
  const std::size_t room = first < steps ? (steps - first + every - 1) / every : 0;
  const std::size_t wanted = count.value_or(room);
  std::vector<double> values;
  {
    const py::gil_scoped_release release;
    values = reader.read(id, first, wanted, every);
  }
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(wanted)};
  if (info != nullptr)
    for (const std::size_t n : info->dimensions) shape.push_back(static_cast<py::ssize_t>(n));
  return to_array(std::move(values), shape);
}

}  // namespace

void bind_results(py::module_& module) {
  using Info = H5Reader::ChannelInfo;
  py::class_<Info>(module, "ChannelInfo", "Description of a channel of RESULTS.h5.")
      .def_readonly("id", &Info::id, "Name of the channel, e.g. \"contact.load\".")
      .def_readonly("label", &Info::label, "Label for axes, e.g. \"contact load\".")
      .def_readonly("unit", &Info::unit, "SI unit (angles in rad).")
      .def_readonly("frame", &Info::frame, "Frame of vectors: N base, A azimuth, K cage, P pocket.")
      .def_readonly("description", &Info::description, "Meaning of the channel.")
      .def_readonly("dimensions", &Info::dimensions,
                    "Dimensions of the values of one step, e.g. [elements, races].")
      .def("__repr__", [](const Info& info) {
        return "<channel " + info.id + " [" + info.unit + "]: " + info.label + ">";
      });

  py::class_<H5Reader>(module, "H5Reader", "A RESULTS.h5, also while a run writes it.")
      .def(py::init([](const std::string& path) {
             const py::gil_scoped_release release;
             return std::make_unique<H5Reader>(std::filesystem::path(path));
           }),
           py::arg("path"))
      .def_property_readonly("version", &H5Reader::version, "Program that wrote the file.")
      .def_property_readonly("run_id", &H5Reader::run_id, "Title of the run.")
      .def_property_readonly("steps", &H5Reader::steps,
                             "Number of complete steps when the file was opened.")
      .def_property_readonly("channels", &H5Reader::channels, "All channels.")
      .def_property_readonly("geometry", &H5Reader::geometry, "Dimensions of the bearing [m].")
      .def(
          "step_numbers", [](const H5Reader& reader) { return reader.step_numbers(); },
          "Numbers of the stored steps.")
      .def("read", &read_channel, py::arg("id"), py::arg("first"), py::arg("count"),
           py::arg("every"),
           "Values of a channel, or of \"time\", \"step_size\" or \"shaft_rotation\", step by "
           "step.");

  module.def(
      "read_table", &read_table, py::arg("path"),
      "A SOL1-SOL8 or RESULTS.h5 as header, columns, array and a note if the file is damaged.");
  module.def(
      "describe_file", [](const std::string& path) { return results::describe_file(path); },
      py::arg("path"), "Type of a file, its header and the range of each channel.");
}

}  // namespace adore::python
