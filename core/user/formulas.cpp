#include "user/formulas.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "user/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <muParser.h>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace adore::user {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

/// Numbers that formulas know by name, at addresses that stay.
class Names {
 public:
  double& operator[](const std::string& name) { return values_[name]; }
  [[nodiscard]] std::map<std::string, double>& all() noexcept { return values_; }

 private:
  std::map<std::string, double> values_;
};

/// One formula, or a number.
class Formula {
 public:
  Formula(const Json& text, Names& names, const std::string& where) : where_(where) {
    try {
      for (auto& [name, value] : names.all()) parser_.DefineVar(name, &value);
      parser_.DefineConst("pi", std::numbers::pi);
      parser_.SetExpr(text.is_number() ? fmt::format("{:.17g}", text.get<double>())
                                       : text.get<std::string>());
      (void)parser_.Eval();
    } catch (const mu::Parser::exception_type& error) {
      std::string known;
      for (const auto& [name, value] : names.all()) known += (known.empty() ? "" : ", ") + name;
      throw InputError(
          fmt::format("{}: the formula is not valid: {} (\"{}\"; known names: {} and pi)", where,
                      error.GetMsg(), error.GetExpr(), known));
    } catch (const Json::exception&) {
      throw InputError(fmt::format("{}: give a formula (text) or a number", where));
    }
  }
  [[nodiscard]] double operator()() const {
    try {
      return parser_.Eval();
    } catch (const mu::Parser::exception_type& error) {
      throw std::runtime_error(fmt::format("{}: {}", where_, error.GetMsg()));
    }
  }

 private:
  mu::Parser parser_;
  std::string where_;
};

/// The part of the file that belongs to one routine.
struct Section {
  std::string where;  ///< file and routine
  fs::path folder;
  Json json;
  std::shared_ptr<Names> names = std::make_shared<Names>();
  std::vector<std::string> read;
  std::set<std::string> used{"read", "constants"};

  Section(const fs::path& file, const std::string& hook, Json part)
      : where(fmt::format("{}, {}", file.string(), hook)),
        folder(file.parent_path()),
        json(std::move(part)) {
    if (!json.is_object()) throw InputError(where + ": give a JSON object");
    if (const Json list = json.value("read", Json::array()); list.is_array())
      for (const Json& one : list) {
        if (!one.is_string())
          throw InputError(where +
                           ", \"read\": give a list of names, one for each number of records 12.x");
        read.push_back(one.get<std::string>());
        (*names)[read.back()] = 0.0;
      }
    if (const Json list = json.value("constants", Json::object()); list.is_object())
      for (const auto& [name, value] : list.items()) (*names)[name] = 0.0;
  }
  /// A number that all formulas know: its name is not free.
  double* known(const std::string& name) {
    if (names->all().count(name) > 0)
      throw InputError(fmt::format("{}: \"{}\" is a built-in name of formulas; choose another name",
                                   where, name));
    return &(*names)[name];
  }
  [[nodiscard]] const Json* find(const std::string& key) {
    used.insert(key);
    return json.contains(key) ? &json.at(key) : nullptr;
  }
  [[nodiscard]] std::optional<Formula> formula(const Json& object, const std::string& key,
                                               const std::string& path) {
    if (!object.contains(key)) return {};
    return Formula(object.at(key), *names, where + ", " + path + key);
  }
  void check_keys() const {
    for (const auto& [key, value] : json.items())
      if (used.count(key) == 0) {
        std::string known;
        for (const std::string& one : used) known += (known.empty() ? "" : ", ") + one;
        throw InputError(
            fmt::format("{}: \"{}\" is not known; known names: {}", where, key, known));
      }
  }
};

void check_keys(const Json& object, const std::vector<std::string>& known,
                const std::string& where) {
  if (!object.is_object()) throw InputError(where + ": give a JSON object");
  for (const auto& [key, value] : object.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw InputError(fmt::format("{}: \"{}\" is not known; known names: {}", where, key,
                                   fmt::join(known, ", ")));
}

/// Modes that all formulas share: reads its numbers, forms its constants. True: nothing is left.
class Preamble {
 public:
  explicit Preamble(Section& section) : read_(section.read), names_(section.names) {
    if (!section.json.contains("constants")) return;
    for (const auto& [name, value] : section.json.at("constants").items())
      constants_.emplace_back(&(*names_)[name],
                              Formula(value, *names_, section.where + ", constants, " + name));
  }
  bool operator()(adore_call& call) const {
    if (call.mode == ADORE_READ) {
      call.active = 1;
      std::vector<double> values(read_.size());
      const auto wanted = static_cast<std::int32_t>(values.size());
      if (wanted > 0 && call.services->read_numbers(call.host, values.data(), wanted) != wanted)
        throw std::runtime_error(fmt::format(
            "the formulas need {} ({}), but records 12.x do not contain {}",
            counted(wanted, "number"), fmt::join(read_, ", "), wanted == 1 ? "it" : "them"));
      for (std::size_t k = 0; k < read_.size(); ++k) (*names_)[read_[k]] = values[k];
      for (int pass = 0; pass < 2; ++pass)  // a constant may need another one
        for (const auto& [to, formula] : constants_) *to = formula();
    }
    if (call.mode == ADORE_START)
      for (const std::string& name : read_)
        call.services->print(call.host, fmt::format("{} = {:.9g}", name, (*names_)[name]).c_str());
    return call.mode == ADORE_READ;
  }

 private:
  std::vector<std::string> read_;
  std::shared_ptr<Names> names_;
  std::vector<std::pair<double*, Formula>> constants_;
};

/// Up to three formulas, or one for one component alone.
std::array<std::optional<Formula>, 3> vector_of(Section& section, const Json& object,
                                                const std::string& key, const std::string& path,
                                                int single) {
  std::array<std::optional<Formula>, 3> out;
  if (!object.contains(key)) return out;
  const Json& value = object.at(key);
  const std::string where = section.where + ", " + path + key;
  if (!value.is_array()) {
    if (single < 0) throw InputError(where + ": give three formulas, [x, y, z]");
    out[static_cast<std::size_t>(single)].emplace(value, *section.names, where);
    return out;
  }
  if (value.size() != 3) throw InputError(where + ": give three formulas, [x, y, z]");
  for (std::size_t k = 0; k < 3; ++k) out[k].emplace(value[k], *section.names, where);
  return out;
}

constexpr std::array kRaceKeys{"outer_race", "inner_race"};

Call motion(Section& section) {
  Names& names = *section.names;
  double* t = section.known("t");
  struct State {
    double *x, *y, *z, *vx, *vy, *vz, *spin, *angle;
  };
  std::array<State, 2> state{};
  for (std::size_t j = 0; j < 2; ++j) {
    const std::string n = fmt::format("{}", j + 1);
    state[j] = {section.known("x" + n),    section.known("y" + n),    section.known("z" + n),
                section.known("vx" + n),   section.known("vy" + n),   section.known("vz" + n),
                section.known("spin" + n), section.known("angle" + n)};
  }
  const Preamble preamble(section);
  struct Race {
    std::array<std::optional<Formula>, 3> force, moment, acceleration, turn, start;
    std::optional<Formula> spin;
    bool driven = false;
  };
  auto races = std::make_shared<std::array<Race, 2>>();
  for (std::size_t j = 0; j < 2; ++j) {
    const Json* given = section.find(kRaceKeys[j]);
    if (given == nullptr) continue;
    const std::string path = std::string(kRaceKeys[j]) + ", ";
    check_keys(
        *given,
        {"force", "moment", "acceleration", "angular_acceleration", "start_velocity", "start_spin"},
        section.where + ", " + kRaceKeys[j]);
    Race& race = (*races)[j];
    race.force = vector_of(section, *given, "force", path, -1);
    race.moment = vector_of(section, *given, "moment", path, 0);
    race.acceleration = vector_of(section, *given, "acceleration", path, -1);
    race.turn = vector_of(section, *given, "angular_acceleration", path, 0);
    race.start = vector_of(section, *given, "start_velocity", path, -1);
    race.spin = section.formula(*given, "start_spin", path);
    race.driven = given->contains("acceleration") || given->contains("angular_acceleration");
  }
  using Three = std::array<std::optional<Formula>, 3>;
  constexpr std::array kFrame{"frame_acceleration", "frame_omega", "frame_angular_acceleration"};
  auto frame = std::make_shared<std::array<Three, 3>>();
  bool moves_frame = false;
  for (std::size_t k = 0; k < kFrame.size(); ++k) {
    moves_frame = section.find(kFrame[k]) != nullptr || moves_frame;
    (*frame)[k] = vector_of(section, section.json, kFrame[k], "", k == 0 ? -1 : 0);
  }
  auto kinks = std::make_shared<std::vector<Formula>>();
  if (const Json* list = section.find("kinks"))
    for (const Json& one : *list) kinks->emplace_back(one, names, section.where + ", \"kinks\"");
  if (kinks->size() > 8)
    throw InputError(section.where + ", \"kinks\": give at most eight points in time");
  auto longest =
      std::make_shared<std::optional<Formula>>(section.formula(section.json, "longest_step", ""));
  section.used.insert("longest_step");
  auto suppress = std::make_shared<std::vector<std::string>>();
  if (const Json* list = section.find("suppress"))
    for (const Json& one : *list) {
      suppress->push_back(one.is_string() ? one.get<std::string>() : dump_json(one));
      const std::vector<std::string> known{"element_axial", "element_tilt", "element_all",
                                           "cage_axial", "cage_tilt"};
      if (std::find(known.begin(), known.end(), suppress->back()) == known.end())
        throw InputError(fmt::format("{}, \"suppress\": \"{}\" is not known; known names: {}",
                                     section.where, suppress->back(), fmt::join(known, ", ")));
    }
  section.check_keys();
  return [=, keep = section.names](adore_call& call) {
    if (preamble(call)) return 0;
    auto& a = reinterpret_cast<adore_adrx1&>(call);
    const auto fill = [](const std::array<std::optional<Formula>, 3>& from, double* to) {
      for (std::size_t k = 0; k < 3; ++k)
        if (from[k]) to[k] = (*from[k])();
    };
    *t = call.time;
    if (call.mode == ADORE_START) {
      a.moves_frame = moves_frame ? 1 : 0;
      for (std::size_t j = 0; j < 2; ++j) {
        const Race& race = (*races)[j];
        a.drives[j] = race.driven ? 1 : 0;
        fill(race.start, a.start_velocity + 3 * j);
        if (race.spin) a.start_spin[j] = (*race.spin)();
      }
      for (const Formula& kink : *kinks) a.kinks[a.kink_count++] = kink();
      if (*longest) a.longest_step = (**longest)();
      for (const std::string& name : *suppress) {
        if (name == "element_axial") a.suppress_element_axial = 1;
        if (name == "element_tilt") a.suppress_element_tilt = 1;
        if (name == "element_all") a.suppress_element_all = 1;
        if (name == "cage_axial") a.suppress_cage_axial = 1;
        if (name == "cage_tilt") a.suppress_cage_tilt = 1;
      }
    }
    if (call.mode != ADORE_COMPUTE) return 0;
    for (std::size_t j = 0; j < 2; ++j) {
      const State& s = state[j];
      *s.x = a.position[3 * j], *s.y = a.position[3 * j + 1], *s.z = a.position[3 * j + 2];
      *s.vx = a.velocity[3 * j], *s.vy = a.velocity[3 * j + 1], *s.vz = a.velocity[3 * j + 2];
      *s.spin = a.omega[3 * j];
      *s.angle = a.angle[j];
    }
    for (std::size_t j = 0; j < 2; ++j) {
      const Race& race = (*races)[j];
      fill(race.force, a.force + 3 * j);
      fill(race.moment, a.moment + 3 * j);
      fill(race.acceleration, a.acceleration + 3 * j);
      fill(race.turn, a.angular_acceleration + 3 * j);
    }
    fill((*frame)[0], a.frame_acceleration);
    fill((*frame)[1], a.frame_omega);
    fill((*frame)[2], a.frame_angular_acceleration);
    return 0;
  };
}

Call force(Section& section) {
  double *overlap = section.known("overlap"), *rate = section.known("rate"),
         *built_in = section.known("built_in"), *element = section.known("element"),
         *surface = section.known("surface"), *t = section.known("t");
  const Preamble preamble(section);
  std::optional<Formula> law = section.formula(section.json, "force", "");
  section.used.insert("force");
  section.check_keys();
  if (!law)
    throw InputError(section.where +
                     R"(: give "force", a formula of overlap [m], rate [m/s] and built_in [N])");
  return [=, keep = section.names](adore_call& call) {
    if (preamble(call) || call.mode != ADORE_COMPUTE) return 0;
    auto& a = reinterpret_cast<adore_force&>(call);
    *t = call.time;
    for (std::int64_t i = 0; i < a.n; ++i) {
      *overlap = -a.gap[i];
      *rate = -a.gap_rate[i];
      *built_in = a.built_in[i];
      *element = a.element[i];
      *surface = a.surface[i];
      a.force[i] = (*law)();
    }
    return 0;
  };
}

/// ADRX5, and each race of ADRX6.
struct SurfaceLaw {
  std::optional<Formula> radius, curvature_factor;
};
Call surface(Section& section, bool races) {
  double *x = section.known("x"), *psi = section.known("psi"), *i = section.known("i"),
         *n = section.known("n"), *D = section.known("D"), *dm = section.known("dm");
  const Preamble preamble(section);
  auto laws = std::make_shared<std::array<SurfaceLaw, 2>>();
  if (races) {
    for (std::size_t j = 0; j < 2; ++j)
      if (const Json* given = section.find(kRaceKeys[j])) {
        const std::string path = std::string(kRaceKeys[j]) + ", ";
        check_keys(*given, {"radius", "curvature_factor"}, section.where + ", " + kRaceKeys[j]);
        (*laws)[j] = {section.formula(*given, "radius", path),
                      section.formula(*given, "curvature_factor", path)};
      }
  } else {
    (*laws)[0].radius = section.formula(section.json, "radius", "");
    section.used.insert("radius");
  }
  section.check_keys();
  return [=, keep = section.names](adore_call& call) {
    if (preamble(call) || call.mode != ADORE_COMPUTE) return 0;
    auto& a = reinterpret_cast<adore_surface&>(call);
    const SurfaceLaw& law = (*laws)[races ? static_cast<std::size_t>(a.race) : 0];
    *i = a.element;
    *n = call.bearing->elements;
    *D = call.bearing->element_diameter;
    *dm = call.bearing->pitch_diameter;
    for (std::int64_t k = 0; k < a.n; ++k) {
      *x = a.axial[k];
      *psi = a.azimuth[k];
      if (law.radius) a.radius[k] = (*law.radius)();
      if (law.curvature_factor) a.curvature_factor[k] = (*law.curvature_factor)();
    }
    return 0;
  };
}
Call elements(Section& section) { return surface(section, false); }
Call races(Section& section) { return surface(section, true); }

Call traction(Section& section) {
  std::array<double*, 9> in{};
  constexpr std::array kNames{"u", "p", "Q", "p0", "a", "b", "v", "curvature", "u0"};
  for (std::size_t k = 0; k < kNames.size(); ++k) in[k] = section.known(kNames[k]);
  double* race = section.known("race");
  double* t = section.known("t");
  const Preamble preamble(section);
  struct Law {
    std::optional<Formula> formula, scale;
    std::optional<MonotoneTable> table;
  };
  auto laws = std::make_shared<std::array<Law, 5>>();
  constexpr std::array kKinds{"element_race", "element_cage", "cage_race", "roller_flange",
                              "element_element"};
  bool any = false;
  for (std::size_t k = 0; k < kKinds.size(); ++k) {
    const Json* given = section.find(kKinds[k]);
    if (given == nullptr) continue;
    const std::string path = std::string(kKinds[k]) + ", ";
    check_keys(*given, {"formula", "table", "slip_scale"}, section.where + ", " + kKinds[k]);
    Law& law = (*laws)[k];
    law.formula = section.formula(*given, "formula", path);
    law.scale = section.formula(*given, "slip_scale", path);
    if (given->contains("table")) {
      if (!given->at("table").is_string())
        throw InputError(section.where + ", " + path + "table: give the name of a CSV file");
      law.table = read_table(section.folder / given->at("table").get<std::string>());
    }
    if (law.formula.has_value() == law.table.has_value())
      throw InputError(section.where + ", " + kKinds[k] +
                       R"(: give either "formula" (of the slip u) or "table")");
    any = true;
  }
  section.check_keys();
  if (!any)
    throw InputError(
        fmt::format("{}: give at least one of {}", section.where, fmt::join(kKinds, ", ")));
  return [=, keep = section.names](adore_call& call) {
    if (preamble(call)) return 0;
    if (call.mode != ADORE_START && call.mode != ADORE_COMPUTE) return 0;
    auto& a = reinterpret_cast<adore_adrx7&>(call);
    const Law& law = (*laws)[static_cast<std::size_t>(a.kind)];
    if (!law.formula && !law.table)
      throw std::runtime_error(
          fmt::format("the deck needs the traction law {}, but the file does not contain it; add "
                      "it to \"adrx7\"",
                      kKinds[static_cast<std::size_t>(a.kind)]));
    if (call.mode == ADORE_START) {
      a.wants_points = law.formula ? 1 : 0;
      if (law.scale) a.slip_scale = (*law.scale)();
      return 0;
    }
    *race = a.race;
    *t = call.time;
    for (std::int64_t k = 0; k < a.points; ++k)
      for (std::int64_t i = 0; i < a.n; ++i) {
        const std::int64_t at = k * a.stride + i;
        if (law.table) {
          a.kappa[at] = (*law.table)(a.slip[at]);
          continue;
        }
        *in[0] = a.slip[at];
        *in[1] = a.pressure == nullptr ? 0.0 : a.pressure[at];
        const double* of_contact[] = {a.load,        a.peak_pressure, a.half_major, a.half_minor,
                                      a.entrainment, a.curvature,     a.middle_slip};
        for (std::size_t m = 0; m < 7; ++m) *in[m + 2] = of_contact[m][i];
        a.kappa[at] = (*law.formula)();
      }
    return 0;
  };
}

Call material(Section& section) {
  const Preamble preamble(section);
  constexpr std::array kParts{"element", "outer_race", "inner_race", "housing", "shaft", "cage"};
  const std::vector<std::string> keys{
      "density",          "elastic_modulus",     "poisson_ratio",        "thermal_expansion",
      "conductivity",     "specific_heat",       "elastic_strain_limit", "hardness",
      "wear_coefficient", "fatigue_limit_stress"};
  auto given = std::make_shared<std::array<std::array<std::optional<Formula>, 10>, 6>>();
  for (std::size_t part = 0; part < kParts.size(); ++part) {
    const Json* values = section.find(kParts[part]);
    if (values == nullptr) continue;
    check_keys(*values, keys, section.where + ", " + kParts[part]);
    for (std::size_t k = 0; k < keys.size(); ++k)
      (*given)[part][k] = section.formula(*values, keys[k], std::string(kParts[part]) + ", ");
  }
  section.check_keys();
  return [=, keep = section.names](adore_call& call) {
    if (preamble(call) || call.mode != ADORE_COMPUTE) return 0;
    auto& a = reinterpret_cast<adore_adrx0&>(call);
    double* const to = &a.density;
    for (std::size_t k = 0; k < 10; ++k)
      if (const auto& one = (*given)[static_cast<std::size_t>(a.part)][k]) to[k] = (*one)();
    return 0;
  };
}

Call imperfections(Section& section) {
  double *i = section.known("i"), *n = section.known("n");
  const Preamble preamble(section);
  const std::vector<std::string> keys{"diameter",          "crown_radius",     "length",
                                      "central_length",    "land_offset",      "pocket_clearance1",
                                      "pocket_clearance2", "pocket_thickness", "pocket_axial",
                                      "pocket_angular"};
  auto given = std::make_shared<std::vector<std::optional<Formula>>>();
  for (const std::string& key : keys) {
    given->push_back(section.formula(section.json, key, ""));
    section.used.insert(key);
  }
  auto tilt = std::make_shared<std::array<std::optional<Formula>, 3>>(
      vector_of(section, section.json, "pocket_tilt", "", -1));
  auto mass = std::make_shared<std::optional<Formula>>(section.formula(section.json, "mass", ""));
  auto moments = std::make_shared<std::array<std::optional<Formula>, 3>>(
      vector_of(section, section.json, "moments", "", -1));
  auto centre = std::make_shared<std::array<std::optional<Formula>, 3>>(
      vector_of(section, section.json, "geometric_centre", "", -1));
  for (const char* key : {"pocket_tilt", "mass", "moments", "geometric_centre"})
    section.used.insert(key);
  section.check_keys();
  return [=, keep = section.names](adore_call& call) {
    if (preamble(call) || call.mode != ADORE_COMPUTE) return 0;
    auto& a = reinterpret_cast<adore_adrx8&>(call);
    double* const to[] = {a.diameter,          a.crown_radius,     a.length,
                          a.central_length,    a.land_offset,      a.pocket_clearance1,
                          a.pocket_clearance2, a.pocket_thickness, a.pocket_axial,
                          a.pocket_angular};
    *n = static_cast<double>(a.n);
    for (std::int64_t k = 0; k < a.n; ++k) {
      *i = static_cast<double>(k);
      for (std::size_t m = 0; m < given->size(); ++m)
        if ((*given)[m]) to[m][k] = (*(*given)[m])();
      for (std::size_t m = 0; m < 3; ++m)
        if ((*tilt)[m]) a.pocket_tilt[3 * k + static_cast<std::int64_t>(m)] = (*(*tilt)[m])();
    }
    if (*mass) a.mass = (**mass)();
    for (std::size_t m = 0; m < 3; ++m) {
      if ((*moments)[m]) a.moments[m] = (*(*moments)[m])();
      if ((*centre)[m]) a.geometric_centre[m] = (*(*centre)[m])();
    }
    return 0;
  };
}

/// A column of SOL9: a value of a channel of RESULTS.h5.
struct ChannelColumn {
  std::string channel;
  std::int64_t at = 0;  ///< from 0
};
/// "contact.load[3]": value 3 of a channel, from 1; without a number the first.
ChannelColumn column_of(const Json& text, const std::string& where) {
  if (!text.is_string()) throw InputError(where + ": give names such as \"contact.load[3]\"");
  ChannelColumn out{text.get<std::string>(), 0};
  const std::size_t open = out.channel.find('[');
  if (open == std::string::npos) return out;
  char* end = nullptr;
  out.at = std::strtoll(out.channel.c_str() + open + 1, &end, 10) - 1;
  if (out.at < 0 || end == nullptr || std::string(end) != "]")
    throw InputError(
        fmt::format("{}: \"{}\" needs a number of 1 or more in its brackets", where, out.channel));
  out.channel.resize(open);
  return out;
}

/// The heat map of the manual's third example, or a table of channels of RESULTS.h5.
Call step_output(Section& section) {
  const Preamble preamble(section);
  const Json* map = section.find("heat_map");
  const Json* list = section.find("channels");
  section.check_keys();
  const bool heat = map != nullptr && map->is_boolean() && map->get<bool>();
  auto columns = std::make_shared<std::vector<ChannelColumn>>();
  if (list != nullptr && list->is_array())
    for (const Json& one : *list) columns->push_back(column_of(one, section.where + ", channels"));
  if (heat != columns->empty())
    throw InputError(section.where +
                     R"(: give either "heat_map": true, or "channels": ["contact.load[1]", ...])");
  return [=, keep = section.names](adore_call& call) {
    if (preamble(call)) return 0;
    auto& a = reinterpret_cast<adore_adrx9&>(call);
    if (call.mode == ADORE_START) {
      a.wants_channels = heat ? 0 : 1;
      std::string head = heat ? "#       time kind element race          x          y          z"
                                "          a          b         heat"
                              : "# time [s]";
      for (const ChannelColumn& one : *columns)
        head += fmt::format(" {}[{}]", one.channel, one.at + 1);
      call.services->write(call.host, (head + '\n').c_str());
    }
    if (call.mode != ADORE_STEP) return 0;
    for (std::int64_t i = 0; heat && i < a.sources; ++i) {
      char line[200];
      std::snprintf(line, sizeof line,
                    "%12.6e %4d %7d %4d %10.3e %10.3e %10.3e %10.3e %10.3e %12.5e\n", call.time,
                    a.source_kind[i], a.source_element[i] + 1, a.source_race[i] + 1,
                    a.source_place[3 * i], a.source_place[3 * i + 1], a.source_place[3 * i + 2],
                    a.source_size[2 * i], a.source_size[2 * i + 1], a.source_heat[i]);
      call.services->write(call.host, line);
    }
    if (heat) return 0;
    std::string line = fmt::format("{:.9e}", call.time);
    for (const ChannelColumn& one : *columns) {
      const char* const* const end = a.channel_name + a.channels;
      const auto found = std::find(a.channel_name, end, one.channel);
      if (found == end)
        throw std::runtime_error(fmt::format("RESULTS.h5 has no channel \"{}\"", one.channel));
      const auto k = found - a.channel_name;
      if (one.at >= a.channel_size[k])
        throw std::runtime_error(
            fmt::format("channel {}: the last value has the number {}; value {} does not exist",
                        one.channel, a.channel_size[k], one.at + 1));
      line += fmt::format(" {:.17g}", a.channel_value[a.channel_first[k] + one.at]);
    }
    call.services->write(call.host, (line + '\n').c_str());
    return 0;
  };
}

}  // namespace

PlugIn load_formulas(const fs::path& file) {
  const Json json = parse_json(read_text_file(file, kMaxHandwrittenBytes), file.string());
  if (!json.is_object())
    throw InputError(file.string() +
                     ": give a JSON object, e.g. {\"adrx7\": {\"element_race\": {\"formula\": "
                     "\"0.06*tanh(u/0.2)\"}}}");
  PlugIn out;
  out.source = file.string();
  out.pure = true;
  const std::map<std::string, std::pair<int, Call (*)(Section&)>> makers{
      {"adrx0", {0, material}},   {"adrx1", {1, motion}},   {"adrx2", {2, force}},
      {"adrx3", {3, force}},      {"adrx4", {4, force}},    {"adrx5", {5, elements}},
      {"adrx6", {6, races}},      {"adrx7", {7, traction}}, {"adrx8", {8, imperfections}},
      {"adrx9", {9, step_output}}};
  bool any = false;
  for (const auto& [key, value] : json.items()) {
    if (key == "version") {
      if (!value.is_string())
        throw InputError(fmt::format("{}, version: give a text", file.string()));
      out.version = value.get<std::string>();
      continue;
    }
    const auto found = makers.find(key);
    if (found == makers.end()) {
      std::string known = "version";
      for (const auto& [name, maker] : makers) known += ", " + name;
      throw InputError(
          fmt::format("{}: \"{}\" is not known; known names: {}", file.string(), key, known));
    }
    Section section(file, key, value);
    out.hooks[static_cast<std::size_t>(found->second.first)] = found->second.second(section);
    any = true;
  }
  if (!any) throw InputError(fmt::format("{}: the file contains no routine", file.string()));
  return out;
}

}  // namespace adore::user
