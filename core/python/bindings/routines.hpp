#pragma once

#include "bindings.hpp"
#include "user/plug_in.hpp"
#include "user/table.hpp"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace adore::python {

/// Functions of a Python program in the place of a plug-in. Their arguments are dictionaries of
/// NumPy arrays, SI; what they cost is counted.
class Routines {
 public:
  explicit Routines(std::string version);
  void set(int hook, py::object function);
  /// With a table, Python is not called while the run computes.
  void set_traction(const std::string& kind, py::object function, std::vector<double> slip,
                    std::vector<double> kappa, double slip_scale, bool points);
  /// So many numbers of records 12.x belong to a routine: its function finds them as "numbers".
  void set_numbers(int hook, int count);
  [[nodiscard]] std::pair<long, double> direct_cost() const;
  [[nodiscard]] std::shared_ptr<const user::PlugIn> plug_in() const;

 private:
  struct Traction {
    py::object function;
    std::shared_ptr<const user::MonotoneTable> table;
    double slip_scale = 0.0;
    bool points = false;
  };
  struct State {
    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State();
    std::string version;
    std::map<int, py::object> functions;         ///< by hook
    std::map<int, std::vector<double>> numbers;  ///< of records 12.x, by hook
    std::array<Traction, 5> traction;
    long direct_calls = 0;
    double direct_seconds = 0.0;
  };
  std::shared_ptr<State> state_;
};

void bind_routines(py::module_& module);

}  // namespace adore::python
