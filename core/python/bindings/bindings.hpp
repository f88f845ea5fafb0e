#pragma once

#include "base/errors.hpp"
#include "base/interrupted.hpp"
#include "results/h5_reader.hpp"
#include "results/key_results.hpp"
#include "results/static_tables.hpp"

#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

/// The parts of the Python module `adore._core`. It is thin: plain values in and out; what is
/// pleasant to use is written in Python above it (core/python/adore).
namespace adore::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_deck(py::module_& module);
void bind_runs(py::module_& module);
void bind_find(py::module_& module);
void bind_assembly(py::module_& module);
void bind_results(py::module_& module);

/// A NumPy array that owns the values; nothing is copied.
inline py::array to_array(std::vector<double>&& values, const std::vector<py::ssize_t>& shape) {
  auto owner = std::make_unique<std::vector<double>>(std::move(values));
  double* data = owner->data();
  const py::capsule keeper(owner.get(), [](void* vector) {
    delete static_cast<std::vector<double>*>(vector);  // NOLINT(cppcoreguidelines-owning-memory)
  });
  (void)owner.release();
  return py::array_t<double>(shape, data, keeper);
}

/// [(id, label, unit, value in SI)]
inline py::list to_list(const results::KeyResults& results) {
  py::list out;
  for (const results::KeyResult& result : results) {
    std::string label(result.of.label);
    if (!result.of.part.empty()) label += " " + std::string(result.of.part);
    out.append(py::make_tuple(std::string(result.of.id), label,
                              std::string(result.of.unit != nullptr ? result.of.unit->si : ""),
                              result.value));
  }
  return out;
}

/// {table: [(column, unit, values in SI)]}
inline py::dict to_dict(std::vector<results::StaticTable>&& tables) {
  py::dict out;
  for (results::StaticTable& table : tables) {
    py::list columns;
    for (results::StaticColumn& column : table.columns) {
      const auto rows = static_cast<py::ssize_t>(column.values.size());
      const deck::UnitPair* unit = column.unit;
      columns.append(py::make_tuple(
          column.name, std::string(unit != nullptr ? results::coherent_unit(*unit) : ""),
          to_array(std::move(column.values), {rows})));
    }
    out[py::str(table.name)] = columns;
  }
  return out;
}

/// What a call in the background came to: its value, or what it threw; and what Python raised in
/// the meantime (Ctrl-C, a callback), which asked it to stop.
template <class Value>
struct Background {
  std::optional<Value> value;
  std::exception_ptr error, raised;
};

/// Runs `work(stop_token)` in a thread of its own while this one waits without the interpreter's
/// lock, and twenty times a second takes it to look for signals and to call `tick`. Whatever they
/// raise asks the work to stop; it is waited for.
template <class Work>
auto run_in_background(Work&& work, const std::function<void()>& tick = {})
    -> Background<decltype(work(std::stop_token{}))> {
  Background<decltype(work(std::stop_token{}))> out;
  std::mutex mutex;
  std::condition_variable ended;
  bool done = false;
  std::stop_source stop;
  std::thread thread([&] {
    try {
      out.value = work(stop.get_token());
    } catch (...) {
      out.error = std::current_exception();
    }
    const std::scoped_lock lock(mutex);
    done = true;
    ended.notify_one();
  });
  for (bool waiting = true; waiting;) {
    {
      const py::gil_scoped_release release;
      std::unique_lock lock(mutex);
      waiting = !ended.wait_for(lock, std::chrono::milliseconds(50), [&] { return done; });
    }
    if (out.raised) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (tick) tick();
    } catch (...) {
      out.raised = std::current_exception();
      stop.request_stop();
    }
  }
  {
    const py::gil_scoped_release release;
    thread.join();
  }
  return out;
}

/// The same where nothing is left of a call that was stopped.
template <class Work>
auto run_interruptible(Work&& work) {
  auto done = run_in_background(std::forward<Work>(work));
  if (done.raised) std::rethrow_exception(done.raised);
  if (done.error) std::rethrow_exception(done.error);
  return std::move(*done.value);
}

}  // namespace adore::python
