#pragma once

#include <filesystem>
#include <string_view>

namespace adore {

/// Keeps what a file held before it is replaced: writes `content` to NAME.bak beside it, or, where
/// another text has that name already, to the first of NAME.bak2, NAME.bak3 ... that is free or
/// holds the same. No earlier copy is ever replaced.
/// @return the copy's path
/// @throws InputError as write_file_atomically()
std::filesystem::path keep_copy(const std::filesystem::path& path, std::string_view content);

}  // namespace adore
