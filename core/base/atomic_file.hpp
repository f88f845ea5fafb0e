#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace adore {

/// Replaces a file as a whole: the content goes to a new file in the same folder, is forced to the
/// disk and then renamed over the old one. Whoever reads the path sees the old content or the new
/// one, never a part, also after a crash. A symbolic link keeps pointing to its (replaced) target
/// and the permissions of an existing file are kept, but for those to execute it.
/// @throws InputError naming the path and the reason: folder missing or not writable, the file that
/// is there write-protected (for root, too), disk full, path is a folder.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// The same for content that nobody holds as a whole: `produce` hands it to its argument piece by
/// piece. Nothing is replaced when it throws.
using TextSink = std::function<void(std::string_view piece)>;
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(const TextSink&)>& produce);

/// Is there a file that may not be written? A new one could take its name in a writable folder, and
/// root may write all: who takes the permission away wants the file to stay.
[[nodiscard]] bool write_protected(const std::filesystem::path& path);

/// Name of the new file until it is renamed, X standing for any letter or digit: what a killed
/// process may leave on file systems that know no files without a name.
[[nodiscard]] std::string temporary_pattern(const std::filesystem::path& target);

}  // namespace adore
