#pragma once

#include <filesystem>
#include <string_view>

namespace adore {

/// Saves the content of a file before it is replaced: writes `content` to NAME.bak next to it, or,
/// if another text has that name, to the first of NAME.bak2, NAME.bak3 ... that is free or has the
/// same content. Earlier copies are never replaced.
/// @return the copy's path
/// @throws InputError as write_file_atomically()
std::filesystem::path write_backup_copy(const std::filesystem::path& path,
                                        std::string_view content);

}  // namespace adore
