#pragma once

#include "studies/campaign.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// The study as one table, in files that other programs open.
namespace adore::studies {

struct TableColumn {
  std::string name, unit;  ///< unit: the deck's for variables, SI for quantities; may be empty
  std::vector<double> values;
};

/// One row per run, in the order of the study; it contains no measured times, so the table of a
/// study has the same bytes for every engine, order and interruption.
struct StudyTable {
  std::vector<long> run, exit;           ///< exit -1: not finished
  std::vector<std::string> deck, label;  ///< empty unless the study has several decks, or cases
  std::vector<TableColumn> variables, quantities;
  std::vector<std::string> message;
  [[nodiscard]] std::size_t rows() const { return run.size(); }
  /// nullptr when there is none.
  [[nodiscard]] const TableColumn* find(const std::string& name) const;
};

/// @throws InputError when the runs are not those of the study
[[nodiscard]] StudyTable make_table(const Study& study, const Results& results);

/// RUNS.csv: `run,exit,VARIABLE [unit],...,QUANTITY [unit],...,message`; numbers with all their
/// digits, "inf", empty where there is none; the message quoted.
[[nodiscard]] std::string table_csv(const StudyTable& table);
/// TIMES.csv: what each run cost, where.
[[nodiscard]] std::string times_csv(const Results& results);
/// The bytes of STUDY.h5: one dataset of n numbers per column, /variables/NAME and
/// /quantities/NAME with the attribute unit, /run, /exit, and /message, /deck, /label as text.
/// @param path for messages @throws WriteError
[[nodiscard]] std::string table_h5(const StudyTable& table, const std::string& kind,
                                   const std::filesystem::path& path);

/// RUNS.csv, TIMES.csv and STUDY.h5 in the study's folder.
StudyTable write_tables(const Study& study, const Results& results);

}  // namespace adore::studies
