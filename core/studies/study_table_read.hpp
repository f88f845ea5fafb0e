#pragma once

#include "studies/study_table.hpp"

/// A study's table without its study: what RUNS.csv and STUDY.h5 still say in another place.
namespace adore::studies {

/// A file that begins as RUNS.csv does, or ends in .h5 and is not a RESULTS.h5.
[[nodiscard]] bool is_study_table(const std::filesystem::path& file);

/// RUNS.csv or STUDY.h5. CSV does not mark varied columns: columns named like a variable of a deck
/// or a run option count as varied. @throws InputError
[[nodiscard]] StudyTable read_study_table(const std::filesystem::path& file);

/// Charts of a table alone, as Report::charts: all runs in parallel, and each quantity over each
/// variable of at most 200 values (median, 5 and 95 %).
[[nodiscard]] std::string charts_of_table(const StudyTable& table);

/// One run in words: what was varied, what came of it, how it ended.
[[nodiscard]] std::string run_text(const StudyTable& table, long run);

/// The same from the study's folder, with what it cost and the command that repeats it.
[[nodiscard]] std::string run_text(const std::filesystem::path& folder, long run);
/// Folder of the run's files, if the study keeps them; otherwise empty.
[[nodiscard]] std::filesystem::path run_files_folder(const std::filesystem::path& folder, long run);

}  // namespace adore::studies
