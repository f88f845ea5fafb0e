#include "base/finding.hpp"
#include "base/json_text.hpp"
#include "base/version.hpp"
#include "bindings.hpp"
#include "calculators/calculator_description.hpp"
#include "calculators/calculators.hpp"
#include "results/run_findings.hpp"
#include "routines.hpp"
#include "runs/option_file.hpp"
#include "runs/output_folder.hpp"
#include "runs/reproducible.hpp"

namespace adore::python {
namespace {

/// The classes are written in Python (adore/errors.py): raises one of them.
void raise(const char* name, const char* text, const std::vector<Issue>& issues = {}) {
  const py::object kind = py::module_::import("adore.errors").attr(name);
  PyErr_SetObject(kind.ptr(), kind(text, issues).ptr());
}

void translate(std::exception_ptr error) {
  if (!error) return;
  try {
    std::rethrow_exception(error);
  } catch (const runs::ResultsExist& e) {
    raise("ResultsExistError", e.what(), e.issues());
  } catch (const InputError& e) {
    raise("InputError", e.what(), e.issues());
  } catch (const SolverError& e) {
    raise("SolverError", e.what());
  } catch (const Interrupted& e) {
    raise("Interrupted", e.what());
  } catch (const InternalError& e) {
    raise("InternalError", e.what());
  }
}

std::string severity(const Issue& issue) {
  return issue.severity == Severity::Error     ? "error"
         : issue.severity == Severity::Warning ? "warning"
                                               : "note";
}

void bind_calculators(py::module_& module) {
  module.def(
      "calculator_list",
      [] {
        py::list out;
        for (const calculators::CalculatorInfo& info : calculators::calculator_list())
          out.append(py::make_tuple(info.name, info.help));
        return out;
      },
      "Name and purpose of every component calculator.");
  const auto find = [](const std::string& name) -> const calculators::CalculatorInfo& {
    for (const calculators::CalculatorInfo& info : calculators::calculator_list())
      if (info.name == name) return info;
    throw InputError("there is no calculator named \"" + name +
                     "\"; dir(adore.calc) lists all calculators");
  };
  module.def(
      "describe_calculator",
      [find](const std::string& name) { return calculators::describe_calculator_text(find(name)); },
      py::arg("name"), "Inputs and results of a calculator with units, and an example, as text.");
  module.def(
      "describe_calculator_json",
      [find](const std::string& name) {
        return dump_json(calculators::describe_calculator(find(name)));
      },
      py::arg("name"), "Inputs and results of a calculator as JSON text.");
  module.def(
      "calculate",
      [](const std::string& name, const std::string& input) {
        const py::gil_scoped_release release;
        return dump_json(calculators::calculate(name, parse_json(input, "")));
      },
      py::arg("name"), py::arg("input"), "Runs a calculator: JSON text in, JSON text out.");
}

}  // namespace

void bind_errors(py::module_& module) {
  py::class_<Issue>(module, "Issue", "A message about the input, and its parts.")
      .def_property_readonly("severity", severity, "\"error\", \"warning\" or \"note\".")
      .def_readonly("file", &Issue::file, "File name of the deck.")
      .def_readonly("line", &Issue::line,
                    "Line of the file, counted from 1; 0 if the message is not about a line.")
      .def_readonly("record", &Issue::record, "Record of the deck, e.g. \"5A\".")
      .def_readonly("variable", &Issue::variable, "Variable of the deck, e.g. \"pitchDia\".")
      .def_readonly("value", &Issue::value, "Value in the deck.")
      .def_readonly("message", &Issue::message, "Problem or note.")
      .def_readonly("remedy", &Issue::remedy, "Remedy or valid values.")
      .def_property_readonly("text", &Issue::text, "The whole message.")
      .def("__str__", &Issue::text)
      .def("__repr__",
           [](const Issue& issue) { return "<" + severity(issue) + ": " + issue.text() + ">"; });
  py::class_<Finding, Issue>(module, "Finding",
                             "A finding as data; codes: resources/docs/findings.md.")
      .def_readonly("code", &Finding::code, "Code of the finding, e.g. \"cage.yielding\".")
      .def_readonly("quantity", &Finding::quantity,
                    "Quantity of `measured`; empty if there is none.")
      .def_readonly("measured", &Finding::measured, "Value of the quantity in `unit`, or None.")
      .def_readonly("least", &Finding::least, "Lower limit in `unit`, or None.")
      .def_readonly("limit", &Finding::limit, "Upper limit in `unit`, or None.")
      .def_readonly("unit", &Finding::unit, "Unit of value and limits.")
      .def_readonly("body", &Finding::body, "Body, e.g. \"ball 3, inner race\".")
      .def_readonly("time", &Finding::time, "Time of the run [s], or None.")
      .def_readonly("step", &Finding::step, "Step of the run, or None.");
  module.def(
      "run_findings", [](const std::string& folder) { return results::run_findings(folder); },
      py::arg("folder"), "Findings of a finished run: RUN.json, or RESULTS.h5.");
  module.def(
      "findings_of", [](std::vector<Issue> issues) { return findings_of(std::move(issues)); },
      py::arg("issues"), "Converts messages to findings with codes.");
  py::register_exception_translator(translate);
}

}  // namespace adore::python

PYBIND11_MODULE(_core, module) {
  using namespace adore;
  module.doc() = "Solver of the package adore. Use the package instead.";
  module.attr("__version__") = std::string(kVersionNumber);
  python::bind_errors(module);
  python::bind_deck(module);
  python::bind_routines(module);
  python::bind_runs(module);
  python::bind_find(module);
  python::bind_assembly(module);
  python::bind_results(module);
  python::bind_calculators(module);
  module.def(
      "run_options",
      [] {
        pybind11::list out;
        for (const runs::RunOptionInfo& info : runs::run_options())
          out.append(pybind11::make_tuple(info.name, info.default_value, info.meaning));
        return out;
      },
      "Name, default and meaning of every run option.");
  module.def("require_reproducible", &runs::require_reproducible,
             "All later runs of this process give bit-identical results on all x86-64 processors.");
}
