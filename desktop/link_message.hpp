#pragma once

#include <QByteArray>

#include <optional>

/// Messages between linked windows (run_link.hpp): one line of JSON each,
///   {"adore-link": 1, "action": 7, "time": 0.0123, "element": 3}
namespace adore::desktop {

/// Values that windows share. A message has only the parts that change.
struct LinkState {
  std::optional<double> time;  ///< of the cursor or frame [s]
  std::optional<int> element;  ///< selected rolling element, from 1
  bool operator==(const LinkState&) const = default;
  [[nodiscard]] bool empty() const { return !time && !element; }
  /// Takes over the parts of another one.
  void take(const LinkState& change);
};

/// A change, and the number of the user's action that it follows: actions count up over all
/// windows, the frames of a playing animation have the number of the action that started it. A
/// message with an older number was sent before its window knew of the action.
struct LinkMessage {
  LinkState change;
  long long action = 0;
  bool operator==(const LinkMessage&) const = default;
};

/// Longest valid message with its end of line [bytes].
inline constexpr int kLongestMessage = 256;

[[nodiscard]] QByteArray link_message(const LinkMessage& message);
/// Nothing for any other line: not JSON, too long, a newer version, a time that is not finite, a
/// number out of range.
[[nodiscard]] std::optional<LinkMessage> read_link_message(const QByteArray& line);

}  // namespace adore::desktop
