#pragma once

#include "runs/prepare.hpp"
#include "setup/user_hooks.hpp"
#include "user/session.hpp"

#include <memory>
#include <string>

/// Routines of the user in a run: from the plug-in of the request to what setup and solver see.
namespace adore::runs {

/// Loads the request's plug-in and reads the lines of records 12.x; null: there is none.
/// @throws InputError
[[nodiscard]] std::shared_ptr<user::Session> open_user_session(const LoadedDeck& input,
                                                               const setup::RunOptions& options);
/// Queries of setup; the session outlives them.
[[nodiscard]] setup::UserHooks user_hooks(const std::shared_ptr<user::Session>& session,
                                          const setup::RunOptions& options);
/// Documentation calls of the routines of the motion; their laws go into prepared.options.
/// @throws InputError
void start_user_session(Prepared& prepared, setup::UserHooks& hooks);

/// A sentence for each routine that is active and has nothing to do. @pre prepared.user
[[nodiscard]] std::vector<std::string> unused_routines(const Prepared& prepared);

/// Warnings of loads of ADRX1 on races that are held there. @pre prepared.user, of the motion
/// @throws InputError of a routine that fails
[[nodiscard]] std::vector<Issue> loads_on_fixed_races(const Prepared& prepared);

/// The program's version, with that of the user's routines: "Adore 0.1.0+my laws 1". Null: none.
[[nodiscard]] std::string program_version(const user::Session* session);
/// The message of a run that failed, with what routines said.
[[nodiscard]] std::string add_routine_message(const user::Session& session,
                                              const std::string& message);
/// Throws the error of a run before its first step again, as the failure of the routine behind it.
[[noreturn]] void throw_start_failure(const Prepared& prepared, const SolverError& error);

}  // namespace adore::runs
