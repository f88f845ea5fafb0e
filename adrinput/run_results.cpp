#include "adrinput/run_results.hpp"

#include <fmt/format.h>

namespace adore::adrinput {
namespace {

namespace fs = std::filesystem;

/// "SOL3", or its name in record 2.3.
std::string plot_name(const deck::Deck& deck, int number) {
  const std::string variable = fmt::format("pltNames{}", number);
  const std::string given = deck.has(variable) ? deck.text(variable) : std::string();
  return given.empty() ? fmt::format("SOL{}", number) : given;
}

}  // namespace

RunResults results_in(const fs::path& folder, const deck::Deck& deck,
                      const std::optional<fs::file_time_type>& since) {
  const auto there = [&](const std::string& name) {
    std::error_code error;
    const fs::path file = folder / name;
    if (!fs::is_regular_file(file, error)) return QString();
    const auto time = fs::last_write_time(file, error);
    return error || (since && time < *since) ? QString()
                                             : QString::fromStdString(fs::absolute(file).string());
  };
  RunResults out;
  for (int number = 1; number <= 7; ++number)
    if (const QString file = there(plot_name(deck, number)); !file.isEmpty()) out.plots << file;
  out.moved = !out.plots.isEmpty();
  if (!out.moved)
    for (const char* table : {"RUN.json", "SWEEP.csv"})
      if (const QString file = there(table); !file.isEmpty()) out.plots << file;
  out.animation = there(plot_name(deck, 8));
  out.listing = there("PRINT.txt");
  if (out.moved) out.values = there("RESULTS.h5");
  return out;
}

}  // namespace adore::adrinput
