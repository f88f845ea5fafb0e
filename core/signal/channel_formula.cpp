#include "signal/channel_formula.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <muParser.h>
#include <numbers>

namespace adore::signal {
namespace {

InputError invalid(const std::string& formula, const std::string& why) {
  return InputError(fmt::format("Formula \"{}\": {}", formula, why));
}

mu::Parser parser_of(const std::string& formula) {
  mu::Parser parser;
  parser.DefineConst("pi", std::numbers::pi);
  parser.SetExpr(formula);
  return parser;
}

bool is_missing(double value) { return !std::isfinite(value); }

}  // namespace

bool is_formula_name(std::string_view name) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (name.empty() || !letter(name.front()) || name == "pi") return false;
  if (!std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || digit(c); }))
    return false;
  mu::Parser parser;
  return parser.GetFunDef().count(std::string(name)) == 0 &&
         parser.GetConst().count(std::string(name)) == 0;
}

std::vector<std::string> variable_names_in(const std::string& formula) {
  try {
    mu::Parser parser = parser_of(formula);
    std::vector<std::string> out;
    for (const auto& [name, address] : parser.GetUsedVar()) out.push_back(name);
    return out;
  } catch (const mu::Parser::exception_type& error) {
    throw invalid(formula, error.GetMsg());
  }
}

std::vector<double> evaluate(const std::string& formula, const NamedSeries& series) {
  const std::vector<std::string> names = variable_names_in(formula);
  std::size_t count = 0;
  std::vector<const std::vector<double>*> used;
  for (const std::string& name : names) {
    const auto found = series.find(name);
    if (found == series.end()) {
      std::vector<std::string> known;
      for (const auto& one : series) known.push_back(one.first);
      throw invalid(formula, fmt::format("\"{}\" is not a channel of this formula. Known names: {}",
                                         name, fmt::join(known, ", ")));
    }
    if (!used.empty() && found->second.size() != count)
      throw invalid(formula, "the channels have different numbers of values");
    count = found->second.size();
    used.push_back(&found->second);
  }
  if (used.empty()) throw invalid(formula, "it uses no channel");
  try {
    mu::Parser parser = parser_of(formula);
    std::vector<double> now(names.size(), 0.0);
    for (std::size_t k = 0; k < names.size(); ++k) parser.DefineVar(names[k], &now[k]);
    std::vector<double> out(count, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < used.size(); ++k) now[k] = (*used[k])[i];
      if (std::any_of(now.begin(), now.end(), is_missing)) continue;
      const double value = parser.Eval();
      if (!is_missing(value)) out[i] = value;
    }
    return out;
  } catch (const mu::Parser::exception_type& error) {
    throw invalid(formula, error.GetMsg());
  }
}

}  // namespace adore::signal
