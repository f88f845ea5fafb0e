#include "facade/user_session.hpp"

#include "base/version.hpp"
#include "setup/race_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace adore::facade {
namespace {

/// Kinds of contact whose law the deck hands to ADRX7.
std::array<bool, 5> own_traction(const deck::Deck& deck) {
  constexpr std::array kCodes{"kTrac", "kCPTrac", "kCRTrac", "kRFTrac", "kRRTrac"};
  std::array<bool, 5> out{};
  for (std::size_t k = 0; k < kCodes.size(); ++k)
    out[k] = deck.has(kCodes[k]) && deck.integer(kCodes[k]) == -1;
  return out;
}

}  // namespace

std::shared_ptr<user::Session> open_session(const LoadedDeck& input,
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
  out.imperfections = [of](bearing::UserTables& tables) { of->imperfections(tables); };
  out.surface = [of](const bearing::Bearing& bearing, bearing::UserSurface& places) {
    of->surface(bearing, places);
  };
  out.document = [of](int hook, const std::string& line) { of->document(hook, line); };
  return out;
}

void start_session(Prepared& prepared, setup::UserHooks& hooks) {
  user::Session& session = *prepared.user;
  session.start(prepared.bearing, own_traction(prepared.input.deck));
  hooks.drives = session.drives();
  hooks.moves_frame = session.moves_frame();
  hooks.suppressed = session.suppressed();
  const long long mode = prepared.input.deck.integer("mode");
  if (mode > 0 && (hooks.drives[0] || hooks.drives[1]))
    throw InputError(
        {prepared.input.deck.issue(Severity::Error, "mode",
                                   fmt::format("places races or elements by their balance, and "
                                               "user routine ADRX1 of {} drives a race",
                                               session.source()),
                                   "set mode to 0")});
  // Held rollers know springs of flanges of their own (held_rollers.hpp).
  if (session.active(2) && prepared.bearing.rollers() != nullptr &&
      (mode > 0 || prepared.control.light_load_ratio > 0.0))
    throw InputError({prepared.input.deck.issue(
        Severity::Error, mode > 0 ? "mode" : "qFac",
        fmt::format("holds rollers in the balance of forces with the built-in law of flanges, and "
                    "user routine ADRX2 of {} gives another",
                    session.source()),
        mode > 0 ? "set mode to 0" : "set qFac to 0")});
  if (session.active(4) && prepared.bearing.cage) {
    const auto& lands = prepared.bearing.cage->lands;
    if (std::any_of(lands.begin(), lands.end(),
                    [](const bearing::GuideLand& land) { return !land.ideal(); }))
      throw InputError({prepared.input.deck.issue(
          Severity::Error,
          prepared.input.deck.integer("kCageGsImp") != 0 ? "kCageGsImp" : "kRaceGsImp",
          fmt::format("gives guide lands shape errors: they press along an arc that has no one "
                      "gap, which user routine ADRX4 of {} is asked for",
                      session.source()),
          "set kCageGsImp and kRaceGsImp to 0, or leave the routine out")});
  }
  const auto law_of_time = [&](const char* variable) {
    return prepared.input.deck.integer(variable) != 0;
  };
  for (const char* variable : {"kVarLoad", "kVarSpeed"})
    if ((hooks.drives[0] || hooks.drives[1]) && law_of_time(variable))
      throw InputError({prepared.input.deck.issue(
          Severity::Error, variable,
          fmt::format("moves races by a law of the time, and user routine ADRX1 of {} drives one",
                      session.source()),
          fmt::format("set {} to 0, or leave the race to the deck", variable))});
  prepared.options.system.user = session.laws(prepared.user);
}

std::vector<std::string> idle_routines(const Prepared& prepared) {
  const user::Session& session = *prepared.user;
  std::vector<std::string> out;
  const auto idle = [&](int hook, const std::string& why) {
    if (session.active(hook))
      out.push_back(fmt::format("user routine {} of {} is active and does nothing here: {}",
                                user::hook_name(hook), session.source(), why));
  };
  const deck::Deck& deck = prepared.input.deck;
  const auto asks = [&](const char* variable, long long code) {
    return deck.has(variable) && deck.integer(variable) == code;
  };
  if (!asks("kRaceGeoImp1", 3) && !asks("kRaceGeoImp2", 3))
    idle(6, "the deck asks for no race of the user (kRaceGeoImp1, kRaceGeoImp2 = 3)");
  if (!prepared.control.dynamic) {
    for (const int hook : {1, 2, 3, 4, 7, 9})
      idle(hook, "it acts in motion, and mode = -1 ends with the equilibrium");
    return out;
  }
  bool free = false;
  for (const int race : {1, 2})
    for (const int axis : {1, 2, 3})
      free = free || setup::translation_free(deck, axis, race) ||
             setup::rotation_free(deck, axis, race);
  if (!session.drives()[0] && !session.drives()[1] && !session.moves_frame() &&
      !session.suppressed().any() && !free)
    idle(1, "no race is free (kDCR = 1), and it drives none, nor moves the frame");
  const bearing::RollerGeometry* const rollers = prepared.bearing.rollers();
  if (rollers == nullptr || (!rollers->has_flange(0) && !rollers->has_flange(1)))
    idle(2, "the bearing has no flanges");
  if (!prepared.bearing.cage) {
    idle(3, "the bearing has no cage");
    idle(4, "the bearing has no cage");
  } else if (prepared.bearing.cage->lands.empty()) {
    idle(4, "no race guides the cage");
  }
  const std::array<bool, 5> traction = own_traction(prepared.input.deck);
  if (std::none_of(traction.begin(), traction.end(), [](bool asked) { return asked; }))
    idle(7, "the deck asks for no traction of the user (kTrac = -1, kCPTrac = -1 ...)");
  return out;
}

std::string program_version(const user::Session* session) {
  std::string out(kProgramVersion);
  if (session == nullptr || session->version().empty()) return out;
  out += '+';
  for (const char c : session->version()) out += c < ' ' ? ' ' : c;
  return out;
}

std::string user_message(const user::Session& session, const std::string& message) {
  if (!session.failure().empty())
    return fmt::format("{}. The files are valid up to the last stored step", session.failure());
  if (!session.refusal().empty()) return fmt::format("{} ({})", message, session.refusal());
  return message;
}

}  // namespace adore::facade
