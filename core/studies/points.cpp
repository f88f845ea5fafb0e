#include "studies/points.hpp"

#include "base/errors.hpp"
#include "base/input_limits.hpp"
#include "runs/run_ending.hpp"
#include "studies/draws.hpp"
#include "studies/job.hpp"
#include "studies/sensitivity.hpp"
#include "studies/worst_case.hpp"

#include <Eigen/Core>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::studies {
namespace {

std::vector<const Variable*> variables_of_law(const Study& study, bool random) {
  std::vector<const Variable*> out;
  for (const Variable& variable : study.variables)
    if ((variable.law != Law::Values) == random) out.push_back(&variable);
  return out;
}

/// Of a law cut at its limits, from a share of the whole.
double from_share(const Variable& variable, double u) {
  if (variable.law == Law::Uniform) return variable.a + (variable.b - variable.a) * u;
  const double below = variable.low ? normal_cdf((*variable.low - variable.a) / variable.b) : 0.0;
  const double above = variable.high ? normal_cdf((*variable.high - variable.a) / variable.b) : 1.0;
  // The nearest numbers inside: a share of exactly 0 or 1 has no score.
  constexpr double kMinShare = 1e-300;
  const double share = std::clamp(below + (above - below) * u, kMinShare, std::nextafter(1.0, 0.0));
  double value = variable.a + variable.b * normal_quantile(share);
  if (variable.low) value = std::max(value, *variable.low);
  if (variable.high) value = std::min(value, *variable.high);
  return value;
}

/// Values of every random variable's targets: [sample][target], in the order of the variables.
std::vector<std::vector<double>> sampled(const Study& study) {
  const std::vector<const Variable*> random = variables_of_law(study, true);
  int dimensions = 0;
  std::vector<int> first;
  for (const Variable* variable : random) {
    first.push_back(dimensions);
    dimensions += static_cast<int>(variable->targets.size()) + (variable->common > 0.0 ? 1 : 0);
  }
  const auto units = unit_cube_samples(study.sampling, study.samples, dimensions, study.seed);
  // Correlated scores of single variables: lots have their own rule.
  const auto n = static_cast<Eigen::Index>(random.size());
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(n, n), factor;
  for (const Correlation& pair : study.correlations) {
    const auto place = [&](const std::string& name) {
      return std::find_if(random.begin(), random.end(),
                          [&](const Variable* v) { return v->name == name; }) -
             random.begin();
    };
    const auto i = place(pair.first), j = place(pair.second);
    correlation(i, j) = correlation(j, i) = pair.value;
  }
  const bool correlated = !study.correlations.empty();
  if (correlated && !factorize_correlation(correlation, factor))
    throw InputError(
        fmt::format("{}: correlation: the correlations contradict each other (the correlation "
                    "matrix has a negative eigenvalue); use smaller correlations",
                    study.file.string()));
  std::vector<std::vector<double>> out;
  out.reserve(units.size());
  for (const std::vector<double>& u : units) {
    std::vector<double> row;
    Eigen::VectorXd scores;
    if (correlated) {
      scores.resize(n);
      for (Eigen::Index i = 0; i < n; ++i)
        scores(i) =
            normal_quantile(u[static_cast<std::size_t>(first[static_cast<std::size_t>(i)])]);
      scores = factor * scores;
    }
    for (std::size_t v = 0; v < random.size(); ++v) {
      const Variable& variable = *random[v];
      auto at = static_cast<std::size_t>(first[v]);
      if (!variable.is_group()) {
        row.push_back(from_share(
            variable, correlated ? normal_cdf(scores(static_cast<Eigen::Index>(v))) : u[at]));
        continue;
      }
      const double lot = variable.common > 0.0 ? normal_quantile(u[at++]) : 0.0;
      for (std::size_t k = 0; k < variable.targets.size(); ++k)
        row.push_back(from_share(variable, variable.common > 0.0
                                               ? normal_cdf(std::sqrt(variable.common) * lot +
                                                            std::sqrt(1.0 - variable.common) *
                                                                normal_quantile(u[at + k]))
                                               : u[at + k]));
    }
    out.push_back(std::move(row));
  }
  return out;
}

/// @param bytes of all runs
long checked(double count, double bytes, const Study& study) {
  if (count > static_cast<double>(kMaxStudyRuns))
    throw InputError(fmt::format(
        "{}: the study has {:.3g} runs, more than the limit of {}; use fewer values or samples",
        study.file.string(), count, kMaxStudyRuns));
  if (bytes > kMaxStudyBytes)
    throw InputError(
        fmt::format("{}: the list of {:.3g} runs needs {:.3g} GB of memory, more than the limit of "
                    "{:.3g} GB; use fewer values or samples",
                    study.file.string(), count, bytes / 1e9, kMaxStudyBytes / 1e9));
  return static_cast<long>(count);
}

void add(const Variable& variable, const std::string& target, double value, Point& out) {
  (variable.option ? out.options : out.sets).emplace_back(target, setting_text(value));
  for (const std::string& name : variable.also) out.sets.emplace_back(name, setting_text(value));
}

/// A point as large as all others of a study with variables.
Point typical_point(const Study& study) {
  std::vector<double> values;
  for (const bool random : {false, true})
    for (const Variable* variable : variables_of_law(study, random))
      values.insert(values.end(), variable->targets.size(),
                    variable->values.empty() ? variable->a : variable->values.front());
  return point_at(study, values);
}

/// Largest count of random numbers of a sample, with the rows that contain them.
double memory_of_sample(const Study& study) {
  double targets = 0.0;
  for (const Variable* variable : variables_of_law(study, true))
    targets += static_cast<double>(variable->targets.size()) + 1.0;
  constexpr double kStoredCopies = 2.0;  // shares of the laws, and values
  return kStoredCopies * (sizeof(std::vector<double>) + targets * sizeof(double));
}

std::vector<Point> what_if_points(const Study& study) {
  std::vector<Point> out;
  for (std::size_t deck = 0; deck < study.decks.size(); ++deck) {
    Point base;
    base.deck = deck;
    base.label = "as it is";
    out.push_back(base);
    for (const WhatIfCase& one : study.cases) {
      Point next = base;
      next.label = one.name;
      next.sets = one.sets;
      next.options = one.options;
      out.push_back(std::move(next));
    }
  }
  return out;
}

}  // namespace

std::string setting_text(double value) { return runs::value_text(value); }

Columns columns_of(const Study& study) {
  Columns out;
  out.decks = study.decks.size() > 1;
  out.labels = study.kind == Kind::WhatIf;
  for (const bool random : {false, true})
    for (const Variable* variable : variables_of_law(study, random))
      out.names.insert(out.names.end(), variable->targets.begin(), variable->targets.end());
  if (!study.bearing_seeds.empty()) out.names.emplace_back("seed");
  return out;
}

double point_memory_bytes(const Point& point) {
  // A text of more than 15 characters has a separate block.
  double own = static_cast<double>(point.values.size() * sizeof(double) + point.label.capacity());
  for (const Settings* settings : {&point.sets, &point.options})
    for (const auto& [name, value] : *settings)
      own += sizeof(Settings::value_type) + static_cast<double>(name.capacity() + value.capacity());
  return sizeof(Point) + sizeof(Task) + 2.0 * own;
}

long count_points(const Study& study) {
  double count = static_cast<double>(study.decks.size());
  if (study.kind == Kind::WhatIf) {
    double bytes = count * point_memory_bytes(Point{});
    for (const WhatIfCase& one : study.cases)
      bytes += count * point_memory_bytes({0, one.sets, one.options, {}, one.name});
    return checked(count * static_cast<double>(study.cases.size() + 1), bytes, study);
  }
  const double each = point_memory_bytes(typical_point(study));
  if (study.kind == Kind::Sensitivity) {
    count *= 1.0 + 4.0 * static_cast<double>(study.variables.size());
    return checked(count, count * each, study);
  }
  for (const Variable* variable : variables_of_law(study, false))
    count *= static_cast<double>(variable->values.size());
  if (study.has_random_variables()) count *= static_cast<double>(study.samples);
  if (!study.bearing_seeds.empty()) count *= static_cast<double>(study.bearing_seeds.size());
  if (study.kind == Kind::WorstCase)
    count += static_cast<double>(count_corners_and_middle(study)) +
             2.0 * static_cast<double>(study.rounds) *
                 static_cast<double>(columns_of(study).names.size());
  return checked(count, count * each + static_cast<double>(study.samples) * memory_of_sample(study),
                 study);
}

Point point_at(const Study& study, const std::vector<double>& values) {
  Point out;
  std::size_t at = 0;
  for (const bool random : {false, true})
    for (const Variable* variable : variables_of_law(study, random))
      for (const std::string& target : variable->targets)
        add(*variable, target, values.at(at++), out);
  out.values = values;
  return out;
}

std::vector<Point> make_points(const Study& study) {
  (void)count_points(study);
  if (study.kind == Kind::Sensitivity) return sensitivity_points(study);
  if (study.kind == Kind::WhatIf) return what_if_points(study);
  const std::vector<const Variable*> values = variables_of_law(study, false);
  const std::vector<std::vector<double>> samples =
      study.has_random_variables() ? sampled(study) : std::vector<std::vector<double>>{{}};
  std::vector<Point> out;
  std::vector<std::size_t> at(values.size(), 0);
  for (std::size_t deck = 0; deck < study.decks.size(); ++deck) {
    bool more = true;
    std::fill(at.begin(), at.end(), std::size_t{0});
    while (more) {
      std::vector<double> grid;
      for (std::size_t v = 0; v < values.size(); ++v) grid.push_back(values[v]->values[at[v]]);
      for (const std::vector<double>& sample : samples) {
        std::vector<double> all = grid;
        all.insert(all.end(), sample.begin(), sample.end());
        Point point = point_at(study, all);
        point.deck = deck;
        if (study.bearing_seeds.empty()) out.push_back(point);
        for (const std::uint64_t seed : study.bearing_seeds) {
          out.push_back(point);
          out.back().options.emplace_back("seed", std::to_string(seed));
          out.back().values.push_back(static_cast<double>(seed));
        }
      }
      more = false;
      for (std::size_t v = values.size(); v-- > 0;) {
        if (++at[v] < values[v]->values.size()) {
          more = true;
          break;
        }
        at[v] = 0;
      }
    }
  }
  return out;
}

}  // namespace adore::studies
