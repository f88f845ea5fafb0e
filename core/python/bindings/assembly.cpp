#include "assembly/assembly_file.hpp"
#include "assembly/assembly_report.hpp"
#include "assembly/new_assembly.hpp"
#include "assembly/run_assembly.hpp"
#include "base/json_text.hpp"
#include "bindings.hpp"

#include <map>

/// Sets of bearing rows: folders with ASSEMBLY.json.
namespace adore::python {
namespace {

using Texts = std::map<std::string, std::string>;

assembly::AssemblyRunRequest request_of(const std::string& folder, const Texts& sets,
                                        const Texts& options) {
  assembly::AssemblyRunRequest out;
  out.folder = folder;
  out.sets.assign(sets.begin(), sets.end());
  out.options.assign(options.begin(), options.end());
  return out;
}

py::array to_array(const assembly::Mat5& matrix) {
  std::vector<double> values;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) values.push_back(matrix(i, j));
  return python::to_array(std::move(values), {5, 5});
}

std::array<double, 5> to_values(const assembly::Vec5& v) { return {v(0), v(1), v(2), v(3), v(4)}; }

py::dict to_dict(const assembly::AssemblyResult& result) {
  py::dict out;
  out["displacement"] = to_values(result.loaded.state.q);
  out["load"] = to_values(result.loaded.state.load);
  out["stiffness"] = to_array(result.loaded.state.stiffness);
  out["results"] = to_list(result.set);
  py::list rows;
  for (const assembly::RowResult& row : result.rows) rows.append(to_list(row.of));
  out["rows"] = rows;
  out["tables"] = python::to_dict(std::move(assembly::result_tables(result).tables));
  out["report"] = dump_json(assembly::result_json(result));
  out["lines"] = assembly::result_lines(result);
  out["remarks"] = result.findings;
  out["seconds"] = result.seconds;
  return out;
}

}  // namespace

void bind_assembly(py::module_& module) {
  module.def(
      "read_assembly",
      [](const std::string& folder) {
        return assembly::assembly_text(assembly::read_assembly_file(folder));
      },
      py::arg("folder"), "ASSEMBLY.json of a folder, checked, as JSON text.");
  module.def(
      "solve_assembly",
      [](const std::string& folder, const Texts& sets, const Texts& options) {
        const assembly::AssemblyRequest request = request_of(folder, sets, options);
        return to_dict(run_interruptible([&](std::stop_token stop) {
          return assembly::solve_assembly(request, std::move(stop));
        }));
      },
      py::arg("folder"), py::arg("sets"), py::arg("options"),
      "The quasi-static solution of a set of rows as plain values in SI units.");
  module.def(
      "check_assembly",
      [](const std::string& folder, const Texts& sets, const Texts& options) {
        const assembly::AssemblyRequest request = request_of(folder, sets, options);
        return run_interruptible([&](std::stop_token stop) {
                 return assembly::check_assembly(request, std::move(stop));
               })
            .issues;
      },
      py::arg("folder"), py::arg("sets"), py::arg("options"),
      "All errors and findings of an assembly.");
  module.def(
      "run_assembly",
      [](const std::string& folder, const Texts& sets, const Texts& options, const std::string& out,
         bool overwrite) {
        assembly::AssemblyRunRequest request = request_of(folder, sets, options);
        if (!out.empty()) request.out = out;
        request.overwrite = overwrite;
        const assembly::AssemblyOutcome outcome = run_interruptible(
            [&](std::stop_token stop) { return assembly::run_assembly(request, std::move(stop)); });
        return outcome.folder.string();
      },
      py::arg("folder"), py::arg("sets"), py::arg("options"), py::arg("out"), py::arg("overwrite"),
      "Solves a set of rows and writes its files; returns their folder.");
  module.def(
      "new_assembly",
      [](const std::string& folder, const std::string& arrangement,
         const std::vector<std::string>& decks, const std::string& members) {
        assembly::Assembly set = assembly::assembly_from_arrangement(arrangement);
        auto json = parse_json<nlohmann::ordered_json>(assembly::assembly_text(set), "set");
        json.update(parse_json<nlohmann::ordered_json>(members, "members"));
        set = assembly::read_assembly(dump_json(json), assembly::kFileName);
        std::vector<assembly::RowDeckText> rows;
        for (const std::string& deck : decks)
          rows.push_back({assembly::make_row_deck(deck, {}), {}});
        if (rows.size() == 1) rows.resize(set.rows.size(), rows.front());
        if (rows.size() != set.rows.size())
          throw InputError("decks: give one deck, or one for each row");
        (void)assembly::write_assembly(folder, set, rows);
      },
      py::arg("folder"), py::arg("arrangement"), py::arg("decks"), py::arg("members"),
      "Writes a folder of an assembly.");
}

}  // namespace adore::python
