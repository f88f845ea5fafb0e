#include "studies/cage_whirl.hpp"
#include "studies/reporter.hpp"

#include <fmt/format.h>

#include <cmath>

/// Maps of cages: figures of whirl over two variables.
namespace adore::studies {
namespace {

/// The class that a record contains as a number. Records may come from a stranger.
std::string class_of(double value) {
  for (const WhirlClass one : {WhirlClass::Resting, WhirlClass::Whirling, WhirlClass::Irregular})
    if (value == static_cast<double>(one)) return std::string(whirl_class_name(one));
  return "failed";
}

}  // namespace

void Reporter::add_cage_map() {
  const TableColumn &x = column_of(*grids_[0]), &y = column_of(*grids_[1]);
  const std::vector<double> xs = sorted_unique_values(x.values),
                            ys = sorted_unique_values(y.values);
  const TableColumn& kind = *table_.find(std::string(kWhirlFigures[3]));
  std::vector<std::vector<std::string>> marks;
  for (const double b : ys) {
    marks.emplace_back();
    for (const double a : xs) {
      const auto rows = rows_with_values({{&x, a}, {&y, b}});
      const double of = rows.empty() ? kNaN : kind.values[rows.front()];
      marks.back().push_back(class_of(of));
    }
  }
  for (const TableColumn& quantity : table_.quantities) {
    if (&quantity == &kind) continue;
    std::vector<std::vector<double>> values;
    std::vector<std::vector<std::vector<long>>> runs;
    for (const double b : ys) {
      values.emplace_back();
      runs.emplace_back();
      for (const double a : xs) {
        const auto rows = rows_with_values({{&x, a}, {&y, b}});
        runs.back().push_back(run_numbers(rows));
        values.back().push_back(rows.empty() ? kNaN : quantity.values[rows.front()]);
      }
    }
    charts_.push_back(
        heat_map("map-" + file_name(quantity.name), x, y, quantity, xs, ys, values, marks, runs));
    text_ +=
        fmt::format("{} (columns: {}, rows: {})\n{:>14}", label(quantity), label(x), label(y), "");
    for (const double a : xs) text_ += fmt::format(" {:>12g}", a);
    text_ += "\n";
    for (std::size_t j = ys.size(); j-- > 0;) {
      text_ += fmt::format("{:>14g}", ys[j]);
      for (const double value : values[j]) text_ += fmt::format(" {:>12}", number(value));
      text_ += "\n";
    }
  }
  text_ += fmt::format("class (columns: {}, rows: {})\n{:>14}", label(x), label(y), "");
  for (const double a : xs) text_ += fmt::format(" {:>12g}", a);
  text_ += "\n";
  for (std::size_t j = ys.size(); j-- > 0;) {
    text_ += fmt::format("{:>14g}", ys[j]);
    for (const std::string& mark : marks[j]) text_ += fmt::format(" {:>12}", mark);
    text_ += "\n";
  }
  text_ += fmt::format(
      "\nMotion classes (from the second half of each run):\nresting: the orbit of the cage center "
      "about its mean position is less than {:g} times the clearance.\nwhirling: the orbit is "
      "larger, "
      "and the whirl deviation is less than {:g} times the whirl ratio.\nirregular: all other "
      "motions.\n\n",
      kRestingOrbit, kSteadyDeviation);
}

}  // namespace adore::studies
