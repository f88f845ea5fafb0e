#include "desktop/link_message.hpp"

#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace adore::desktop {
namespace {

constexpr const char *kFormatKey = "adore-link", *kTime = "time", *kElement = "element",
                     *kAction = "action";
constexpr int kVersion = 1, kMostElements = 1'000'000;

}  // namespace

void LinkState::take(const LinkState& change) {
  if (change.time) time = change.time;
  if (change.element) element = change.element;
}

QByteArray link_message(const LinkMessage& message) {
  const LinkState& change = message.change;
  QJsonObject out{{kFormatKey, kVersion}, {kAction, message.action}};
  if (change.time) out[kTime] = *change.time;
  if (change.element) out[kElement] = *change.element;
  return QJsonDocument(out).toJson(QJsonDocument::Compact) + '\n';
}

std::optional<LinkMessage> read_link_message(const QByteArray& line) {
  if (line.size() > kLongestMessage) return std::nullopt;
  const QJsonObject read = QJsonDocument::fromJson(line).object();
  if (read[QLatin1String(kFormatKey)].toDouble() != kVersion) return std::nullopt;
  constexpr qint64 kActionLimit = 1'000'000'000'000;
  LinkMessage message{{}, read[QLatin1String(kAction)].toInteger(-1)};
  if (message.action < 0 || message.action > kActionLimit) return std::nullopt;
  LinkState& out = message.change;
  if (const QJsonValue time = read[QLatin1String(kTime)]; !time.isUndefined()) {
    if (!time.isDouble() || !std::isfinite(time.toDouble())) return std::nullopt;
    out.time = time.toDouble();
  }
  if (const QJsonValue element = read[QLatin1String(kElement)]; !element.isUndefined()) {
    const int number = element.toInt(0);  // 0: not a whole number
    if (number < 1 || number > kMostElements) return std::nullopt;
    out.element = number;
  }
  return out.empty() ? std::nullopt : std::optional(message);
}

}  // namespace adore::desktop
