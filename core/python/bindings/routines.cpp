#include "routines.hpp"

#include "user/table.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>

namespace adore::python {
namespace {

constexpr std::array<const char*, 5> kKinds{"element_race", "element_cage", "cage_race",
                                            "roller_flange", "element_element"};

/// Arrays are copies: the solver's own memory is gone when the call ends, and a routine may keep
/// what it gets.
py::array_t<double> copied(const double* values, std::vector<py::ssize_t> shape) {
  py::array_t<double> out(std::move(shape));
  std::copy_n(values, out.size(), out.mutable_data());
  return out;
}

/// What a routine returned for an output, in the shape of that output or one that NumPy spreads
/// over it.
void take(const py::handle& value, double* to, std::size_t count, const char* name) {
  const auto values = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
  if (!values) {
    PyErr_Clear();
    throw std::runtime_error(std::string(name) + " is not an array of numbers");
  }
  if (values.size() == 1)
    std::fill_n(to, count, *values.data());
  else if (static_cast<std::size_t>(values.size()) == count)
    std::copy_n(values.data(), count, to);
  else
    throw std::runtime_error(std::string(name) + " has " + std::to_string(values.size()) +
                             " values; give " + std::to_string(count) +
                             " values, or one value for all");
}

void take(const py::dict& answer, const char* name, double* to, std::size_t count) {
  if (answer.contains(name)) take(answer[name], to, count, name);
}

void take(const py::dict& answer, const char* name, std::int32_t& to) {
  if (answer.contains(name)) to = answer[name].cast<bool>() ? 1 : 0;
}

/// Calls a function of the user. @throws std::runtime_error with what Python raised
py::object ask(const py::object& function, const py::dict& values) {
  try {
    return function(values);
  } catch (const py::error_already_set& error) {
    throw std::runtime_error(error.what());
  }
}

py::dict answer_of(const py::object& function, const py::dict& values) {
  const py::object answer = ask(function, values);
  return answer.is_none() ? py::dict() : answer.cast<py::dict>();
}

void material(const py::object& function, adore_adrx0& a, py::dict& given) {
  constexpr std::array kParts{"element", "outer_race", "inner_race", "housing", "shaft", "cage"};
  constexpr std::array kNames{
      "density",          "elastic_modulus",     "poisson_ratio",        "thermal_expansion",
      "conductivity",     "specific_heat",       "elastic_strain_limit", "hardness",
      "wear_coefficient", "fatigue_limit_stress"};
  double* const values[] = {
      &a.density,          &a.elastic_modulus,     &a.poisson_ratio,        &a.thermal_expansion,
      &a.conductivity,     &a.specific_heat,       &a.elastic_strain_limit, &a.hardness,
      &a.wear_coefficient, &a.fatigue_limit_stress};
  given["part"] = kParts[static_cast<std::size_t>(a.part)];
  for (std::size_t k = 0; k < kNames.size(); ++k) given[kNames[k]] = *values[k];
  const py::dict answer = answer_of(function, given);
  for (std::size_t k = 0; k < kNames.size(); ++k) take(answer, kNames[k], values[k], 1);
}

void motion(const py::object& function, adore_adrx1& a, py::dict& given) {
  given["start"] = a.call.mode == ADORE_START;
  given["time"] = a.call.time;
  if (a.call.mode == ADORE_START) {
    const py::dict answer = answer_of(function, given);
    if (answer.contains("drives")) {
      const auto drives = answer["drives"].cast<std::array<bool, 2>>();
      for (std::size_t j = 0; j < 2; ++j) a.drives[j] = drives[j] ? 1 : 0;
    }
    take(answer, "moves_frame", a.moves_frame);
    take(answer, "suppress_element_axial", a.suppress_element_axial);
    take(answer, "suppress_element_tilt", a.suppress_element_tilt);
    take(answer, "suppress_element_all", a.suppress_element_all);
    take(answer, "suppress_cage_axial", a.suppress_cage_axial);
    take(answer, "suppress_cage_tilt", a.suppress_cage_tilt);
    take(answer, "start_velocity", a.start_velocity, 6);
    take(answer, "start_spin", a.start_spin, 2);
    take(answer, "longest_step", &a.longest_step, 1);
    if (answer.contains("kinks")) {
      const auto kinks = answer["kinks"].cast<std::vector<double>>();
      if (kinks.size() > std::size(a.kinks))
        throw std::runtime_error("kinks: give at most 8 times");
      std::copy(kinks.begin(), kinks.end(), a.kinks);
      a.kink_count = static_cast<std::int32_t>(kinks.size());
    }
    return;
  }
  given["position"] = copied(a.position, {2, 3});
  given["velocity"] = copied(a.velocity, {2, 3});
  given["omega"] = copied(a.omega, {2, 3});
  given["angle"] = copied(a.angle, {2});
  const py::dict answer = answer_of(function, given);
  take(answer, "force", a.force, 6);
  take(answer, "moment", a.moment, 6);
  take(answer, "acceleration", a.acceleration, 6);
  take(answer, "angular_acceleration", a.angular_acceleration, 6);
  take(answer, "frame_acceleration", a.frame_acceleration, 3);
  take(answer, "frame_omega", a.frame_omega, 3);
  take(answer, "frame_angular_acceleration", a.frame_angular_acceleration, 3);
}

void force(const py::object& function, adore_force& a, py::dict& given) {
  const auto n = static_cast<py::ssize_t>(a.n);
  given["time"] = a.call.time;
  given["element"] = py::array_t<std::int32_t>({n}, a.element);
  given["surface"] = py::array_t<std::int32_t>({n}, a.surface);
  given["gap"] = copied(a.gap, {n});
  given["gap_rate"] = copied(a.gap_rate, {n});
  given["built_in"] = copied(a.built_in, {n});
  take(ask(function, given), a.force, static_cast<std::size_t>(a.n), "force");
}

void surface(const py::object& function, adore_surface& a, py::dict& given) {
  const auto n = static_cast<py::ssize_t>(a.n);
  given["axial"] = copied(a.axial, {n});
  given["azimuth"] = copied(a.azimuth, {n});
  if (a.race < 0)
    given["element"] = a.element;
  else
    given["race"] = a.race == 0 ? "outer_race" : "inner_race";
  given["elements"] = a.call.bearing->elements;
  given["element_diameter"] = a.call.bearing->element_diameter;
  given["pitch_diameter"] = a.call.bearing->pitch_diameter;
  const py::object answer = ask(function, given);
  const auto count = static_cast<std::size_t>(a.n);
  if (answer.is_none()) return;
  if (!py::isinstance<py::dict>(answer)) return take(answer, a.radius, count, "radius");
  const py::dict values = answer;
  take(values, "radius", a.radius, count);
  take(values, "curvature_factor", a.curvature_factor, count);
}

void imperfections(const py::object& function, adore_adrx8& a, py::dict& given) {
  given["n"] = a.n;
  given["elements_wanted"] = a.elements_wanted != 0;
  given["pockets_wanted"] = a.pockets_wanted != 0;
  given["inertia_wanted"] = a.inertia_wanted != 0;
  given["mass"] = a.mass;
  given["moments"] = copied(a.moments, {3});
  given["geometric_centre"] = copied(a.geometric_centre, {3});
  given["frame"] = copied(a.frame, {3});
  const py::dict answer = answer_of(function, given);
  const auto n = static_cast<std::size_t>(a.n);
  const std::pair<const char*, double*> of_each[] = {{"diameter", a.diameter},
                                                     {"crown_radius", a.crown_radius},
                                                     {"length", a.length},
                                                     {"central_length", a.central_length},
                                                     {"land_offset", a.land_offset},
                                                     {"pocket_clearance1", a.pocket_clearance1},
                                                     {"pocket_clearance2", a.pocket_clearance2},
                                                     {"pocket_thickness", a.pocket_thickness},
                                                     {"pocket_axial", a.pocket_axial},
                                                     {"pocket_angular", a.pocket_angular}};
  for (const auto& [name, to] : of_each) take(answer, name, to, n);
  take(answer, "pocket_tilt", a.pocket_tilt, 3 * n);
  take(answer, "mass", &a.mass, 1);
  take(answer, "moments", a.moments, 3);
  take(answer, "geometric_centre", a.geometric_centre, 3);
  take(answer, "frame", a.frame, 3);
}

void traction(const py::object& function, adore_adrx7& a, py::dict& given) {
  const auto n = static_cast<py::ssize_t>(a.n), points = static_cast<py::ssize_t>(a.points);
  const auto rows = [&](const double* values) {
    py::array_t<double> out({points, n});
    for (py::ssize_t k = 0; k < points; ++k)
      std::copy_n(values + k * a.stride, n, out.mutable_data(k, 0));
    return out;
  };
  given["time"] = a.call.time;
  given["kind"] = kKinds[static_cast<std::size_t>(a.kind)];
  given["race"] = a.race;
  given["slip"] = rows(a.slip);
  given["pressure"] = a.pressure == nullptr ? py::object(py::none()) : py::object(rows(a.pressure));
  const std::pair<const char*, const double*> of_contact[] = {{"load", a.load},
                                                              {"peak_pressure", a.peak_pressure},
                                                              {"half_major", a.half_major},
                                                              {"half_minor", a.half_minor},
                                                              {"entrainment", a.entrainment},
                                                              {"curvature", a.curvature},
                                                              {"middle_slip", a.middle_slip}};
  for (const auto& [name, values] : of_contact) given[name] = copied(values, {n});
  std::vector<double> kappa(static_cast<std::size_t>(n * points));
  take(ask(function, given), kappa.data(), kappa.size(), "kappa");
  for (py::ssize_t k = 0; k < points; ++k)
    std::copy_n(kappa.data() + k * n, n, a.kappa + k * a.stride);
}

void results(const py::object& function, adore_adrx9& a, py::dict& given) {
  const auto n = static_cast<py::ssize_t>(a.n), sources = static_cast<py::ssize_t>(a.sources);
  given["start"] = a.call.mode == ADORE_START;
  if (a.call.mode == ADORE_STEP) {
    given["time"] = a.call.time;
    given["step"] = a.call.step;
    given["step_size"] = a.step_size;
    given["total_heat"] = a.total_heat;
    given["x"] = copied(a.x, {n});
    given["r"] = copied(a.r, {n});
    given["theta"] = copied(a.theta, {n});
    // By element, then race; the structure has all elements of the outer race first.
    const auto by_element = [n](const double* from) {
      py::array_t<double> out({n, py::ssize_t{2}});
      for (py::ssize_t i = 0; i < n; ++i)
        for (py::ssize_t j = 0; j < 2; ++j) out.mutable_at(i, j) = from[j * n + i];
      return out;
    };
    given["load"] = by_element(a.load);
    given["contact_angle"] = by_element(a.contact_angle);
    given["source_kind"] = py::array_t<std::int32_t>({sources}, a.source_kind);
    given["source_element"] = py::array_t<std::int32_t>({sources}, a.source_element);
    given["source_race"] = py::array_t<std::int32_t>({sources}, a.source_race);
    given["source_heat"] = copied(a.source_heat, {sources});
    given["source_place"] = copied(a.source_place, {sources, 3});
    given["source_size"] = copied(a.source_size, {sources, 2});
    py::list names;
    for (py::ssize_t k = 0; k < sources; ++k) names.append(py::str(a.source_name[k]));
    given["source_name"] = names;
    py::dict channels;
    for (std::int64_t k = 0; k < a.channels; ++k)
      channels[a.channel_name[k]] = copied(a.channel_value + a.channel_first[k],
                                           {static_cast<py::ssize_t>(a.channel_size[k])});
    given["channels"] = channels;
  } else {
    a.wants_channels = 1;
  }
  const py::object text = ask(function, given);
  if (!text.is_none()) a.call.services->write(a.call.host, text.cast<std::string>().c_str());
}

}  // namespace

Routines::Routines(std::string version) : state_(std::make_shared<State>()) {
  state_->version = std::move(version);
}

void Routines::set(int hook, py::object function) { state_->functions[hook] = std::move(function); }

void Routines::set_traction(const std::string& kind, py::object function, std::vector<double> slip,
                            std::vector<double> kappa, double slip_scale, bool points) {
  Traction law;
  law.function = std::move(function);
  if (!slip.empty())
    law.table = std::make_shared<user::MonotoneTable>(std::move(slip), std::move(kappa));
  law.slip_scale = slip_scale;
  law.points = points;
  const auto at = std::find(kKinds.begin(), kKinds.end(), kind);
  if (at == kKinds.end())
    throw InputError("there is no kind of contact \"" + kind +
                     "\"; give element_race, element_cage, cage_race, roller_flange or "
                     "element_element");
  state_->traction[static_cast<std::size_t>(at - kKinds.begin())] = std::move(law);
}

void Routines::set_numbers(int hook, int count) {
  state_->numbers[hook].assign(static_cast<std::size_t>(std::max(count, 0)), 0.0);
}

std::pair<long, double> Routines::direct_cost() const {
  return {state_->direct_calls, state_->direct_seconds};
}

std::shared_ptr<const user::PlugIn> Routines::plug_in() const {
  auto out = std::make_shared<user::PlugIn>();
  out->source = "functions of this Python program";
  out->version = state_->version;
  const std::shared_ptr<State> state = state_;
  /// Everything of Python happens with its lock, and is timed.
  const auto in_python = [](State& s, const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    const py::gil_scoped_acquire lock;
    work();
    ++s.direct_calls;
    s.direct_seconds +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const auto read = [](State& s, adore_call& call) {
    call.active = 1;
    const auto wanted = s.numbers.find(call.hook);
    if (wanted == s.numbers.end()) return 0;
    const auto count = static_cast<std::int32_t>(wanted->second.size());
    const std::int32_t found = call.services->read_numbers(call.host, wanted->second.data(), count);
    if (found != count)
      throw std::runtime_error("needs " + std::to_string(count) +
                               " numbers from records 12.x, but the deck has " +
                               std::to_string(found));
    return 0;
  };
  const auto given_of = [](const State& s, const adore_call& call) {
    py::dict given;
    if (const auto numbers = s.numbers.find(call.hook); numbers != s.numbers.end())
      given["numbers"] =
          copied(numbers->second.data(), {static_cast<py::ssize_t>(numbers->second.size())});
    return given;
  };
  const auto one = [&](int hook, auto work, std::initializer_list<int> modes) {
    const auto found = state->functions.find(hook);
    if (found == state->functions.end()) return;
    out->hooks[static_cast<std::size_t>(hook)] =
        [state, in_python, read, given_of, work, function = &found->second,
         list = std::vector<int>(modes)](adore_call& call) {
          if (call.mode == ADORE_READ) return read(*state, call);
          if (std::find(list.begin(), list.end(), call.mode) == list.end()) return 0;
          in_python(*state, [&] {
            py::dict given = given_of(*state, call);
            work(*function, call, given);
          });
          return 0;
        };
  };
  using Object = const py::object&;
  one(0,
      [](Object f, adore_call& c, py::dict& g) {
        material(f, reinterpret_cast<adore_adrx0&>(c), g);
      },
      {ADORE_COMPUTE});
  one(1,
      [](Object f, adore_call& c, py::dict& g) { motion(f, reinterpret_cast<adore_adrx1&>(c), g); },
      {ADORE_START, ADORE_COMPUTE});
  for (const int hook : {2, 3, 4})
    one(hook,
        [](Object f, adore_call& c, py::dict& g) {
          force(f, reinterpret_cast<adore_force&>(c), g);
        },
        {ADORE_COMPUTE});
  for (const int hook : {5, 6})
    one(hook,
        [](Object f, adore_call& c, py::dict& g) {
          surface(f, reinterpret_cast<adore_surface&>(c), g);
        },
        {ADORE_COMPUTE});
  one(8,
      [](Object f, adore_call& c, py::dict& g) {
        imperfections(f, reinterpret_cast<adore_adrx8&>(c), g);
      },
      {ADORE_COMPUTE});
  one(9,
      [](Object f, adore_call& c, py::dict& g) {
        results(f, reinterpret_cast<adore_adrx9&>(c), g);
      },
      {ADORE_START, ADORE_STEP});
  bool any = false, direct = false;
  for (const Traction& law : state->traction) {
    any = any || law.table || law.function;
    direct = direct || (law.function && !law.table);
  }
  out->pure = !direct && state->functions.empty();
  if (!any) return out;
  out->hooks[7] = [state, in_python, read, given_of](adore_call& call) {
    if (call.mode == ADORE_READ) return read(*state, call);
    if (call.mode != ADORE_START && call.mode != ADORE_COMPUTE) return 0;
    auto& a = reinterpret_cast<adore_adrx7&>(call);
    const Traction& law = state->traction[static_cast<std::size_t>(a.kind)];
    if (!law.table && !law.function)
      throw std::runtime_error(std::string("the deck needs a traction law for ") +
                               kKinds[static_cast<std::size_t>(a.kind)] +
                               ", but the program did not set one");
    if (call.mode == ADORE_START) {
      a.slip_scale = law.slip_scale;
      a.wants_points = law.points ? 1 : 0;
      return 0;
    }
    if (law.table) {
      for (std::int64_t k = 0; k < a.points; ++k)
        for (std::int64_t i = k * a.stride; i < k * a.stride + a.n; ++i)
          a.kappa[i] = (*law.table)(a.slip[i]);
      return 0;
    }
    in_python(*state, [&] {
      py::dict given = given_of(*state, call);
      traction(law.function, a, given);
    });
    return 0;
  };
  return out;
}

Routines::State::~State() {
  const py::gil_scoped_acquire lock;
  functions.clear();
  for (Traction& law : traction) law.function = py::object();
}

void bind_routines(py::module_& module) {
  py::class_<Routines>(module, "Routines", "Python functions as user routines ADRX0 to ADRX9.")
      .def(py::init<std::string>(), py::arg("version"))
      .def("set", &Routines::set, py::arg("hook"), py::arg("function"),
           "Sets a function that receives a dictionary with the data of the routine.")
      .def("set_numbers", &Routines::set_numbers, py::arg("hook"), py::arg("count"),
           "Sets the number of values of records 12.x that a routine reads.")
      .def("set_traction", &Routines::set_traction, py::arg("kind"), py::arg("function"),
           py::arg("slip"), py::arg("kappa"), py::arg("slip_scale"), py::arg("points"),
           "Sets a traction law: a table, or a function if the table is empty.")
      .def_property_readonly("direct_cost", &Routines::direct_cost,
                             "Number of calls of Python functions so far, and their time [s].");
  module.def(
      "interpolate",
      [](std::vector<double> x, std::vector<double> y, const std::vector<double>& at) {
        const user::MonotoneTable table(std::move(x), std::move(y));
        std::vector<double> out;
        out.reserve(at.size());
        for (const double value : at) out.push_back(table(value));
        const auto count = static_cast<py::ssize_t>(out.size());
        return to_array(std::move(out), {count});
      },
      py::arg("x"), py::arg("y"), py::arg("at"),
      "Values of a monotone table, interpolated as in the solver.");
}

}  // namespace adore::python
