#pragma once

#include "base/write_folder.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

/// How a study writes into its folder, which may come from a stranger (decision 830).
namespace adore::studies {

/// The folder NAME.study, made where it is missing. The folder that it is in may be a link;
/// NAME.study and what it contains may not. @throws WriteError naming the link
[[nodiscard]] WriteFolder open_study_folder(const std::filesystem::path& folder);

/// Does the file of this name begin as the program writes it?
[[nodiscard]] bool is_study_file(const std::string& name, std::string_view first_bytes);

/// Writes a file of the study. @throws WriteError when the name is a link or no regular file, or
/// when the file there was not written by a study.
void write_into_study(const WriteFolder& folder, const std::string& name, std::string_view content);
void write_into_study(const WriteFolder& folder, const std::string& name,
                      const std::function<void(const TextSink&)>& produce);

}  // namespace adore::studies
