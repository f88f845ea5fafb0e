#include "runs/run_ending.hpp"

#include "base/interrupted.hpp"
#include "base/write_error.hpp"
#include "deck/reader.hpp"
#include "deck/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::runs {

RunEnding run_catching_errors(const RunRequest& request, const std::stop_token& stop) {
  RunEnding out;
  try {
    out.outcome = run(request, {}, stop);
    out.exit_code = out.outcome.status == RunStatus::Done          ? 0
                    : out.outcome.status == RunStatus::Interrupted ? 130
                                                                   : 3;
  } catch (const WriteError& error) {
    out.failure = error.what();
    out.exit_code = 2;
    out.not_written = true;
  } catch (const InputError& error) {
    out.failure = error.what();
    out.exit_code = 2;
  } catch (const SolverError& error) {
    out.failure = error.what();
    out.exit_code = 3;
  } catch (const Interrupted& error) {
    out.failure = error.what();
    out.exit_code = 130;
  }
  return out;
}

std::string value_text(double value) {
  constexpr double kMaxWholeNumber = 1e15;
  return value == std::round(value) && std::abs(value) < kMaxWholeNumber
             ? fmt::format("{:.0f}", value)
             : fmt::format("{}", value);
}

std::string variable_unit(const DeckRequest& request, const std::string& variable) {
  const auto found = deck::find_variable(variable.substr(0, variable.find('[')));
  if (found.empty()) return {};
  const deck::ReadResult read = read_deck(request);
  if (!read.ok()) return {};
  const deck::UnitPair& unit = found.front().spec().unit;
  const std::string_view name = read.deck.units() == deck::UnitSystem::SI ? unit.si : unit.en;
  return name == "-" ? std::string() : std::string(name);
}

std::string quoted_message_field(std::string message) {
  std::replace(message.begin(), message.end(), '"', '\'');
  std::replace(message.begin(), message.end(), '\n', ' ');
  return "\"" + message + "\"";
}

}  // namespace adore::runs
