#include "assembly/assembly.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::assembly {
namespace {

struct Named {
  const char* name;
  std::vector<int> orientation;
};

/// Back to back: contact lines meet the shaft outside the set. Face to face: between the rows.
const std::vector<Named>& arrangements() {
  static const std::vector<Named> list{
      {"DB", {1, -1}},          {"DF", {-1, 1}},         {"DT", {1, 1}},
      {"TBT", {1, 1, -1}},      {"TFT", {-1, -1, 1}},    {"TT", {1, 1, 1}},
      {"QBC", {1, 1, -1, -1}},  {"QFC", {-1, -1, 1, 1}}, {"QBT", {1, 1, 1, -1}},
      {"QFT", {-1, -1, -1, 1}}, {"QT", {1, 1, 1, 1}}};
  return list;
}

}  // namespace

std::vector<int> orientations(const std::string& arrangement) {
  for (const Named& one : arrangements())
    if (one.name == arrangement) return one.orientation;
  return {};
}

const std::vector<std::string>& arrangement_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const Named& one : arrangements()) out.emplace_back(one.name);
    out.emplace_back("custom");
    return out;
  }();
  return names;
}

std::vector<double> spacer_shifts(const Assembly& assembly) {
  std::vector<double> out(assembly.rows.size(), 0.0);
  for (std::size_t k = 0; k < assembly.spacers.size(); ++k)
    out[k + 1] = out[k] + assembly.spacers[k].inner - assembly.spacers[k].outer;
  return out;
}

std::vector<double> positions(const Assembly& assembly, const std::vector<double>& widths) {
  std::vector<double> out;
  if (assembly.rows.front().position) {
    for (const RowPlacement& row : assembly.rows) out.push_back(*row.position);
    return out;
  }
  double at = 0.0;
  for (std::size_t k = 0; k < widths.size(); ++k) {
    if (!(widths[k] > 0.0))
      throw InputError(
          fmt::format("row {}: the deck does not contain the width of the inner ring, so the "
                      "position is unknown. Enter "
                      "\"position\" in each row of ASSEMBLY.json",
                      k + 1));
    if (k > 0) at += 0.5 * (widths[k - 1] + widths[k]);
    if (k > 0 && !assembly.spacers.empty()) at += assembly.spacers[k - 1].outer;
    out.push_back(at);
  }
  const double ends = -0.5 * widths.front() + at + 0.5 * widths.back();
  for (double& x : out) x -= 0.5 * ends;
  return out;
}

}  // namespace adore::assembly
