#include "facade/accuracy.hpp"

#include "cli/commands.hpp"
#include "cli/deck_options.hpp"
#include "cli/export.hpp"
#include "cli/option_ranges.hpp"
#include "cli/pictures.hpp"
#include "cli/streams.hpp"

#include <fmt/format.h>

#include <charconv>
#include <memory>

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
          "--tols: \"{}\" is no tolerance; give positive numbers, e.g. 1e-4,1e-6,1e-8", item));
    check_range("--tols", value);
    out.push_back(value);
  }
  if (out.empty()) throw InputError("--tols is empty; give positive numbers, e.g. 1e-4,1e-6,1e-8");
  return out;
}

struct Options : DeckOptions {
  std::string methods, tolerances, out = ".";
  double span = 100.0;
};

void run(const Options& options) {
  facade::AccuracyRequest request;
  options.fill(request);
  if (!options.methods.empty()) request.methods = split_list(options.methods);
  if (!options.tolerances.empty()) request.tolerances = parse_tolerances(options.tolerances);
  check_range("--span", options.span);
  request.span = options.span;
  const std::filesystem::path folder(options.out);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error))
    throw InputError(
        fmt::format("--out {}: this folder cannot be made; name another one", folder.string()));
  const facade::AccuracyStudy study =
      facade::study_accuracy(request, [](const facade::AccuracyRow& row) {
        tell(fmt::format("{} at {:.0e}: {}\n", row.method, row.tolerance,
                         row.failure.empty() ? fmt::format("error {:.2e}", row.error) : "gave up"));
      });
  fmt::print("{}", facade::accuracy_table(study));
  write_export(folder / "ACCURACY.csv", facade::accuracy_csv(study), {options.deck});
  fmt::print("\n{}\n", (folder / "ACCURACY.csv").string());
  if (draw_accuracy_chart(study, folder / "ACCURACY.png"))
    fmt::print("{}\n", (folder / "ACCURACY.png").string());
}

}  // namespace

void add_accuracy(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand(
      "accuracy", "what accuracy costs in time: methods x tolerances against a tight reference");
  auto options = std::make_shared<Options>();
  options->add_to(*command);
  command->add_option("--methods", options->methods, "integrators, separated by commas")
      ->type_name("LIST");
  command->add_option("--tols", options->tolerances, "tolerances, separated by commas")
      ->type_name("LIST");
  command->add_option("--span", options->span, "simulated time over the time scale")
      ->capture_default_str();
  command->add_option("--out", options->out, "folder for ACCURACY.csv and ACCURACY.png")
      ->type_name("DIR")
      ->default_str("here");
  command->footer(
      "Example\n"
      "  adore accuracy DATA.txt --methods rkf5,cvode-adams --tols 1e-5,1e-7 --out study");
  command->callback([=] { run(*options); });
}

}  // namespace adore::cli
