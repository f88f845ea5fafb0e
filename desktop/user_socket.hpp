#pragma once

#include <QString>

/// Local sockets of the user's programs.
namespace adore::desktop {

/// The same for every spelling of a folder, different for each user.
[[nodiscard]] QString folder_key(const QString& folder);

/// Path of a socket in a folder that only the user can read: $XDG_RUNTIME_DIR, else a folder among
/// the temporary files. Empty: there is none, or the path is too long for a socket.
[[nodiscard]] QString user_socket(const QString& name);

}  // namespace adore::desktop
