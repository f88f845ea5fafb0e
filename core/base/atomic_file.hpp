#pragma once

#include <filesystem>
#include <string_view>

namespace adore {

/// Replaces a file as a whole: the content goes to a new file in the same folder, is forced to the
/// disk and then renamed over the old one. Whoever reads the path sees the old content or the new
/// one, never a part, also after a crash. A symbolic link keeps pointing to its (replaced) target
/// and the permissions of an existing file are kept.
/// @throws InputError naming the path and the reason: folder missing or not writable, disk full,
/// path is a folder.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace adore
