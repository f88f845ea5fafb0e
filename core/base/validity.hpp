#pragma once

#include "base/errors.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Register of validity: the ranges within which the laws of the program are known, from the
/// embedded resources/validity.json. Each range is declared once, with quantity, bounds, unit,
/// source and consequence; statics, motion, checks, plots and forms read it here.
namespace adore::validity {

enum class ValidityGrade : unsigned char {
  Note,
  Warning,
  Untrusted,  ///< results are not trusted: exit code 3
  Refused     ///< the deck is rejected: exit code 2
};

inline constexpr double kNoBound = std::numeric_limits<double>::quiet_NaN();

struct Bounds {
  double least = kNoBound, most = kNoBound;  ///< SI; NaN: none
  [[nodiscard]] bool contains(double value) const noexcept {
    return !(value < least) && !(value > most);
  }
};

struct Range {
  std::string id;        ///< "traction.pressure"
  std::string law;       ///< "traction of oil films"
  std::string quantity;  ///< "largest contact pressure"
  std::string unit;      ///< of messages: "GPa"; empty: a pure number
  double per = 1.0;      ///< SI units in one of them
  Bounds bounds;         ///< SI
  std::string bound;     ///< data that has the bounds, when they are not here
  std::string source, consequence;
  ValidityGrade grade = ValidityGrade::Warning;
  bool motion_only = false;
};

/// All ranges, in the order of the file.
[[nodiscard]] std::span<const Range> ranges();
/// @throws InternalError when there is none of that id
[[nodiscard]] const Range& range(std::string_view id);

/// A range that was left, at its worst.
struct Finding {
  const Range* range = nullptr;
  double value = 0.0;        ///< SI
  Bounds bounds;             ///< that applied
  std::string body;          ///< "ball 3, inner race"
  double time = kNoBound;    ///< [s]; NaN: quasi-static solution
  std::size_t instants = 0;  ///< looked at and outside
  std::string detail;        ///< of the data that has the bounds: "Mobil Jet II"
  /// "Traction of oil films: largest contact pressure 1.67 GPa at ball 3, inner race, t = 0.0012 s
  /// (range to 1 GPa). The law is extrapolated; ..."
  [[nodiscard]] std::string text() const;
  /// Distance from the range, in any monotonic measure.
  [[nodiscard]] double excess() const noexcept;
};

/// Keeps the worst value of each range. Values within their range cost a comparison.
class RangeMonitor {
 public:
  /// @param body gives the name of the body, asked only when the value is the worst so far
  template <class Body>
  void offer(const Range& range, double value, double time, Body&& body,
             std::optional<Bounds> own = std::nullopt, std::string_view detail = {}) {
    const Bounds& bounds = own ? *own : range.bounds;
    if (bounds.contains(value)) return;
    Finding& found = find_or_add_finding(range);
    if (found.instants == 0 || found.time != time) ++found.instants;
    if (found.instants > 1 && !(excess(value, bounds) > found.excess())) return;
    found.value = value;
    found.bounds = bounds;
    found.time = time;
    found.body = body();
    found.detail = detail;
  }
  [[nodiscard]] const std::vector<Finding>& findings() const noexcept { return findings_; }

 private:
  Finding& find_or_add_finding(const Range& range);
  friend struct Finding;
  static double excess(double value, const Bounds& bounds) noexcept;

  std::vector<Finding> findings_;
};

/// Remarks on findings: one for each warning, one for all notes together.
[[nodiscard]] std::vector<std::pair<Severity, std::string>> remarks(
    std::span<const Finding> findings);

}  // namespace adore::validity
