#include "base/json_text.hpp"
#include "bindings.hpp"
#include "results/h5_reader.hpp"
#include "routines.hpp"
#include "runs/check.hpp"
#include "runs/equilibrium.hpp"
#include "runs/plan.hpp"
#include "runs/run.hpp"
#include "studies/sweep.hpp"

#include <map>

/// What is done with a deck: check, plan, equilibrium, run, sweep.
namespace adore::python {
namespace {

using Options = std::map<std::string, std::string>;

runs::DeckRequest deck_request(const std::string& text, const std::string& name,
                               const Options& options, const py::object& user) {
  runs::DeckRequest out;
  out.deck = name;
  out.text = text;
  out.in_memory = true;
  out.options.assign(options.begin(), options.end());
  if (py::isinstance<Routines>(user))
    out.routines = user.cast<const Routines&>().plug_in();
  else if (!user.is_none())
    out.user = user.cast<std::string>();
  return out;
}

const char* status_name(runs::RunStatus status) {
  switch (status) {
    case runs::RunStatus::Interrupted:
      return "interrupted";
    case runs::RunStatus::Failed:
      return "failed";
    case runs::RunStatus::Untrusted:
      return "untrusted";
    case runs::RunStatus::Done:
      break;
  }
  return "done";
}

/// Hands the newest progress from the computing thread to the one that holds the interpreter.
class ProgressDesk {
 public:
  explicit ProgressDesk(py::object callback) : callback_(std::move(callback)) {}

  [[nodiscard]] runs::ProgressSink sink() {
    if (callback_.is_none()) return {};
    return [this](const runs::Progress& progress) {
      const std::scoped_lock lock(mutex_);
      newest_ = progress;
    };
  }

  /// With the interpreter's lock. A callback that returns False asks for an end.
  void deliver() {
    std::optional<runs::Progress> progress;
    {
      const std::scoped_lock lock(mutex_);
      std::swap(progress, newest_);
    }
    if (!progress || callback_.is_none()) return;
    const py::object answer = callback_(*progress);
    if (answer.ptr() == Py_False) throw StopAsked();
  }

  struct StopAsked {};

 private:
  py::object callback_;
  std::mutex mutex_;
  std::optional<runs::Progress> newest_;
};

/// What Python raised while the work was under way: (exception or None, whether a callback asked
/// for the end).
std::pair<py::object, bool> raised_of(const std::exception_ptr& raised) {
  if (!raised) return {py::none(), false};
  try {
    std::rethrow_exception(raised);
  } catch (const ProgressDesk::StopAsked&) {
    return {py::none(), true};
  } catch (py::error_already_set& error) {
    return {error.value(), false};
  }
}

struct RunRecord {
  runs::RunOutcome outcome;
  py::object raised = py::none();
};

runs::RunRequest run_request(const std::string& text, const std::string& name,
                             const Options& options, const py::object& user, const std::string& out,
                             const std::string& until, const std::string& integrator,
                             const std::optional<double>& tolerance, bool go_on, bool overwrite) {
  runs::RunRequest request;
  static_cast<runs::DeckRequest&>(request) = deck_request(text, name, options, user);
  request.out = out;
  request.until = until;
  request.integrator = integrator;
  request.tolerance = tolerance;
  request.go_on = go_on;
  request.overwrite = overwrite;
  return request;
}

void bind_run(py::module_& module) {
  using runs::Progress;
  py::class_<Progress>(module, "Progress", "Progress of a run for progress callbacks.")
      .def_readonly("fraction", &Progress::fraction,
                    "Completed fraction of the simulated time, 0 to 1.")
      .def_readonly("revolutions", &Progress::revolutions, "Shaft revolutions.")
      .def_readonly("time", &Progress::time, "Simulated time [s].")
      .def_readonly("end_time", &Progress::end_time, "End of the run [s].")
      .def_readonly(
          "last_step", &Progress::last_step,
          "Step that ends the run, if it is expected before end_time; 0: the time ends the run.")
      .def_readonly("step", &Progress::step, "Counted steps; in a sweep: completed runs.")
      .def_readonly("elapsed", &Progress::elapsed, "Computing time so far [s].")
      .def_readonly("remaining", &Progress::remaining, "Estimate [s].")
      .def_readonly("speed_up", &Progress::speed_up, "Simulated time divided by computing time.")
      .def_readonly("runs", &Progress::runs, "Number of runs of a sweep; 0: a single run.");

  using Record = RunRecord;
  py::class_<Record>(module, "RunOutcome", "Result of a run.")
      .def_property_readonly(
          "status", [](const Record& r) { return status_name(r.outcome.status); },
          "\"done\", \"interrupted\", \"failed\" or \"untrusted\".")
      .def_property_readonly(
          "message", [](const Record& r) { return r.outcome.message; },
          "Diagnosis and remedy; may be empty.")
      .def_property_readonly(
          "folder", [](const Record& r) { return r.outcome.folder.string(); },
          "Folder of the files.")
      .def_property_readonly(
          "files",
          [](const Record& r) {
            std::vector<std::string> out;
            for (const auto& file : r.outcome.files) out.push_back(file.string());
            return out;
          },
          "Files that were written.")
      .def_property_readonly(
          "remarks", [](const Record& r) { return r.outcome.warnings; },
          "Warnings and notes on the deck and the equilibrium.")
      .def_property_readonly(
          "lines", [](const Record& r) { return r.outcome.results; },
          "Results of a quasi-static run in a few sentences.")
      .def_property_readonly(
          "steps", [](const Record& r) { return r.outcome.steps; }, "Counted steps.")
      .def_property_readonly(
          "evaluations", [](const Record& r) { return r.outcome.evaluations; },
          "Number of evaluations of the right-hand side.")
      .def_property_readonly(
          "time", [](const Record& r) { return r.outcome.time; }, "Simulated time [s].")
      .def_property_readonly(
          "revolutions", [](const Record& r) { return r.outcome.revolutions; },
          "Shaft revolutions.")
      .def_property_readonly(
          "seconds", [](const Record& r) { return r.outcome.seconds; }, "Computing time [s].")
      .def_property_readonly(
          "energy_residual", [](const Record& r) { return r.outcome.energy_residual; },
          "Energy balance residual [J].")
      .def_property_readonly(
          "energy_scale", [](const Record& r) { return r.outcome.energy_scale; },
          "Energy exchanged [J].")
      .def_property_readonly(
          "results", [](const Record& r) { return to_list(r.outcome.summary); },
          "Key results: id, label, unit, value in SI.")
      .def_property_readonly(
          "raised", [](const Record& r) { return r.raised; },
          "Exception of Python during the run, or None.");

  module.def(
      "run",
      [](const std::string& text, const std::string& name, const Options& options,
         const py::object& user, const std::string& out, const std::string& until,
         const std::string& integrator, const std::optional<double>& tolerance, bool go_on,
         bool overwrite, const py::object& progress) {
        const runs::RunRequest request = run_request(text, name, options, user, out, until,
                                                     integrator, tolerance, go_on, overwrite);
        ProgressDesk desk(progress);
        const runs::ProgressSink sink = desk.sink();
        auto done = run_in_background(
            [&](std::stop_token stop) { return runs::run(request, sink, std::move(stop)); },
            [&] { desk.deliver(); });
        const auto [raised, stopped] = raised_of(done.raised);
        if (done.error) {
          if (!raised.is_none()) std::rethrow_exception(done.raised);
          std::rethrow_exception(done.error);
        }
        return RunRecord{std::move(*done.value), raised};
      },
      py::arg("text"), py::arg("name"), py::arg("options"), py::arg("user"), py::arg("out"),
      py::arg("until"), py::arg("integrator"), py::arg("tolerance"), py::arg("go_on"),
      py::arg("overwrite"), py::arg("progress"),
      "Runs a deck. The interpreter lock is released during the run.");

  module.def(
      "sweep",
      [](const std::string& text, const std::string& name, const Options& options,
         const py::object& user, const std::string& out, const std::string& variable,
         const std::string& range, const std::string& until, const std::string& integrator,
         const std::optional<double>& tolerance, bool go_on, bool overwrite, int threads,
         const py::object& progress) {
        runs::RunRequest request = run_request(text, name, options, user, out, until, integrator,
                                               tolerance, go_on, overwrite);
        request.sets.emplace_back(variable, range);
        ProgressDesk desk(progress);
        const runs::ProgressSink sink = desk.sink();
        auto done = run_in_background(
            [&](std::stop_token stop) {
              return studies::run_sweep(request, threads, sink, std::move(stop));
            },
            [&] { desk.deliver(); });
        const auto [raised, stopped] = raised_of(done.raised);
        if (!raised.is_none()) std::rethrow_exception(done.raised);
        if (done.error) std::rethrow_exception(done.error);
        return py::make_tuple(done.value->table.string(), done.value->exit_code,
                              done.value->warnings);
      },
      py::arg("text"), py::arg("name"), py::arg("options"), py::arg("user"), py::arg("out"),
      py::arg("variable"), py::arg("range"), py::arg("until"), py::arg("integrator"),
      py::arg("tolerance"), py::arg("go_on"), py::arg("overwrite"), py::arg("threads"),
      py::arg("progress"),
      "Runs a deck with evenly spaced values of one variable: table, worst exit code, remarks.");
}

}  // namespace

void bind_runs(py::module_& module) {
  module.def(
      "check",
      [](const std::string& text, const std::string& name, const Options& options,
         const py::object& user) {
        const runs::DeckRequest request = deck_request(text, name, options, user);
        return run_interruptible(
            [&](const std::stop_token& stop) { return runs::check(request, stop).issues; });
      },
      py::arg("text"), py::arg("name"), py::arg("options"), py::arg("user") = py::none(),
      "All findings about the text of a deck, optionally with user routines.");
  module.def(
      "options_of_deck",
      [](const std::string& deck) { return runs::options_of_deck(runs::deck_path(deck)); },
      py::arg("deck"), "Run options of ADORE.json in the folder of a deck.");
  module.def(
      "plan",
      [](const std::string& text, const std::string& name, const Options& options,
         const py::object& user) {
        const runs::DeckRequest request = deck_request(text, name, options, user);
        const runs::PlanReport report = run_interruptible(
            [&](std::stop_token stop) { return runs::plan(request, std::move(stop)); });
        return py::make_tuple(report.text, dump_json(report.json), report.remarks);
      },
      py::arg("text"), py::arg("name"), py::arg("options"), py::arg("user"),
      "Plan as text and JSON, and findings.");
  module.def(
      "equilibrium",
      [](const std::string& text, const std::string& name, const Options& options,
         const py::object& user) {
        const runs::DeckRequest request = deck_request(text, name, options, user);
        runs::Equilibrium solution = run_interruptible([&](std::stop_token stop) {
          return runs::solve_equilibrium(request, std::move(stop));
        });
        std::vector<double> stiffness;
        for (const auto& row : solution.stiffness)
          stiffness.insert(stiffness.end(), row.begin(), row.end());
        py::dict out;
        out["bearing"] = solution.tables.bearing;
        out["displacement"] = solution.displacement;
        out["load"] = solution.load;
        out["stiffness"] = to_array(std::move(stiffness), {5, 5});
        out["results"] = to_list(solution.results);
        out["tables"] = to_dict(std::move(solution.tables.tables));
        out["lines"] = solution.lines;
        out["remarks"] = solution.remarks;
        out["seconds"] = solution.seconds;
        return out;
      },
      py::arg("text"), py::arg("name"), py::arg("options"), py::arg("user"),
      "The quasi-static equilibrium as plain values in SI units.");
  bind_run(module);
}

}  // namespace adore::python
