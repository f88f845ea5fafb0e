#pragma once

#include "json_mutator.hpp"

#include <QGuiApplication>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

/// Common parts of fuzzers of files that become pictures.
namespace adore::testing {

/// Text on pictures needs an application, none of them a screen.
/// A number without a value that reaches the painter is a fault.
inline void start_qt() {
  static const bool started = [] {
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString& message) {
      if (message.contains(QLatin1String("NaN"))) std::abort();
    });
    ::setenv("QT_QPA_PLATFORM", "offscreen", 0);
    static int count = 1;
    static char name[] = "fuzz";
    static char* arguments[] = {name, nullptr};
    static const auto* const application = new QGuiApplication(count, arguments);
    return application != nullptr;
  }();
  (void)started;
}

/// One to three values of a JSON file changed.
inline std::size_t change_json(std::uint8_t* data, std::size_t size, std::size_t most,
                               unsigned seed) {
  JsonMutator mutator(seed);
  std::string text(reinterpret_cast<const char*>(data), size);
  nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return std::min(size, most);
  for (std::size_t left = 1 + mutator.below(3); left > 0; --left) mutator.change(json);
  text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const std::size_t out = std::min(text.size(), most);
  std::memcpy(data, text.data(), out);
  return out;
}

}  // namespace adore::testing
