#include "studies/accuracy.hpp"

#include "base/input_file.hpp"
#include "base/kept_copy.hpp"
#include "base/terminal_text.hpp"
#include "base/write_folder.hpp"
#include "cli/commands.hpp"
#include "cli/deck_options.hpp"
#include "cli/export.hpp"
#include "cli/option_ranges.hpp"
#include "cli/percentage.hpp"
#include "cli/picture_program.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "runs/results_folder.hpp"
#include "studies/model_errors.hpp"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <sstream>

namespace adore::cli {
namespace {

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> out;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    if (comma > from) out.push_back(text.substr(from, comma - from));
    from = comma + 1;
  }
  return out;
}

std::vector<double> parse_tolerances(const std::string& text) {
  std::vector<double> out;
  for (const std::string& item : split_list(text)) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), value);
    if (error != std::errc() || end != item.data() + item.size() || !(value > 0.0))
      throw InputError(fmt::format(
          "--tols: \"{}\" is not a tolerance; give positive numbers, e.g. 1e-4,1e-6,1e-8", item));
    check_range("--tols", value);
    out.push_back(value);
  }
  if (out.empty())
    throw InputError("--tols has no value; give positive numbers, e.g. 1e-4,1e-6,1e-8");
  return out;
}

struct Options : DeckOptions {
  std::string methods, tolerances, out = ".", accuracy = "1%";
  double turns = 50.0, budget = 120.0;
  bool apply = false, go_on = false, models = false, turns_given = false;
};

std::string contents(const std::filesystem::path& path) { return read_text_file(path); }

/// Print rows as they arrive.
class Reporter {
 public:
  void operator()(const studies::AccuracyRow& row, const studies::AccuracyStudy& study) {
    const std::string round = studies::round_text(row, study);
    if (round != round_) tell(round + "\n");
    round_ = round;
    tell(fmt::format("  {:<40} {}\n", row.setting.name,
                     row.failure.empty() ? fmt::format("{:.3g} s, {:.2g} %", row.seconds,
                                                       100.0 * row.errors.largest())
                                         : row.failure));
  }

 private:
  std::string round_;
};

/// Puts the recommended settings into the deck.
void apply(const Options& options, const studies::AccuracyStudy& study) {
  const auto sets = studies::recommended_sets(study);
  if (sets.empty())
    throw InputError("--apply: the study recommends no settings; the deck is unchanged");
  const std::filesystem::path path = runs::deck_path(std::filesystem::path(options.deck));
  const std::string before = contents(path);
  const deck::DeckTextWithComments text = deck::with_values(before, sets);
  std::filesystem::path backup;
  if (!text.kept) backup = write_backup_copy(path, before);
  write_file_atomically(path, text.text);
  std::string said;
  for (const auto& [name, value] : sets)
    said += fmt::format("{}{} = {}", said.empty() ? "" : ", ", name, value);
  print("{}: {}{}\n", path.string(), said,
        text.kept ? ""
                  : fmt::format(" (the deck was rewritten without the comments after its values; "
                                "the previous deck was saved as {})",
                                backup.string()));
}

/// Into the folder of --out or, without it, that of the deck, where runs and forms find it.
int run_models(const Options& options, bool out_given) {
  constexpr double kTurns = 2.0;
  if (options.apply || options.go_on || !options.methods.empty() || !options.tolerances.empty())
    throw InputError(
        "--models varies the model, not the integrator settings; remove --apply, --continue, "
        "--methods and --tols");
  check_range("--turns", options.turns);
  check_range("--budget", options.budget);
  runs::DeckRequest request;
  options.fill(request);
  std::filesystem::path folder = options.out;
  if (!out_given && !request.text) folder = runs::deck_path(request).parent_path();
  if (folder.empty()) folder = ".";
  const runs::ResultsFolder made(folder);
  const std::filesystem::path file = made.path() / runs::kModelFile;
  check_export(file, runs::model_json({}), {options.deck});
  InterruptWatch watch;
  const runs::ModelStudy study = studies::run_model_study(
      request, options.turns_given ? options.turns : kTurns, options.budget,
      [](const runs::ModelRow& row) {
        tell(fmt::format("  {:<15}{:<40} {:.3g} s{}\n", row.variant.group, row.variant.name,
                         row.seconds, row.failure.empty() ? "" : ", no result"));
      },
      watch.token());
  write_export(file, runs::model_json(study), {options.deck});
  print("{}\n{}\n", runs::model_table(study), file.string());
  return 0;
}

int run(const Options& options) {
  studies::AccuracyRequest request;
  options.fill(request);
  if (options.apply && request.text)
    throw InputError(
        "--apply changes the deck file, but the deck comes from standard input; give the name of a "
        "deck file");
  if (options.apply && !request.sets.empty())
    throw InputError(
        "--apply writes settings into the deck file, but --set changes the deck only for this "
        "study; remove --apply or --set");
  if (!options.methods.empty()) request.methods = split_list(options.methods);
  if (!options.tolerances.empty()) request.tolerances = parse_tolerances(options.tolerances);
  check_range("--turns", options.turns);
  check_range("--budget", options.budget);
  request.turns = options.turns;
  request.budget = options.budget;
  request.target = parse_percentage("--accuracy", options.accuracy);
  const runs::ResultsFolder made(options.out);
  const std::filesystem::path& folder = made.path();
  std::error_code error;
  const std::filesystem::path json = folder / "ACCURACY.json";
  studies::AccuracyStudy earlier;
  if (options.go_on) {
    if (!std::filesystem::exists(json, error))
      throw InputError(fmt::format(
          "--continue: {} does not exist; remove --continue to start a new study", json.string()));
    earlier = studies::read_accuracy(contents(json), json.string());
  }
  // Check the output location before computing.
  check_export(folder / "ACCURACY.csv", studies::accuracy_csv(earlier), {options.deck});
  check_export(json, studies::accuracy_json(earlier), {options.deck});
  const auto write = [&](const studies::AccuracyStudy& study) {
    write_export(folder / "ACCURACY.csv", studies::accuracy_csv(study), {options.deck});
    write_export(json, studies::accuracy_json(study), {options.deck});
  };
  InterruptWatch watch;
  Reporter report;
  const studies::AccuracyStudy study = studies::study_accuracy(
      request,
      [&](const studies::AccuracyRow& row, const studies::AccuracyStudy& so_far) {
        report(row, so_far);
        write(studies::joined(so_far, earlier));
      },
      watch.token(), earlier);
  if (options.go_on && study.digest != earlier.digest)
    tell(
        fmt::format("adore: note: {} was not used, because it is the study of another deck or of "
                    "other options\n",
                    json.string()));
  write(study);
  if (!study.complete) {
    tell(
        fmt::format("\ninterrupted; the completed part is stored in {}. To resume, repeat the "
                    "command with --continue\n",
                    json.string()));
    return 130;
  }
  print("{}\n{}\n{}\n", studies::accuracy_table(study), (folder / "ACCURACY.csv").string(),
        json.string());
  if (options.apply) apply(options, study);
  const std::filesystem::path picture = folder / "ACCURACY.png";
  if (!has_pictures()) return 0;
  if (!run_picture_program({"accuracy-chart", json.string(), picture.string()})) return 2;
  print("{}\n", picture.string());
  return 0;
}

}  // namespace

void add_accuracy_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "accuracy",
      "compare error and computing time of integrators, tolerances and step sizes for a deck");
  auto options = std::make_shared<Options>();
  options->add_to(*command);
  command
      ->add_option("--methods", options->methods, "integrators, separated by commas (default: all)")
      ->type_name("LIST");
  command
      ->add_option("--tols", options->tolerances,
                   "tolerances, separated by commas (default: 1e-4 to 1e-7)")
      ->type_name("LIST");
  CLI::Option* turns =
      command
          ->add_option("--turns", options->turns,
                       "shaft revolutions over which the best settings are compared")
          ->capture_default_str();
  command
      ->add_option("--budget", options->budget,
                   "maximum processor time of the study [s]; a small limit shortens the runs")
      ->capture_default_str();
  command
      ->add_option("--accuracy", options->accuracy, "target error of speeds, loads, heat and life")
      ->capture_default_str()
      ->type_name("PERCENT");
  command->add_flag("--apply", options->apply, "write the recommended settings into the deck");
  command->add_flag("--continue", options->go_on,
                    "continue an interrupted study with the same options");
  command->add_flag("--models", options->models,
                    "estimate model errors instead of integration errors: vary damping, traction "
                    "law, cage friction, nodes or slices, mode and thermal model within their "
                    "uncertainty (default of --turns: 2). MODELS.json is written next to the deck; "
                    "PRINT.txt and AdrInput show the results");
  CLI::Option* out = command
                         ->add_option("--out", options->out,
                                      "folder for ACCURACY.csv, ACCURACY.json and ACCURACY.png")
                         ->type_name("DIR")
                         ->default_str("current folder");
  command->footer(
      "Examples\n"
      "  adore accuracy DATA.txt --out study\n"
      "  adore accuracy DATA.txt --models\n"
      "  adore accuracy DATA.txt --methods rkf3,rkf5 --tols 1e-4,1e-6 --turns 10 --apply");
  command->callback([=, &exit_code] {
    options->turns_given = turns->count() > 0;
    exit_code = options->models ? run_models(*options, out->count() > 0) : run(*options);
  });
}

}  // namespace adore::cli
