#include "cli/progress.hpp"

#include "base/duration.hpp"
#include "base/json_text.hpp"
#include "cli/streams.hpp"
#include "command_line/terminal.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <limits>
#include <unistd.h>
#include <vector>

namespace adore::cli {
namespace {

constexpr std::size_t kAnyWidth = std::numeric_limits<std::size_t>::max();

/// The first that fits; the last is cut.
std::string fitting(const std::vector<std::string>& forms, std::size_t width) {
  for (const std::string& form : forms)
    if (form.size() <= width) return form;
  return forms.back().substr(0, width);
}

/// Columns of one line: a full last column would wrap on some terminals.
std::size_t room() { return command_line::columns(STDERR_FILENO) - 1; }

/// Lines of a file or pipe: at most one every two seconds, and the last.
class PlainLines {
 public:
  void say_if_due(double elapsed, bool last, const std::string& line) {
    if (elapsed - said_ < 2.0 && !last) return;
    said_ = elapsed;
    tell(line + "\n", false);
  }

 private:
  double said_ = -1e9;
};

nlohmann::ordered_json json_of(const runs::Progress& p) {
  return {{"fraction", p.fraction}, {"revolutions", p.revolutions},
          {"time", p.time},         {"end_time", p.end_time},
          {"step", p.step},         {"last_step", p.last_step},
          {"elapsed", p.elapsed},   {"remaining", p.remaining},
          {"speed_up", p.speed_up}};
}

}  // namespace

std::string progress_line(const runs::Progress& p, std::size_t width) {
  const std::string share = fmt::format("{:3.0f}%", 100.0 * p.fraction);
  const std::string left = duration_text(p.remaining);
  // The remaining time is unknown before the first one is computed.
  if (p.runs > 0 && p.step < p.runs && !(p.remaining > 0.0))
    return fitting({fmt::format("{}  {} {} of {}", share, p.piece, p.step, p.runs), share}, width);
  if (p.runs > 0)
    return fitting({fmt::format("{}  {} {} of {}  ETA {}", share, p.piece, p.step, p.runs, left),
                    fmt::format("{}  {}/{}", share, p.step, p.runs), share},
                   width);
  const std::string turns = fmt::format("{}  {:.3f} rev", share, p.revolutions);
  // The limit that ends the run: its time or its number of steps.
  const std::string goal =
      p.last_step > 0
          ? fmt::format("{}  t = {:.4e} s  step {} of {}", turns, p.time, p.step, p.last_step)
          : fmt::format("{}  t = {:.4e} of {:.4e} s  step {}", turns, p.time, p.end_time, p.step);
  return fitting(
      {fmt::format("{}  {:.3g}x real time  ETA {}", goal, p.speed_up, left),
       fmt::format("{}  t = {:.4e} s  step {}  ETA {}", turns, p.time, p.step, left),
       fmt::format("{}  step {}  ETA {}", turns, p.step, left),
       fmt::format("{}  ETA {}", turns, left), fmt::format("{}  ETA {}", share, left), share},
      width);
}

runs::ProgressSink make_progress(const std::string& style) {
  if (style == "none") return {};
  if (style == "json")
    return [](const runs::Progress& p) { tell(dump_json(json_of(p)) + "\n", false); };
  if (style == "auto" && command_line::is_terminal(STDERR_FILENO))
    return [](const runs::Progress& p) {
      tell("\r\033[K" + progress_line(p, room()) + (p.fraction >= 1.0 ? "\n" : ""), false);
    };
  return [lines = PlainLines()](const runs::Progress& p) mutable {
    lines.say_if_due(p.elapsed, p.fraction >= 1.0, progress_line(p, kAnyWidth));
  };
}

CountSink make_count_progress(const std::string& what, const std::string& style) {
  if (style == "none") return {};
  using Clock = std::chrono::steady_clock;
  const auto line = [what](long done, long total, double elapsed, std::size_t width) {
    const std::string share =
        fmt::format("{:3.0f}%", 100.0 * static_cast<double>(done) / static_cast<double>(total));
    const double left = elapsed * static_cast<double>(total - done) / static_cast<double>(done);
    return fitting(
        {fmt::format("{}  {} {} of {}  ETA {}", share, what, done, total, duration_text(left)),
         fmt::format("{}  {}/{}", share, done, total), share},
        width);
  };
  const bool terminal = command_line::is_terminal(STDERR_FILENO);
  // `drawn`: when the terminal's line was last written, not more than 20 times a second.
  return
      [=, begin = Clock::now(), drawn = -1.0, lines = PlainLines()](long done, long total) mutable {
        if (done < 1 || total < 1) return;
        const double elapsed = std::chrono::duration<double>(Clock::now() - begin).count();
        const bool last = done >= total;
        if (style == "json") {
          const nlohmann::ordered_json json{
              {"fraction", static_cast<double>(done) / static_cast<double>(total)},
              {"done", done},
              {"total", total},
              {"elapsed", elapsed}};
          tell(dump_json(json) + "\n", false);
        } else if (style == "auto" && terminal) {
          if (elapsed - drawn < 0.05 && !last) return;
          drawn = elapsed;
          tell("\r\033[K" + line(done, total, elapsed, room()) + (last ? "\n" : ""), false);
        } else if (total > 1) {
          lines.say_if_due(elapsed, last && elapsed > 2.0, line(done, total, elapsed, kAnyWidth));
        }
      };
}

}  // namespace adore::cli
