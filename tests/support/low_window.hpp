#pragma once

#include <QCoreApplication>
#include <QString>
#include <QWidget>

#include <array>

/// Windows on low screens: what they tell more never makes them larger.
namespace adore::test {

/// A small window, and the largest that fits on screens of that size and of 640x480 with its frame.
inline constexpr std::array<QSize, 3> kLowWindows{QSize(700, 450), QSize(684, 402),
                                                  QSize(624, 432)};

/// How a window that was given a size outgrew it; empty when it did not.
inline QString grown(const QWidget& window, QSize given) {
  for (int round = 0; round < 3; ++round) QCoreApplication::processEvents();  // heights in rounds
  const QSize least = window.minimumSizeHint();
  const auto beyond = [&](QSize size) {
    return size.width() > given.width() || size.height() > given.height();
  };
  if (!beyond(window.size()) && !beyond(least)) return {};
  return QString("%1 x %2, at least %3 x %4, of %5 x %6")
      .arg(window.width())
      .arg(window.height())
      .arg(least.width())
      .arg(least.height())
      .arg(given.width())
      .arg(given.height());
}

}  // namespace adore::test
