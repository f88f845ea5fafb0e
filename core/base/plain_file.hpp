#pragma once

#include <filesystem>

/// Files that programs open unasked (beside another one), or in a window, must be plain ones: a
/// pipe that nobody writes to holds its reader for ever, a device has no end.
namespace adore {

/// True through links; false for what is not there, too.
[[nodiscard]] bool is_plain_file(const std::filesystem::path& path);

/// Lets plain files, folders and what is not there pass, which their readers tell apart.
/// @throws InputError for a pipe, a socket or a device
void refuse_pipe(const std::filesystem::path& path);

}  // namespace adore
