#pragma once

#include "facade/run.hpp"

#include <functional>
#include <string>

/// What a command says on stderr while it works. A terminal gets one line that is written over and
/// never wider than it is; a file or pipe gets plain lines. Nothing here fails: a stream that
/// cannot be written is no reason to end a run.
namespace adore::cli {

/// @param style "auto", "plain", "json" or "none"
[[nodiscard]] facade::ProgressSink make_progress(const std::string& style);

/// Of `total` equal pieces of work `done` are done.
using CountSink = std::function<void(long done, long total)>;
/// @param what "frame", "picture": what is counted
[[nodiscard]] CountSink make_count_progress(const std::string& what, const std::string& style);

/// The most telling form of a progress line that fits into `width` columns.
[[nodiscard]] std::string progress_line(const facade::Progress& progress, std::size_t width);

}  // namespace adore::cli
