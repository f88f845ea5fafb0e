#pragma once

#include "facade/accuracy.hpp"

#include <filesystem>

namespace adore::cli {

/// Whether this build draws pictures.
[[nodiscard]] bool has_pictures() noexcept;

/// Draws error against computing time as a PNG. Returns false in a build without Qt.
bool draw_accuracy_chart(const facade::AccuracyStudy& study, const std::filesystem::path& file);

}  // namespace adore::cli
