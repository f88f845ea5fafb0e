#include "user/session.hpp"

#include "base/errors.hpp"
#include "user/crash_guard.hpp"
#include "user/heat_sources.hpp"
#include "user/host.hpp"
#include "user/routine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

namespace adore::user {
namespace {

using Vec3 = Eigen::Vector3d;

void put(double* to, const Vec3& v) {
  for (int k = 0; k < 3; ++k) to[k] = v[k];
}
Vec3 get(const double* from) { return {from[0], from[1], from[2]}; }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

}  // namespace

struct Session::Impl {
  PlugIn plug_in;
  Host host;
  std::optional<CrashGuard> guard;
  std::array<std::optional<UserRoutine>, kHooks> routines;
  adore_bearing bearing{};
  HeatSources::Geometry geometry;
  std::vector<std::shared_ptr<const bearing::SurfaceSeries>> out_of_round;  ///< ADRX5, by roller
  std::vector<std::string> documentation;
  std::string written, failure, refusal;
  std::array<bool, 2> surface_started{};  ///< ADRX5, ADRX6
  bool refused = false, wants_channels = false;
  std::uint64_t step = 0;

  // ADRX7 by kind.
  struct Traction {
    Impl* of = nullptr;
    adore_adrx7 args{};
    tribology::UserTractionRoutine shown;
  };
  std::array<Traction, 5> traction;
  std::array<bool, 5> has_traction{};

  // ADRX1.
  adore_adrx1 motion{};
  scene::UserMotion::MotionDeclaration motion_declaration;
  scene::SuppressedMotions suppressed;
  std::array<bool, 3> balanced{};  ///< directions in which the load places the inner race

  /// What the solver sees.
  struct Laws final : scene::UserLaws, scene::UserMotion {
    explicit Laws(std::shared_ptr<Session> session) : session_(std::move(session)) {}
    [[nodiscard]] bool failed() const noexcept override { return !impl().failure.empty(); }
    bool refused() noexcept override { return std::exchange(impl().refused, false); }
    [[nodiscard]] const MotionDeclaration& motion_declaration() const noexcept override {
      return impl().motion_declaration;
    }
    bool evaluate(double t, const std::array<Race, 2>& races, Actions& out) noexcept override {
      return impl().evaluate_motion(t, races, out);
    }
    [[nodiscard]] Impl& impl() const noexcept { return *session_->impl_; }

   private:
    std::shared_ptr<Session> session_;
  };
  struct Force final : scene::UserContactForce {
    Impl* of = nullptr;
    int hook = 0;
    bool forces(double t, const Contacts& c) noexcept override {
      adore_force a{};
      a.call.time = t;
      a.n = static_cast<std::int64_t>(c.n);
      a.element = c.element;
      a.surface = c.surface;
      a.gap = c.gap;
      a.gap_rate = c.gap_rate;
      a.built_in = c.built_in;
      a.force = c.force;
      return of->compute(hook, a);
    }
  };
  std::array<Force, 3> force;
  Laws* laws = nullptr;  ///< whose time calls have; null: nobody simulates

  Impl(PlugIn p, const std::vector<std::string>& lines) : plug_in(std::move(p)), host(lines) {
    if (plug_in.foreign) guard.emplace();
  }

  template <class Arguments>
  Answer ask(int hook, Arguments& a, int mode) {
    a.call.mode = mode;
    a.call.step = static_cast<std::int64_t>(step);
    UserRoutine& routine = *routines[static_cast<std::size_t>(hook)];
    const Answer answer = routine.ask(a.call, static_cast<std::int32_t>(sizeof(Arguments)));
    if (answer == Answer::Failed && failure.empty()) failure = routine.reason();
    if (answer == Answer::Refused) {
      refused = true;
      refusal = routine.reason();
    }
    return answer;
  }
  /// Of the right-hand side.
  template <class Arguments>
  bool compute(int hook, Arguments& a) noexcept {
    return ask(hook, a, ADORE_COMPUTE) == Answer::Good;
  }
  /// Outside of it: what is not good is the user's error.
  template <class Arguments>
  void ask_or_refuse(int hook, Arguments& a, int mode) {
    if (ask(hook, a, mode) != Answer::Good)
      throw InputError(routines[static_cast<std::size_t>(hook)]->reason());
  }
  [[nodiscard]] bool active(int hook) const {
    const auto& routine = routines[static_cast<std::size_t>(hook)];
    return routine && routine->active();
  }
  /// Calls `visit` with zeroed arguments of the hook.
  template <class Visit>
  static void with_arguments(int hook, Visit&& visit) {
    const auto with = [&visit](auto arguments) { visit(arguments); };
    switch (hook) {
      case 0:
        return with(adore_adrx0{});
      case 1:
        return with(adore_adrx1{});
      case 2:
      case 3:
      case 4:
        return with(adore_force{});
      case 5:
      case 6:
        return with(adore_surface{});
      case 7:
        return with(adore_adrx7{});
      case 8:
        return with(adore_adrx8{});
      default:
        return with(adore_adrx9{});
    }
  }

  void document(int hook) {
    for (std::string& line : lines_of(host.block().print.take()))
      documentation.push_back(fmt::format("{}: {}", hook_name(hook), line));
    written += host.block().write.take();
  }

  void describe(const bearing::Bearing& from);
  bool evaluate_motion(double t, const std::array<scene::UserMotion::Race, 2>& races,
                       scene::UserMotion::Actions& out) noexcept;
  static void ask_traction(void* self, const tribology::UserTractionInput& in);
  void start_traction(std::size_t kind);
  void start_motion();
};

void Session::Impl::describe(const bearing::Bearing& from) {
  geometry = HeatSources::geometry_of(from);
  bearing.elements = from.element_count();
  bearing.rollers = from.rollers() != nullptr ? 1 : 0;
  bearing.element_diameter = from.element_diameter();
  bearing.pitch_diameter = from.pitch_diameter();
  bearing.element_mass = from.element_inertia.mass;
  for (std::size_t j = 0; j < 2; ++j) bearing.race_speed[j] = from.speed[j];
  for (auto& routine : routines)
    if (routine) routine->bearing = &bearing;
}

bool Session::Impl::evaluate_motion(double t, const std::array<scene::UserMotion::Race, 2>& races,
                                    scene::UserMotion::Actions& out) noexcept {
  adore_adrx1 a = motion;
  a.call.time = t;
  for (std::size_t j = 0; j < 2; ++j) {
    put(a.position + 3 * j, races[j].position);
    put(a.velocity + 3 * j, races[j].velocity);
    put(a.omega + 3 * j, races[j].omega);
    a.angle[j] = races[j].angle;
  }
  const bool good = compute(1, a);
  if (!good) a = motion;
  for (std::size_t j = 0; j < 2; ++j) {
    out.force[j] = get(a.force + 3 * j);
    out.moment[j] = get(a.moment + 3 * j);
    out.acceleration[j] = get(a.acceleration + 3 * j);
    out.angular_acceleration[j] = get(a.angular_acceleration + 3 * j);
  }
  out.frame = get(a.frame_acceleration);
  out.frame_omega = get(a.frame_omega);
  out.frame_turn = get(a.frame_angular_acceleration);
  const Vec3 turn = out.frame_omega.cwiseAbs() + out.frame_turn.cwiseAbs();
  const auto wrong = [&](std::string text) {
    if (failure.empty())
      failure = fmt::format("user routine ADRX1 of {}, at t = {:.9g} s: {}", plug_in.source, t,
                            std::move(text));
    return false;
  };
  if (good && !motion_declaration.moves_frame && !(out.frame.isZero(0.0) && turn.isZero(0.0)))
    return wrong(
        "the routine moves the base frame, but moves_frame is 0; set moves_frame = 1 in mode "
        "ADORE_START");
  if (!good || !motion_declaration.drives[1] || !(balanced[0] || balanced[1] || balanced[2]))
    return good;
  for (int k = 0; k < 3; ++k)
    if (balanced[static_cast<std::size_t>(k)] && out.acceleration[1][k] != 0.0)
      return wrong(
          fmt::format("the routine accelerates the inner race along {} by {:.6g} m/s^2, but mode = "
                      "2 computes the position of the race in this direction from the load; give a "
                      "force instead, or set mode to 0 or 1",
                      "xyz"[k], out.acceleration[1][k]));
  if (out.angular_acceleration[1][1] != 0.0 || out.angular_acceleration[1][2] != 0.0)
    return wrong(
        "the routine tilts the inner race, but mode = 2 keeps the tilt fixed; set mode to 0 or 1");
  return good;
}

void Session::Impl::ask_traction(void* self, const tribology::UserTractionInput& in) {
  auto& traction = *static_cast<Traction*>(self);
  adore_adrx7 a = traction.args;
  a.call.time = traction.of->laws != nullptr ? traction.of->laws->time : 0.0;
  a.kind = in.kind;
  a.race = in.race;
  a.n = in.n;
  a.points = in.points;
  a.stride = in.stride;
  a.slip = in.slip;
  a.pressure = in.pressure;
  a.load = in.load;
  a.peak_pressure = in.peak_pressure;
  a.half_major = in.half_major;
  a.half_minor = in.half_minor;
  a.entrainment = in.entrainment;
  a.curvature = in.curvature;
  a.middle_slip = in.middle_slip;
  a.kappa = in.kappa;
  if (!traction.of->compute(7, a)) std::fill_n(in.kappa, in.points * in.stride, 0.0);
}

void Session::Impl::start_traction(std::size_t kind) {
  Traction& t = traction[kind];
  t.of = this;
  t.args.kind = static_cast<std::int32_t>(kind);
  t.args.race = -1;
  adore_adrx7 a = t.args;
  a.wants_points = 1;
  ask_or_refuse(7, a, ADORE_START);
  document(7);
  if (!(a.slip_scale >= 0.0))
    throw InputError(
        fmt::format("user routine ADRX7 of {}: slip_scale is {}; give a slip speed above 0, or 0 "
                    "for no slip scale",
                    plug_in.source, a.slip_scale));
  t.shown = {&t, &Impl::ask_traction, a.slip_scale, 0.0, a.wants_points != 0};
  // κ at rest decides whether slip is rounded.
  const double still = 1e-12, load = 1.0, pressure = 1e9, size = 1e-4, none = 0.0;
  double kappa = 0.0;
  ask_traction(&t, {static_cast<int>(kind), -1, 1, 1, 1, &still, &pressure, &load, &pressure, &size,
                    &size, &none, &none, &still, &kappa});
  if (!failure.empty()) throw InputError(failure);
  refused = false;
  t.shown.at_rest = std::abs(kappa) > 1e-9 ? kappa : 0.0;
}

void Session::Impl::start_motion() {
  motion = {};
  ask_or_refuse(1, motion, ADORE_START);
  document(1);
  const adore_adrx1& a = motion;
  for (std::size_t j = 0; j < 2; ++j) {
    motion_declaration.drives[j] = a.drives[j] != 0;
    motion_declaration.start_velocity[j] = get(a.start_velocity + 3 * j);
    motion_declaration.start_spin[j] = a.start_spin[j];
    if (!motion_declaration.drives[j] && (!motion_declaration.start_velocity[j].isZero(0.0) ||
                                          motion_declaration.start_spin[j] != 0.0))
      throw InputError(
          fmt::format("user routine ADRX1 of {} gives the {} race a start velocity or spin, but "
                      "does not drive this race; set drives[{}] = 1",
                      plug_in.source, j == 0 ? "outer" : "inner", j));
  }
  motion_declaration.moves_frame = a.moves_frame != 0;
  motion_declaration.longest_step = std::max(a.longest_step, 0.0);
  motion_declaration.kinks.assign(a.kinks, a.kinks + std::clamp(a.kink_count, 0, 8));
  suppressed = {a.suppress_element_axial != 0, a.suppress_element_tilt != 0,
                a.suppress_element_all != 0, a.suppress_cage_axial != 0, a.suppress_cage_tilt != 0};
  std::fill_n(motion.force, 6, 0.0);
  std::fill_n(motion.moment, 6, 0.0);
  std::fill_n(motion.acceleration, 6, 0.0);
  std::fill_n(motion.angular_acceleration, 6, 0.0);
  for (double* three :
       {motion.frame_acceleration, motion.frame_omega, motion.frame_angular_acceleration})
    std::fill_n(three, 3, 0.0);
  for (std::size_t k = 0; k < 3; ++k)
    if (balanced[k] && motion_declaration.drives[1] &&
        motion_declaration.start_velocity[1][static_cast<int>(k)] != 0.0)
      throw InputError(
          fmt::format("user routine ADRX1 of {} gives the inner race a start velocity along {}, "
                      "but mode = 2 computes the position of the race in this direction from the "
                      "load; set this component of start_velocity to 0, or set mode to 0 or 1",
                      plug_in.source, "xyz"[k]));
}

Session::Session(PlugIn plug_in, const std::vector<std::string>& lines,
                 const SessionOptions& options)
    : impl_(std::make_unique<Impl>(std::move(plug_in), lines)) {
  Impl& s = *impl_;
  std::string readers;
  for (int k = 0; k < static_cast<int>(kHooks); ++k) {
    if (!s.plug_in.has(k)) continue;
    const auto i = static_cast<std::size_t>(k);
    s.routines[i].emplace(k, s.plug_in, s.host, options.sample);
    Impl::with_arguments(k, [&](auto& a) { s.ask_or_refuse(k, a, ADORE_READ); });
    readers += (readers.empty() ? "" : ", ") + hook_name(k);
    (void)s.host.block().print.take();
    if (k == 0 || k == 8) {
      if (!s.active(k)) continue;
      Impl::with_arguments(k, [&](auto& a) { s.ask_or_refuse(k, a, ADORE_START); });
      s.document(k);
    }
  }
  if (const std::size_t read = s.host.block().line; read < lines.size())
    throw InputError(
        fmt::format("no user routine read {} of the {} lines of records 12.x; the first of them is "
                    "\"{}\" (routines {} of {} read in this order). Remove these lines, or let a "
                    "user routine read them",
                    lines.size() - read, lines.size(), lines[read], readers, s.plug_in.source));
}
Session::~Session() = default;

bool Session::active(int hook) const noexcept { return impl_->active(hook); }
const std::string& Session::source() const noexcept { return impl_->plug_in.source; }
const std::string& Session::version() const noexcept { return impl_->plug_in.version; }

bearing::Material Session::material(bearing::Part part, const bearing::Material& fallback) {
  adore_adrx0 a{};
  a.part = static_cast<std::int32_t>(part);
  a.density = fallback.density;
  a.elastic_modulus = fallback.elastic_modulus;
  a.poisson_ratio = fallback.poisson_ratio;
  a.thermal_expansion = fallback.thermal_expansion;
  a.conductivity = fallback.conductivity;
  a.specific_heat = fallback.specific_heat;
  a.elastic_strain_limit = fallback.elastic_strain_limit;
  a.hardness = fallback.hardness;
  a.wear_coefficient = fallback.wear_coefficient;
  a.fatigue_limit_stress = fallback.fatigue_limit_stress;
  impl_->ask_or_refuse(0, a, ADORE_COMPUTE);
  const auto check = [&](const char* name, double value, bool good, const char* valid) {
    if (!good)
      throw InputError(fmt::format(
          "user routine ADRX0 of {}, part {}: {} = {:g} is not a valid material property; give {}",
          source(), a.part, name, value, valid));
  };
  check("density", a.density, a.density > 0.0, "a value above 0 kg/m^3");
  check("elastic_modulus", a.elastic_modulus, a.elastic_modulus > 0.0, "a value above 0 Pa");
  check("poisson_ratio", a.poisson_ratio, a.poisson_ratio >= 0.0 && a.poisson_ratio < 0.5,
        "a value of 0 or more and below 0.5");
  check("hardness", a.hardness, a.hardness >= 0.0, "0 Pa or more");
  bearing::Material out;
  out.code = 2;
  out.name = "from user routine ADRX0";
  out.density = a.density;
  out.elastic_modulus = a.elastic_modulus;
  out.poisson_ratio = a.poisson_ratio;
  out.thermal_expansion = a.thermal_expansion;
  out.conductivity = a.conductivity;
  out.specific_heat = a.specific_heat;
  out.elastic_strain_limit = a.elastic_strain_limit;
  out.hardness = a.hardness;
  out.wear_coefficient = a.wear_coefficient;
  out.fatigue_limit_stress = a.fatigue_limit_stress;
  out.provenance = "deck";
  return out;
}

void Session::call_imperfections(bearing::UserTables& t) {
  adore_adrx8 a{};
  a.elements_wanted = t.elements ? 1 : 0;
  a.pockets_wanted = t.pockets ? 1 : 0;
  a.inertia_wanted = t.inertia ? 1 : 0;
  a.n = static_cast<std::int64_t>(t.diameter.size());
  a.diameter = t.diameter.data();
  a.crown_radius = t.crown_radius.data();
  a.length = t.length.data();
  a.central_length = t.central_length.data();
  a.land_offset = t.land_offset.data();
  a.pocket_clearance1 = t.pocket_clearance_1.data();
  a.pocket_clearance2 = t.pocket_clearance_2.data();
  a.pocket_thickness = t.pocket_thickness.data();
  a.pocket_axial = t.pocket_axial.data();
  a.pocket_angular = t.pocket_angular.data();
  a.pocket_tilt = t.pocket_tilt.data();
  a.mass = t.mass;
  put(a.moments, t.moments);
  put(a.geometric_centre, t.geometric_centre);
  put(a.frame, t.frame);
  impl_->ask_or_refuse(8, a, ADORE_COMPUTE);
  if (t.inertia &&
      !(a.mass > 0.0 && a.moments[0] > 0.0 && a.moments[1] > 0.0 && a.moments[2] > 0.0))
    throw InputError(fmt::format(
        "user routine ADRX8 of {} gives elements a mass of {:g} kg and moments of inertia of {:g}, "
        "{:g}, {:g} kg m^2; all four must be above 0",
        source(), a.mass, a.moments[0], a.moments[1], a.moments[2]));
  t.mass = a.mass;
  t.moments = get(a.moments);
  t.geometric_centre = get(a.geometric_centre);
  t.frame = get(a.frame);
}

void Session::surface(const bearing::Bearing& bearing, bearing::UserSurface& places) {
  Impl& s = *impl_;
  const int hook = places.race < 0 ? 5 : 6;
  if (!std::exchange(s.surface_started[static_cast<std::size_t>(hook - 5)], true)) {
    s.describe(bearing);
    adore_surface a{};
    s.ask_or_refuse(hook, a, ADORE_START);
    s.document(hook);
  }
  adore_surface a{};
  a.race = places.race;
  a.element = places.element;
  a.n = static_cast<std::int64_t>(places.axial.size());
  a.axial = places.axial.data();
  a.azimuth = places.azimuth.data();
  a.radius = places.radius.data();
  a.curvature_factor = places.curvature_factor.data();
  s.ask_or_refuse(hook, a, ADORE_COMPUTE);
}

void Session::add_out_of_round_element(std::size_t k,
                                       std::shared_ptr<const bearing::SurfaceSeries> form) {
  auto& all = impl_->out_of_round;
  if (all.empty())
    document(5,
             "out-of-round elements: in equilibria and at the start of a motion the z axis of each "
             "element points outward");
  if (all.size() <= k) all.resize(k + 1);
  all[k] = std::move(form);
}

bool Session::has_out_of_round_elements() const noexcept { return !impl_->out_of_round.empty(); }

std::span<const std::shared_ptr<const bearing::SurfaceSeries>> Session::out_of_round()
    const noexcept {
  return impl_->out_of_round;
}

void Session::document(int hook, const std::string& line) {
  impl_->documentation.push_back(fmt::format("{}: {}", hook_name(hook), line));
}

std::array<std::array<bool, 6>, 2> Session::loads(const std::vector<double>& times) {
  std::array<std::array<bool, 6>, 2> out{};
  std::array<scene::UserMotion::Race, 2> races;
  for (std::size_t j = 0; j < 2; ++j) races[j].omega[0] = impl_->bearing.race_speed[j];
  for (const double t : times) {
    for (std::size_t j = 0; j < 2; ++j) races[j].angle = impl_->bearing.race_speed[j] * t;
    scene::UserMotion::Actions actions;
    if (!impl_->evaluate_motion(t, races, actions)) break;
    for (std::size_t j = 0; j < 2; ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        out[j][k] = out[j][k] || actions.force[j][static_cast<int>(k)] != 0.0;
        out[j][3 + k] = out[j][3 + k] || actions.moment[j][static_cast<int>(k)] != 0.0;
      }
  }
  impl_->refused = false;  // the run meets it at its own times
  return out;
}

void Session::start(const bearing::Bearing& bearing, const std::array<bool, 5>& traction,
                    const std::array<bool, 3>& balanced) {
  Impl& s = *impl_;
  s.balanced = balanced;
  s.describe(bearing);
  for (int k = 1; k < static_cast<int>(kHooks); ++k) {
    if (!s.active(k) || k == 5 || k == 6 || k == 8) continue;
    if (k == 1) {
      s.start_motion();
    } else if (k == 7) {
      s.has_traction = traction;
      for (std::size_t kind = 0; kind < traction.size(); ++kind)
        if (traction[kind]) s.start_traction(kind);
    } else {
      Impl::with_arguments(k, [&](auto& a) {
        s.ask_or_refuse(k, a, ADORE_START);
        if constexpr (std::is_same_v<std::decay_t<decltype(a)>, adore_adrx9>)
          s.wants_channels = a.wants_channels != 0;
      });
      s.document(k);
    }
  }
}

const scene::SuppressedMotions& Session::suppressed() const noexcept { return impl_->suppressed; }

const std::array<bool, 2>& Session::drives() const noexcept {
  return impl_->motion_declaration.drives;
}

bool Session::moves_frame() const noexcept { return impl_->motion_declaration.moves_frame; }

std::shared_ptr<scene::UserLaws> Session::laws(std::shared_ptr<Session> self) {
  Impl& s = *impl_;
  auto out = std::make_shared<Impl::Laws>(std::move(self));
  s.laws = out.get();
  for (std::size_t kind = 0; kind < s.traction.size(); ++kind)
    if (s.active(7) && s.has_traction[kind]) out->traction[kind] = &s.traction[kind].shown;
  if (s.active(1)) out->motion = out.get();
  out->out_of_round = s.out_of_round;
  if (!out->out_of_round.empty())
    out->out_of_round.resize(static_cast<std::size_t>(s.bearing.elements));
  scene::UserContactForce** const places[] = {&out->flange, &out->pocket, &out->land};
  for (int k = 0; k < 3; ++k) {
    if (!s.active(2 + k)) continue;
    Impl::Force& force = s.force[static_cast<std::size_t>(k)];
    force.of = &s;
    force.hook = 2 + k;
    *places[k] = &force;
  }
  return out;
}

const std::vector<std::string>& Session::documentation() const noexcept {
  return impl_->documentation;
}

std::vector<std::string> Session::print(long step, double time) {
  Impl& s = *impl_;
  s.step = static_cast<std::uint64_t>(step);
  std::vector<std::string> out;
  for (int k = 0; k < static_cast<int>(kHooks); ++k) {
    if (!s.active(k)) continue;
    Impl::with_arguments(k, [&](auto& a) {
      a.call.time = time;
      (void)s.ask(k, a, ADORE_PRINT);
    });
    if (!s.failure.empty()) throw SolverError(s.failure);
    for (std::string& line : lines_of(s.host.block().print.take()))
      out.push_back(fmt::format("{}: {}", hook_name(k), line));
  }
  return out;
}

void Session::step(long step, double time) {
  Impl& s = *impl_;
  s.step = static_cast<std::uint64_t>(step);
  for (int k = 0; k < static_cast<int>(kHooks) - 1; ++k) {
    if (!s.active(k)) continue;
    Impl::with_arguments(k, [&](auto& a) {
      a.call.time = time;
      (void)s.ask(k, a, ADORE_STEP);
    });
    if (!s.failure.empty()) throw SolverError(s.failure);
  }
}

bool Session::wants_channels() const noexcept { return impl_->wants_channels; }

std::string Session::step(const scene::Snapshot& snapshot, const Channels& channels) {
  Impl& s = *impl_;
  step(snapshot.step, snapshot.time);
  if (!s.active(9)) return s.host.block().write.take();
  const HeatSources sources(snapshot, s.geometry);
  adore_adrx9 a = sources.arguments();
  a.call.time = snapshot.time;
  a.wants_channels = s.wants_channels ? 1 : 0;
  a.channels = static_cast<std::int64_t>(channels.name.size());
  a.channel_name = channels.name.data();
  a.channel_size = channels.size.data();
  a.channel_first = channels.first.data();
  a.channel_values = static_cast<std::int64_t>(channels.value.size());
  a.channel_value = channels.value.data();
  (void)s.ask(9, a, ADORE_STEP);
  if (!s.failure.empty()) throw SolverError(s.failure);
  if (s.host.block().write.lost)
    throw SolverError(
        fmt::format("user routine ADRX9 of {} wrote more than 1 MiB in the step at t = {:.9g} s; "
                    "write less text in each step",
                    source(), snapshot.time));
  return s.host.block().write.take();
}

std::string Session::take_sol9_text() { return std::exchange(impl_->written, {}); }

const std::string& Session::failure() const noexcept { return impl_->failure; }
const std::string& Session::refusal() const noexcept { return impl_->refusal; }

std::vector<Use> Session::uses() const {
  std::vector<Use> out;
  for (const auto& routine : impl_->routines)
    if (routine && routine->active()) out.push_back({routine->hook(), routine->calls()});
  return out;
}

}  // namespace adore::user
