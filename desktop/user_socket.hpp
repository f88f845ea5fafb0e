#pragma once

#include <QString>

/// Local sockets of the user's programs.
namespace adore::desktop {

/// The same for every spelling of a folder, different for each user.
[[nodiscard]] QString folder_key(const QString& folder);

/// Path of a socket in $XDG_RUNTIME_DIR, which only the user can read, else among the temporary
/// files. Empty: the path is too long for a socket.
[[nodiscard]] QString user_socket(const QString& name);

/// Does a socket belong to the user? Among temporary files it can be another user's.
[[nodiscard]] bool is_own_socket(const QString& path);

}  // namespace adore::desktop
