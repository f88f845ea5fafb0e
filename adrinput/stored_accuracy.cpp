#include "adrinput/stored_accuracy.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "studies/model_errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace adore::adrinput {
namespace {

using nlohmann::json;

double number(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>()
                                                     : std::numeric_limits<double>::quiet_NaN();
}

std::string word(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// "accuracy" of RUN.json (studies/accuracy_statement.hpp).
std::string statement(const json& accuracy) {
  std::string out;
  const auto rows = accuracy.find("quantities");
  if (rows == accuracy.end() || !rows->is_array()) return out;
  for (const json& row : *rows) {
    if (!row.is_object() || word(row, "label").empty()) continue;
    out += fmt::format(
        "  {:<36} {:>12.5g} {:<5} ± {:.2g} %  (numerical {:.2g} %, statistical {:.2g} %)\n",
        word(row, "label"), number(row, "value"), word(row, "unit"),
        100.0 * number(row, "half_width"), 100.0 * number(row, "numerical"),
        100.0 * number(row, "statistical"));
  }
  if (out.empty()) return out;
  std::string head =
      fmt::format("Accuracy of the last run with {} (RUN.json)",
                  counted(fmt::format("{:.4g}", number(accuracy, "revolutions")), "revolution"));
  if (const double needed = number(accuracy, "needs_revolutions"); needed > 0.0)
    head += fmt::format("; the target error needs about {}",
                        counted(fmt::format("{:.3g}", needed), "revolution"));
  return head + "\n" + out;
}

std::string verification(const json& verify) {
  if (!word(verify, "failure").empty())
    return fmt::format("The verification run against {} failed: {}\n", word(verify, "against"),
                       word(verify, "failure"));
  std::string out;
  if (const auto errors = verify.find("errors"); errors != verify.end() && errors->is_object())
    for (const auto& [name, error] : errors->items())
      if (error.is_number())
        out += fmt::format("{}{} {:.2g} %", out.empty() ? "" : ", ", name,
                           100.0 * error.get<double>());
  return out.empty() ? out : fmt::format("Verified against {}: {}\n", word(verify, "against"), out);
}

std::string of_last_run(const std::filesystem::path& file) {
  json run;
  try {
    run = parse_json(read_text_file(file), file.string());
  } catch (const InputError&) {
    return {};
  }
  std::string out;
  if (!run.is_object()) return out;
  if (const auto found = run.find("accuracy"); found != run.end() && found->is_object())
    out += statement(*found);
  if (const auto found = run.find("verify"); found != run.end() && found->is_object())
    out += verification(*found);
  return out;
}

}  // namespace

std::string stored_accuracy(const std::filesystem::path& deck_file, const deck::Deck& deck,
                            const RunOptionValues& options) {
  if (deck_file.empty()) return {};
  runs::LoadedDeck loaded;
  loaded.path = deck_file;
  loaded.deck = deck;
  loaded.option_values = options;
  std::string out = of_last_run(deck_file.parent_path() / "RUN.json");
  if (const auto models = runs::find_model_study(loaded))
    out += (out.empty() ? "" : "\n") + runs::model_table(*models);
  return out;
}

}  // namespace adore::adrinput
