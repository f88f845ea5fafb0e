#include "adrinput/study_fields.hpp"

#include "base/json_text.hpp"
#include "deck/number.hpp"

#include <algorithm>
#include <regex>

namespace adore::adrinput {
namespace {

using studies::Kind;

constexpr StudyKinds kSampled = only(Kind::Sweep) | only(Kind::Tolerance) | only(Kind::WorstCase);
constexpr StudyKinds kGrids = only(Kind::Sweep) | only(Kind::Tolerance) | only(Kind::CageMap);
constexpr StudyKinds kVaried = kAllKinds & ~only(Kind::WhatIf);
constexpr StudyKinds kWithLaw = kVaried & ~only(Kind::Sensitivity);

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\n\r");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\n\r") - first + 1));
}

std::vector<std::string> split(const std::string& text, const char* separators) {
  std::vector<std::string> out;
  std::string part;
  const auto end = [&] {
    if (const std::string one = trimmed(part); !one.empty()) out.push_back(one);
    part.clear();
  };
  for (const char c : text) {
    if (std::string_view(separators).find(c) != std::string_view::npos)
      end();
    else
      part += c;
  }
  end();
  return out;
}

/// A number as in JSON stays a number, also an integer; everything else is a text.
StudyJson number_or_text(const std::string& text) {
  static const std::regex number(R"([+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?)");
  if (!std::regex_match(text, number)) return text;
  static const std::regex whole(R"(-?\d{1,18})");
  if (std::regex_match(text, whole)) return std::stoll(text);
  double value = 0.0;
  (void)deck::parse_real(text, value);  // looks like a number; too large ones are rejected later
  return value;
}

StudyJson settings(const std::string& text) {
  // A comma ends a setting only if another one follows.
  static const std::regex next(R"([;,\n]\s*(?=[A-Za-z_][^=;,\n]*=))");
  StudyJson out = StudyJson::object();
  for (std::sregex_token_iterator part(text.begin(), text.end(), next, -1), end; part != end;
       ++part) {
    const std::string one = trimmed(part->str());
    if (one.empty()) continue;
    const auto sign = one.find('=');
    const std::string value = sign == std::string::npos ? "" : trimmed(one.substr(sign + 1));
    out[trimmed(one.substr(0, sign))] = number_or_text(value);
  }
  return out;
}

StudyJson numbers(const std::string& text) {
  StudyJson out = StudyJson::array();
  for (const std::string& part : split(text, ",; \t\n[]")) out.push_back(number_or_text(part));
  return out;
}

void put(StudyJson& row, const char* key, const StudyJson& value) {
  if (value.is_null())
    row.erase(key);
  else
    row[key] = value;
}

const StudyJson& member(const StudyJson& row, const char* key) {
  static const StudyJson none;
  if (!row.is_object()) return none;
  const auto found = row.find(key);
  return found == row.end() ? none : *found;
}

constexpr const char* kLaws[] = {"grid", "list", "uniform", "normal"};

std::vector<std::string> variable_cells(const StudyJson& row) {
  std::vector<std::string> out(8);
  const bool option = row.is_object() && row.contains("option");
  out[0] = shown_value(member(row, option ? "option" : "name"));
  out[1] = option ? "run option" : "deck";
  for (const char* law : kLaws)
    if (!member(row, law).is_null() && out[2].empty()) {
      out[2] = law;
      out[3] = shown_value(member(row, law));
    }
  out[4] = shown_value(member(row, "within"));
  out[5] = shown_value(member(row, "common"));
  out[6] = shown_value(member(row, "also"));
  out[7] = shown_value(member(row, "step"));
  return out;
}

StudyJson variable_row(const std::vector<std::string>& cells, StudyJson row) {
  const bool option = cells[1] == "run option";
  row.erase(option ? "name" : "option");
  put(row, option ? "option" : "name", typed_value(StudyCellType::Text, cells[0]));
  const std::string wanted = !cells[2].empty() ? cells[2] : !cells[3].empty() ? "list" : "";
  for (const char* law : kLaws)
    if (law != wanted) row.erase(law);
  if (!wanted.empty()) row[wanted] = numbers(cells[3]);
  put(row, "within", typed_value(StudyCellType::Numbers, cells[4]));
  put(row, "common", typed_value(StudyCellType::Number, cells[5]));
  put(row, "also", typed_value(StudyCellType::Texts, cells[6]));
  put(row, "step", typed_value(StudyCellType::Number, cells[7]));
  return row;
}

std::vector<std::string> quantity_cells(const StudyJson& row) {
  std::vector<std::string> out(6);
  if (!row.is_object()) {
    out[0] = shown_value(row);
    return out;
  }
  out[0] = shown_value(member(row, row.contains("result") ? "result" : "channel"));
  const char* keys[] = {"statistic", "percent", "window", "at", "name"};
  for (std::size_t k = 0; k < 5; ++k) out[k + 1] = shown_value(member(row, keys[k]));
  return out;
}

/// A key result is its name alone, unless the file wrote it as an object.
StudyJson quantity_row(const std::vector<std::string>& cells, const StudyJson& old) {
  const bool alone = std::all_of(cells.begin() + 1, cells.end(),
                                 [](const std::string& cell) { return cell.empty(); });
  const bool object = old.is_object() && (old.contains("result") || old.size() > 5);
  if (alone && !object) return cells[0];
  StudyJson row = old.is_object() ? old : StudyJson::object();
  put(row, alone && row.contains("result") ? "result" : "channel",
      typed_value(StudyCellType::Text, cells[0]));
  if (!alone) row.erase("result");
  put(row, "statistic", typed_value(StudyCellType::Text, cells[1]));
  put(row, "percent", typed_value(StudyCellType::Number, cells[2]));
  put(row, "window", typed_value(StudyCellType::Numbers, cells[3]));
  put(row, "at", typed_value(StudyCellType::Numbers, cells[4]));
  put(row, "name", typed_value(StudyCellType::Text, cells[5]));
  return row;
}

}  // namespace

const std::vector<StudyField>& study_fields() {
  static const std::vector<StudyField> fields{
      {"kind",
       "Study",
       "Kind",
       "Study type",
       StudyCellType::Choice,
       kAllKinds,
       {"sweep", "tolerance", "cage-map", "sensitivity", "worst-case", "what-if"}},
      {"deck",
       "Study",
       "Base deck",
       "Deck file (path relative to the folder of the study file). To compare decks, list them: "
       "A.txt; B.txt",
       StudyCellType::Texts,
       kAllKinds,
       {}},
      {"set",
       "Study",
       "Set for all runs",
       "Values of deck variables in all runs, in the units of the deck, e.g. mode = -1, appLoadX = "
       "500 (mode -1: quasi-static solution)",
       StudyCellType::Settings,
       kAllKinds,
       {}},
      {"options",
       "Study",
       "Run options",
       "Values of run options in all runs, e.g. hertzConstants = frozen",
       StudyCellType::Settings,
       kAllKinds,
       {}},
      {"until",
       "Study",
       "Run length",
       "Simulated length of each run: revolutions (5rev), time (0.02s) or dimensionless time "
       "(1000)",
       StudyCellType::Text,
       kAllKinds,
       {}},
      {"integrator",
       "Study",
       "Integrator",
       "Integrator that replaces the integrator of the deck (names: see `adore run --help`)",
       StudyCellType::Text,
       kAllKinds,
       {}},
      {"tolerance",
       "Study",
       "Tolerance",
       "Local error tolerance that replaces the tolerance of the deck",
       StudyCellType::Number,
       kAllKinds,
       {}},
      {"keep_files",
       "Study",
       "Keep files",
       "Keep the files of all runs for AdrPlot and AGORE (needs disk space)",
       StudyCellType::Truth,
       kAllKinds,
       {}},
      {"sampling.method",
       "Samples",
       "Method",
       "latin: Latin hypercube (one sample in each of n strata of a variable); sobol: Sobol "
       "sequence; random: independent samples",
       StudyCellType::Choice,
       kSampled,
       {"", "latin", "sobol", "random"}},
      {"sampling.runs",
       "Samples",
       "Samples",
       "Number of samples of the variables with the law \"uniform\" or \"normal\"",
       StudyCellType::Number,
       kSampled,
       {}},
      {"sampling.seed",
       "Samples",
       "Seed",
       "Seed of the random numbers (the same seed gives the same samples)",
       StudyCellType::Number,
       kSampled,
       {}},
      {"bearing_seeds",
       "Samples",
       "Bearing seeds",
       "Values of the run option \"seed\", e.g. 1, 2, 3. All points of the study are run with each "
       "seed.",
       StudyCellType::Numbers,
       kGrids,
       {}},
      {"percentiles",
       "Samples",
       "Percentiles",
       "Percentiles in the report, from 0 to 100 in increasing order, e.g. 5, 50, 95",
       StudyCellType::Numbers,
       kSampled,
       {}},
      {"objective.quantity",
       "Worst case",
       "Quantity",
       "Name of the quantity of interest to maximize or minimize",
       StudyCellType::Text,
       only(Kind::WorstCase),
       {}},
      {"objective.seek",
       "Worst case",
       "Seek",
       "Search for the largest or the smallest value",
       StudyCellType::Choice,
       only(Kind::WorstCase),
       {"", "largest", "smallest"}},
      {"objective.rounds",
       "Worst case",
       "Rounds",
       "Maximum number of search rounds after the first runs",
       StudyCellType::Number,
       only(Kind::WorstCase),
       {}},
      {"budget.runs",
       "Budget",
       "Runs",
       "Maximum number of runs. A study with more runs does not start.",
       StudyCellType::Number,
       kAllKinds,
       {}},
      {"budget.hours",
       "Budget",
       "Hours",
       "Maximum computing time. A study with a longer estimated time does not start.",
       StudyCellType::Number,
       kAllKinds,
       {}},
      {"budget.disk_megabytes",
       "Budget",
       "Disk [MB]",
       "Maximum disk space. A study that needs more disk space does not start.",
       StudyCellType::Number,
       kAllKinds,
       {}}};
  return fields;
}

const StudyField* find_study_field(std::string_view key) {
  const auto& all = study_fields();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& field) { return field.key == key; });
  return found == all.end() ? nullptr : &*found;
}

const std::vector<StudyTableSpec>& study_tables() {
  static const std::vector<StudyTableSpec> tables{
      {"variables",
       "Variables",
       "Values that differ between runs",
       kVaried,
       {{"Name",
         "Name of a deck variable. \"#\" stands for the element number: reDiaVar# is one variable "
         "for each element.",
         kAllKinds,
         {},
         Proposals::Variables},
        {"Type", "Deck variable or run option", kAllKinds, {"deck", "run option"}},
        {"Law",
         "grid and list: all combinations are run; uniform and normal: random samples",
         kWithLaw,
         {"grid", "list", "uniform", "normal"}},
        {"Numbers",
         "grid: first value, last value, count. list: values. uniform: low, high. normal: mean, "
         "standard deviation.",
         kWithLaw},
        {"Limits", "Limits that truncate a normal distribution: low, high", kSampled},
        {"Lots",
         "Correlation (0 to 1) of the values within one production lot, for names with # (one "
         "value for each element)",
         kSampled},
        {"Link", "Other deck variables that get the same value, e.g. A; B", kWithLaw},
        {"Step", "Step of the central difference, in deck units (default: 0.1 % of the value)",
         only(Kind::Sensitivity)}}},
      {"correlation",
       "Correlation",
       "Correlation between two random variables (for elements of one production lot, use the "
       "column \"Lots\")",
       kSampled & ~only(Kind::WorstCase),
       {{"First", "Name of a variable of the study"},
        {"Second", "Name of a variable of the study"},
        {"Value", "Correlation coefficient, -1 to 1"}}},
      {"cases",
       "Cases",
       "Named changes of the deck, compared one at a time with the unchanged deck",
       only(Kind::WhatIf),
       {{"Name", "Name of the case in the report"},
        {"Set", "Changed deck variables, e.g. gravityVecZ = 0"},
        {"Run options", "Changed run options, e.g. hertzConstants = frozen"}}},
      {"quantities",
       "Quantities of interest",
       "Named key results, or statistics of a channel of RESULTS.h5",
       kAllKinds,
       {{"Key result or channel",
         "A key result such as largest_contact_load_N, or a channel such as contact.load (with a "
         "statistic)",
         kAllKinds,
         {},
         Proposals::Results},
        {"Statistic",
         "Statistic of a channel",
         kAllKinds,
         {"", "mean", "rms", "deviation", "least", "largest", "largest_size", "span", "last",
          "percentile"}},
        {"Percent", "Percentage for the statistic \"percentile\", from 0 to 100"},
        {"Window",
         "Start and end of the evaluated part of the run, as fractions of the run time, e.g. 0.5, "
         "1"},
        {"Index", "Number of the element, race or land, counted from 1 (default: all together)"},
        {"Heading", "Heading of the column in the report"}}}};
  return tables;
}

std::string shown_value(const StudyJson& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  std::string out;
  if (value.is_array()) {
    const bool texts = !value.empty() && value.front().is_string();
    for (const StudyJson& item : value)
      out += (out.empty() ? "" : texts ? "; " : ", ") + shown_value(item);
    return out;
  }
  if (value.is_object()) {
    for (const auto& [key, item] : value.items())
      if (!key.starts_with("//"))
        out += (out.empty() ? "" : ", ") + key + " = " + shown_value(item);
    return out;
  }
  return dump_json(value);
}

StudyJson typed_value(StudyCellType cell, const std::string& text) {
  const std::string plain = trimmed(text);
  if (plain.empty()) return {};
  switch (cell) {
    case StudyCellType::Number:
      return number_or_text(plain);
    case StudyCellType::Numbers:
      return numbers(plain);
    case StudyCellType::Texts: {
      StudyJson out = StudyJson::array();
      for (const std::string& part : split(plain, ";")) out.push_back(part);
      return out;
    }
    case StudyCellType::Settings:
      return settings(plain);
    case StudyCellType::Truth:
      return plain == "true";
    case StudyCellType::Text:
    case StudyCellType::Choice:
      break;
  }
  return plain;
}

std::vector<std::string> row_cells(std::string_view table, const StudyJson& row) {
  if (table == "variables") return variable_cells(row);
  if (table == "quantities") return quantity_cells(row);
  if (table == "cases")
    return {shown_value(member(row, "name")), shown_value(member(row, "set")),
            shown_value(member(row, "options"))};
  std::vector<std::string> out(3);
  for (std::size_t k = 0; k < 3 && row.is_array() && k < row.size(); ++k)
    out[k] = shown_value(row[k]);
  return out;
}

StudyJson row_from_cells(std::string_view table, const std::vector<std::string>& cells,
                         const StudyJson& old) {
  StudyJson row = old.is_object() ? old : StudyJson::object();
  if (table == "variables") return variable_row(cells, std::move(row));
  if (table == "quantities") return quantity_row(cells, old);
  if (table == "cases") {
    put(row, "name", typed_value(StudyCellType::Text, cells[0]));
    put(row, "set", typed_value(StudyCellType::Settings, cells[1]));
    put(row, "options", typed_value(StudyCellType::Settings, cells[2]));
    return row;
  }
  StudyJson list = StudyJson::array({cells[0], cells[1]});
  list.push_back(cells[2].empty() ? StudyJson(nullptr) : number_or_text(trimmed(cells[2])));
  return list;
}

}  // namespace adore::adrinput
