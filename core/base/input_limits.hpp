#pragma once

#include <cstddef>
#include <cstdint>

/// Limits of everything that is read, in one place: a file of another person must not exhaust the
/// stack, the memory, the disk or the time of whoever opens it.
namespace adore {

/// Levels of a JSON or TOML value. Walking, printing, comparing and destroying such a value is
/// recursive. RUN.json and reference cases need about ten.
inline constexpr int kMaxNesting = 64;

/// Names of the nested keys of a value, joined by dots. Messages and tables store one per value.
inline constexpr std::size_t kMaxKeyPathBytes = 1000;

/// Bytes of a text file that is read as a whole: RUN.json of a table of 1000 speeds has 20 MB.
inline constexpr std::uintmax_t kMaxTextBytes = std::uintmax_t{256} << 20;
/// Bytes of what a person writes: decks, study files, options, formulas.
inline constexpr std::uintmax_t kMaxHandwrittenBytes = std::uintmax_t{16} << 20;
/// Bytes of tasks.jsonl and RUNS.csv of a study of kMaxStudyRuns runs.
inline constexpr std::uintmax_t kMaxStudyTableBytes = std::uintmax_t{4} << 30;
/// Bytes of standard input.
inline constexpr std::size_t kMaxInputBytes = std::size_t{64} << 20;

/// Runs of a study, and runs of a sweep.
inline constexpr long kMaxStudyRuns = 10'000'000;
/// Memory of the list of runs of a study. It is estimated before the list is made: a run that sets
/// two variables takes 0.7 kB.
inline constexpr double kMaxStudyBytes = 4.0 * (std::uintmax_t{1} << 30);
/// Rows of a table of numbers by the user (traction curve, surface).
inline constexpr std::size_t kMaxTableRows = 100'000;
/// Columns of a table of runs: the key results are about a hundred.
inline constexpr std::size_t kMaxTableColumns = 2'000;
/// Pictures that one command draws without being asked for each of them.
inline constexpr std::size_t kMaxPictures = 2'000;

}  // namespace adore
