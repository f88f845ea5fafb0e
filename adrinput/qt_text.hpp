#pragma once

#include <QString>

#include <string_view>

namespace adore::adrinput {

/// @param text UTF-8
[[nodiscard]] inline QString text_of(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace adore::adrinput
