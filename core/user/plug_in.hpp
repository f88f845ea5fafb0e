#pragma once

#include "user/adore_user.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

/// Routines of the user, wherever they come from: a shared object, a file of formulas and tables,
/// or functions of the calling program. What is asked of them is said in adore_user.h; nobody but
/// core/user knows where they come from.
namespace adore::user {

inline constexpr std::size_t kHooks = 10;

/// "ADRX7"
[[nodiscard]] std::string hook_name(int hook);

/// One routine. Its argument is the first member of the structure that belongs to the hook
/// (adore_adrx7 of hook 7). May throw: that is reported like a failure.
using Call = std::function<std::int32_t(adore_call&)>;

struct PlugIn {
  std::string source;   ///< what messages call it: the file
  std::string version;  ///< of the user, appended to the program's; may be empty
  std::array<Call, kHooks> hooks;
  /// What the calls need: the library, or the process that runs it.
  std::shared_ptr<void> keeper;
  bool foreign = false;  ///< machine code that may crash here
  bool pure = false;     ///< formulas: need not be asked twice

  [[nodiscard]] bool has(int hook) const {
    return static_cast<bool>(hooks[static_cast<std::size_t>(hook)]);
  }
};

/// A shared object (adore_user.h), or a .json file of formulas and tables (formulas.hpp).
/// Loading a shared object runs its code: call this only for a file that the user named.
/// @throws InputError when it cannot be loaded, has another ABI version, or has no routine
[[nodiscard]] PlugIn load_plug_in(const std::filesystem::path& file);

/// A shared object that runs in a process of its own: what it does to its memory, and its end, are
/// its own. Each call costs some microseconds more.
/// @param timeout after which a call counts as hanging [s]
[[nodiscard]] PlugIn load_in_own_process(const std::filesystem::path& file, double timeout);

}  // namespace adore::user
