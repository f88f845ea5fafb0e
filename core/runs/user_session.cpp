#include "runs/user_session.hpp"

#include "base/version.hpp"
#include "setup/race_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace adore::runs {
namespace {

/// Kinds of contact whose law the deck hands to ADRX7.
std::array<bool, 5> uses_traction_routine(const deck::Deck& deck) {
  constexpr std::array kCodes{"kTrac", "kCPTrac", "kCRTrac", "kRFTrac", "kRRTrac"};
  std::array<bool, 5> out{};
  for (std::size_t k = 0; k < kCodes.size(); ++k)
    out[k] = deck.has(kCodes[k]) && deck.integer(kCodes[k]) == -1;
  return out;
}

/// Directions in which ADRX1 gives loads at times of two revolutions, at no even distance.
std::array<std::array<bool, 6>, 2> find_routine_loads(const Prepared& prepared) {
  constexpr int kSampledTimes = 64;
  const double speed =
      std::max(std::abs(prepared.bearing.speed[0]), std::abs(prepared.bearing.speed[1]));
  std::vector<double> times{0.0};
  for (int k = 1; k <= kSampledTimes; ++k)
    times.push_back(4.0 * std::numbers::pi / std::max(speed, 1.0) *
                    std::fmod(0.6180339887498949 * k, 1.0));
  const auto loads = prepared.user->loads(times);
  if (!prepared.user->failure().empty()) throw InputError(prepared.user->failure());
  return loads;
}

}  // namespace

std::shared_ptr<user::Session> open_user_session(const LoadedDeck& input,
                                                 const setup::RunOptions& options) {
  if (input.user.empty() && !input.routines) return nullptr;
  user::PlugIn plug_in = input.routines ? *input.routines
                         : options.user_process
                             ? user::load_in_own_process(input.user, options.user_timeout)
                             : user::load_plug_in(input.user);
  auto session = std::make_shared<user::Session>(std::move(plug_in), input.deck.user_lines,
                                                 user::SessionOptions{options.user_sample});
  return session;
}

setup::UserHooks user_hooks(const std::shared_ptr<user::Session>& session,
                            const setup::RunOptions& options) {
  setup::UserHooks out;
  if (!session) return out;
  out.slices = options.rollers.slices;
  out.points = options.rollers.contact == statics::RollerContact::Point;
  out.source = session->source();
  for (std::size_t k = 0; k < out.active.size(); ++k)
    out.active[k] = session->active(static_cast<int>(k));
  user::Session* const of = session.get();
  out.material = [of](bearing::Part part, const bearing::Material& fallback) {
    return of->material(part, fallback);
  };
  out.imperfections = [of](bearing::UserTables& tables) { of->call_imperfections(tables); };
  out.surface = [of](const bearing::Bearing& bearing, bearing::UserSurface& places) {
    of->surface(bearing, places);
  };
  out.out_of_round = [of](std::size_t k, std::shared_ptr<const bearing::SurfaceSeries> form) {
    of->add_out_of_round_element(k, std::move(form));
  };
  out.document = [of](int hook, const std::string& line) { of->document(hook, line); };
  return out;
}

void start_user_session(Prepared& prepared, setup::UserHooks& hooks) {
  user::Session& session = *prepared.user;
  std::array<bool, 3> balanced{};  // mode 2: directions in which the load places the inner race
  if (prepared.input.deck.integer("mode") == 2)
    for (std::size_t k = 0; k < 3; ++k)
      balanced[k] = !prepared.bearing.constraints.displacement_given[k];
  session.start(prepared.bearing, uses_traction_routine(prepared.input.deck), balanced);
  hooks.drives = session.drives();
  hooks.moves_frame = session.moves_frame();
  hooks.suppressed = session.suppressed();
  hooks.balls_out_of_round =
      prepared.bearing.rollers() == nullptr && session.has_out_of_round_elements();
  if (session.active(4) && prepared.bearing.cage) {
    const auto& lands = prepared.bearing.cage->lands;
    if (std::any_of(lands.begin(), lands.end(),
                    [](const bearing::GuideLand& land) { return !land.ideal(); }))
      throw InputError({prepared.input.deck.issue(
          Severity::Error,
          prepared.input.deck.integer("kCageGsImp") != 0 ? "kCageGsImp" : "kRaceGsImp",
          fmt::format("gives guide lands shape errors: the gap then varies along the contact, but "
                      "user routine ADRX4 of {} needs a single gap",
                      session.source()),
          "set kCageGsImp and kRaceGsImp to 0, or omit the routine")});
  }
  const auto law_of_time = [&](const char* variable) {
    return prepared.input.deck.integer(variable) != 0;
  };
  for (const char* variable : {"kVarLoad", "kVarSpeed"})
    if ((hooks.drives[0] || hooks.drives[1]) && law_of_time(variable))
      throw InputError({prepared.input.deck.issue(
          Severity::Error, variable,
          fmt::format("prescribes a motion of the races, but user routine ADRX1 of {} also drives "
                      "a race",
                      session.source()),
          fmt::format("set {} to 0, or do not drive the race in the routine", variable))});
  prepared.options.system.user = session.laws(prepared.user);
}

std::vector<std::string> unused_routines(const Prepared& prepared) {
  const user::Session& session = *prepared.user;
  std::vector<std::string> out;
  const auto idle = [&](int hook, const std::string& why) {
    if (session.active(hook))
      out.push_back(fmt::format("user routine {} of {} is active but has no effect here: {}",
                                user::hook_name(hook), session.source(), why));
  };
  const deck::Deck& deck = prepared.input.deck;
  const auto asks = [&](const char* variable, long long code) {
    return deck.has(variable) && deck.integer(variable) == code;
  };
  if (!asks("kRaceGeoImp1", 3) && !asks("kRaceGeoImp2", 3))
    idle(6, "the deck does not use user-defined races (kRaceGeoImp1, kRaceGeoImp2 = 3)");
  if (session.has_out_of_round_elements())
    out.push_back(
        fmt::format("user routine ADRX5 of {} gives out-of-round {}: in motion the shapes rotate "
                    "with the elements, but the equilibrium uses the mean radius",
                    session.source(), prepared.bearing.rollers() != nullptr ? "rollers" : "balls"));
  if (!prepared.control.dynamic) {
    for (const int hook : {1, 2, 3, 4, 7, 9})
      idle(hook,
           "the routine acts only in a simulation of the motion, but mode = -1 computes only the "
           "equilibrium");
    return out;
  }
  bool free = false;
  for (const int race : {1, 2})
    for (const int axis : {1, 2, 3})
      free = free || setup::is_translation_free(deck, axis, race) ||
             setup::is_rotation_free(deck, axis, race);
  if (session.active(1) && !session.drives()[0] && !session.drives()[1] && !session.moves_frame() &&
      !session.suppressed().any() && !free &&
      find_routine_loads(prepared) == std::array<std::array<bool, 6>, 2>{})
    idle(1,
         "the routine applies no load at the sampled times, drives no race and does not move the "
         "base frame");
  const bearing::RollerGeometry* const rollers = prepared.bearing.rollers();
  if (rollers == nullptr || (!rollers->has_flange(0) && !rollers->has_flange(1)))
    idle(2, "the bearing has no flanges");
  if (!prepared.bearing.cage) {
    idle(3, "the bearing has no cage");
    idle(4, "the bearing has no cage");
  } else if (prepared.bearing.cage->lands.empty()) {
    idle(4, "no race guides the cage");
  }
  const std::array<bool, 5> traction = uses_traction_routine(prepared.input.deck);
  if (std::none_of(traction.begin(), traction.end(), [](bool asked) { return asked; }))
    idle(7, "the deck does not use user-defined traction (kTrac = -1, kCPTrac = -1 ...)");
  return out;
}

std::vector<Issue> loads_on_fixed_races(const Prepared& prepared) {
  user::Session& session = *prepared.user;
  std::vector<Issue> out;
  if (!session.active(1)) return out;
  const deck::Deck& deck = prepared.input.deck;
  const auto loads = find_routine_loads(prepared);
  const long long mode = deck.integer("mode");
  for (std::size_t j = 0; j < 2; ++j) {
    std::string where;
    bool force = false;
    for (std::size_t k = 0; k < 6; ++k) {
      const int axis = static_cast<int>(k % 3) + 1, race = static_cast<int>(j) + 1;
      const bool balanced =
          mode == 2 && j == 1 && k < 3 && !prepared.bearing.constraints.displacement_given[k];
      const bool free = k < 3 ? setup::is_translation_free(deck, axis, race)
                              : setup::is_rotation_free(deck, axis, race);
      if (!loads[j][k] || balanced || free) continue;
      force = force || k < 3;
      where += fmt::format("{}{} {}", where.empty() ? "" : ", ", k < 3 ? "along" : "about",
                           "xyz"[k % 3]);
    }
    if (where.empty()) continue;
    out.push_back(deck.issue(
        Severity::Warning, mode == 2 ? "mode" : "kDCR",
        fmt::format(
            "fixes the {} race {}, but user routine ADRX1 of {} applies a load in this direction. "
            "The support of the race carries this load, so the load does not move the race. PRINT "
            "and SOL contain the reaction, and the energy ledger contains the work",
            j == 0 ? "outer" : "inner", where, session.source()),
        mode == 2 ? "set mode to 0 or 1 and kDCR to 1"
        : j == 1 && force
            ? "set kDCR to 1 and set kFD or kMD to 0 for these directions, or set mode to 2"
            : "set kDCR to 1 and set kFD or kMD to 0 for these directions"));
  }
  return out;
}

std::string program_version(const user::Session* session) {
  std::string out(kProgramVersion);
  if (session == nullptr || session->version().empty()) return out;
  out += '+';
  for (const char c : session->version()) out += c < ' ' ? ' ' : c;
  return out;
}

std::string add_routine_message(const user::Session& session, const std::string& message) {
  if (!session.failure().empty())
    return fmt::format("{}. The files are valid up to the last stored step", session.failure());
  if (!session.refusal().empty()) return fmt::format("{} ({})", message, session.refusal());
  return message;
}

void throw_start_failure(const Prepared& prepared, const SolverError& error) {
  if (!prepared.user) throw error;
  const std::string& failure = prepared.user->failure();
  throw SolverError(failure.empty() ? add_routine_message(*prepared.user, error.what()) : failure);
}

}  // namespace adore::runs
