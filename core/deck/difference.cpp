#include "deck/difference.hpp"

#include "deck/lookup.hpp"
#include "deck/unit_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace adore::deck {
namespace {

constexpr double kSameQuantity = 1e-9;  // relative, after a conversion of units

std::string number_of(const RecordSpec& record, int instance) {
  return record.repeat.empty() ? std::string(record.id)
                               : fmt::format("{} ({})", record.id, instance);
}

/// Of a code, also of one that stands for any larger or smaller number; empty without codes.
std::string_view meaning_of(const VariableSpec& variable, long long code) {
  const std::string text = fmt::format("{}", code);
  const auto search = [](std::span<const OptionSpec> options, std::string_view wanted) {
    const auto found = std::find_if(options.begin(), options.end(),
                                    [&](const OptionSpec& o) { return o.code == wanted; });
    return found == options.end() ? std::string_view() : found->meaning;
  };
  std::string_view meaning = search(variable.options, text);
  if (meaning.empty() && !variable.option_table.empty())
    meaning = search(option_table(variable.option_table), text);
  return meaning.empty() ? search(variable.options, code < 0 ? "-n" : "n") : meaning;
}

/// "250 (every n-th step)", "0.06 m", "'Rec 5A'", "no value"
std::string described(const Deck& deck, const VariableSpec& variable, const Value& value) {
  if (std::holds_alternative<std::monostate>(value)) return "no value";
  std::string text = value_text(value);
  if (const auto* integer = std::get_if<long long>(&value)) {
    const std::string_view meaning = meaning_of(variable, *integer);
    if (!meaning.empty()) text += fmt::format(" ({})", meaning);
  } else if (const std::string_view unit = unit_name(deck, variable); !unit.empty()) {
    text += fmt::format(" {}", unit);
  }
  return text;
}

class Comparison {
 public:
  Comparison(const Deck& left, const Deck& right)
      : left_(left), right_(right), converts_(left.units() != right.units()) {}

  std::vector<Difference> run() {
    for (const RecordSpec& spec : schema()) {
      const int here = count(left_, spec), there = count(right_, spec);
      for (int i = 1; i <= std::max(here, there); ++i) {
        const RecordData* a = find_record_data(left_, spec.id, i);
        const RecordData* b = find_record_data(right_, spec.id, i);
        if (a != nullptr && b != nullptr)
          compare(spec, *a, *b);
        else if (a != nullptr || b != nullptr)
          add_record(spec, i, a != nullptr);
      }
    }
    compare_lines();
    return std::move(out_);
  }

 private:
  static int count(const Deck& deck, const RecordSpec& spec) {
    int most = 0;
    for (const RecordData& record : deck.records)
      if (record.id == spec.id && (!is_extension(spec.id) || has_values(record)))
        most = std::max(most, record.instance);
    return most;
  }

  void add_record(const RecordSpec& spec, int instance, bool here) {
    Difference d;
    d.record = spec.id;
    d.instance = instance;
    d.in_left = here;
    d.in_right = !here;
    d.sentence = fmt::format("record {}, {}: only {}", number_of(spec, instance), spec.title,
                             here ? "here" : "there");
    out_.push_back(std::move(d));
  }

  void compare(const RecordSpec& spec, const RecordData& a, const RecordData& b) {
    static const std::vector<Value> kNone;
    for (std::size_t v = 0; v < spec.variables.size(); ++v) {
      const std::vector<Value>& here = v < a.values.size() ? a.values[v] : kNone;
      const std::vector<Value>& there = v < b.values.size() ? b.values[v] : kNone;
      for (std::size_t k = 0; k < std::max(here.size(), there.size()); ++k)
        compare(spec, a.instance, v, k, k < here.size() ? &here[k] : nullptr,
                k < there.size() ? &there[k] : nullptr);
    }
  }

  void compare(const RecordSpec& spec, int instance, std::size_t v, std::size_t k,
               const Value* here, const Value* there) {
    const VariableSpec& variable = spec.variables[v];
    std::string relation;
    if (here != nullptr && there != nullptr && same(variable, *here, *there, relation)) return;
    Difference d;
    d.record = spec.id;
    d.instance = instance;
    d.variable = variable.name;
    d.index = variable.length == "1" ? 0 : static_cast<int>(k) + 1;
    d.in_left = here != nullptr;
    d.in_right = there != nullptr;
    d.label = v == 0;
    if (here != nullptr) d.left = described(left_, variable, *here);
    if (there != nullptr) d.right = described(right_, variable, *there);
    std::string name(variable.name);
    if (!spec.repeat.empty()) name += fmt::format("[{}]", instance);
    if (d.index > 0) name += fmt::format("[{}]", d.index);
    d.sentence = fmt::format("{}: {} here, {} there{}", name, d.in_left ? d.left : "none",
                             d.in_right ? d.right : "none", relation);
    out_.push_back(std::move(d));
  }

  /// Sets `relation` to how much the right one differs where that says something.
  bool same(const VariableSpec& variable, const Value& here, const Value& there,
            std::string& relation) const {
    const double* a = std::get_if<double>(&here);
    const double* b = std::get_if<double>(&there);
    if (a == nullptr || b == nullptr) return here == there;
    double other = *b;
    if (converts_ && depends_on_units(left_, variable) && depends_on_units(right_, variable)) {
      other = convert_value(*b, variable.unit, right_.units(), left_.units());
      if (std::abs(other - *a) <= kSameQuantity * std::abs(*a)) return true;
      relation = fmt::format(", which is {:.6g} {}", other, unit_name(left_, variable));
    }
    if (other == *a) return true;
    if (*a != 0.0 && other / *a > 0.0) {
      const double percent = 100.0 * (other / *a - 1.0);
      if (std::abs(percent) < 1000.0)
        relation += fmt::format(" ({:.3g} % {})", std::abs(percent), percent > 0 ? "more" : "less");
      else
        relation += fmt::format(" ({:.3g} times as much)", other / *a);
    }
    return false;
  }

  void compare_lines() {
    const std::size_t most = std::max(left_.user_lines.size(), right_.user_lines.size());
    for (std::size_t i = 0; i < most; ++i) {
      Difference d;
      d.record = "12";
      d.index = static_cast<int>(i) + 1;
      d.in_left = i < left_.user_lines.size();
      d.in_right = i < right_.user_lines.size();
      if (d.in_left) d.left = left_.user_lines[i];
      if (d.in_right) d.right = right_.user_lines[i];
      if (d.in_left && d.in_right && d.left == d.right) continue;
      d.sentence = fmt::format("input line {} of user routines: {} here, {} there", d.index,
                               d.in_left ? "\"" + d.left + "\"" : "none",
                               d.in_right ? "\"" + d.right + "\"" : "none");
      out_.push_back(std::move(d));
    }
  }

  const Deck& left_;
  const Deck& right_;
  bool converts_;
  std::vector<Difference> out_;
};

}  // namespace

std::vector<Difference> differences(const Deck& left, const Deck& right) {
  return Comparison(left, right).run();
}

}  // namespace adore::deck
