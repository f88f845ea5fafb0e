#include "facade/user_session.hpp"

#include "base/version.hpp"

#include <fmt/format.h>

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
  const bool balls = input.deck.integer("kBrg") == 1;
  for (const int hook : {2, 3, 4, 5, 6})
    if (session->active(hook) && !(hook == 3 && balls))
      throw InputError(
          fmt::format("{} activates user routine {}, which this version does not call yet{}; leave "
                      "it out, or let it leave call.active at 0",
                      session->source(), user::hook_name(hook), hook == 3 ? " for rollers" : ""));
  return session;
}

setup::UserHooks user_hooks(const std::shared_ptr<user::Session>& session) {
  setup::UserHooks out;
  if (!session) return out;
  out.source = session->source();
  for (std::size_t k = 0; k < out.active.size(); ++k)
    out.active[k] = session->active(static_cast<int>(k));
  user::Session* const of = session.get();
  out.material = [of](bearing::Part part, const bearing::Material& fallback) {
    return of->material(part, fallback);
  };
  out.imperfections = [of](bearing::UserTables& tables) { of->imperfections(tables); };
  return out;
}

void start_session(Prepared& prepared, setup::UserHooks& hooks) {
  user::Session& session = *prepared.user;
  session.start(prepared.bearing, own_traction(prepared.input.deck));
  hooks.drives = session.drives();
  hooks.suppressed = session.suppressed();
  const long long mode = prepared.input.deck.integer("mode");
  if (mode > 0 && (hooks.drives[0] || hooks.drives[1]))
    throw InputError(
        {prepared.input.deck.issue(Severity::Error, "mode",
                                   fmt::format("places races or elements by their balance, and "
                                               "user routine ADRX1 of {} drives a race",
                                               session.source()),
                                   "set mode to 0")});
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
