#pragma once

#include "runs/run.hpp"

#include <functional>
#include <string>

/// Progress messages on stderr. On a terminal one line is overwritten and never longer than the
/// terminal is wide; files and pipes get plain lines. Write errors are ignored.
namespace adore::cli {

/// @param style "auto", "plain", "json" or "none"
[[nodiscard]] runs::ProgressSink make_progress(const std::string& style);

/// Of `total` equal pieces of work `done` are done.
using CountSink = std::function<void(long done, long total)>;
/// @param what "frame", "picture": the counted unit
[[nodiscard]] CountSink make_count_progress(const std::string& what, const std::string& style);

/// The most telling form of a progress line that fits into `width` columns.
[[nodiscard]] std::string progress_line(const runs::Progress& progress, std::size_t width);

}  // namespace adore::cli
