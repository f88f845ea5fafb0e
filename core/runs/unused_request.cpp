#include "runs/unused_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace adore::runs {
namespace {

constexpr std::array<std::string_view, 8> kMotionOptions = {
    "ellipseMajor", "ellipseMinor",      "contactSurface", "hertzConstants",
    "landSlices",   "checkpointSeconds", "resultsH5",      "contactDamping"};
constexpr std::array<std::string_view, 4> kBallMotionOptions = {"ellipseMajor", "ellipseMinor",
                                                                "contactSurface", "hertzConstants"};
constexpr std::array<std::string_view, 2> kRollerOptions = {"rollerSlices", "rollerContact"};

template <std::size_t N>
bool is_in(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names)
    out += (out.empty() ? "" : &name == &names.back() ? " and " : ", ") + name;
  return out;
}

Issue note(const Prepared& prepared, const std::vector<std::string>& names,
           const std::string& because) {
  Issue issue;
  issue.severity = Severity::Note;
  issue.code = "run.unused_request";
  issue.file = prepared.input.path.string();
  issue.message = fmt::format("{} {} without effect, because {}", listed(names),
                              names.size() == 1 ? "is" : "are", because);
  return issue;
}

}  // namespace

std::vector<Issue> unused_request(const RunRequest& request, const Prepared& prepared) {
  std::vector<std::string> motion, balls, rollers;
  if (!prepared.control.dynamic) {
    if (!request.until.empty()) motion.emplace_back("--until");
    if (!request.integrator.empty()) motion.emplace_back("--integrator");
    if (request.tolerance) motion.emplace_back("--tol");
  }
  for (const auto& [name, value] : prepared.input.option_values) {
    if (!prepared.control.dynamic && is_in(kMotionOptions, name))
      motion.push_back("option " + name);
    if (!prepared.bearing.rollers() && is_in(kRollerOptions, name))
      rollers.push_back("option " + name);
    if (prepared.control.dynamic && prepared.bearing.rollers() && is_in(kBallMotionOptions, name))
      balls.push_back("option " + name);
  }
  std::vector<Issue> out;
  if (!motion.empty())
    out.push_back(note(prepared, motion, "mode = -1 gives the quasi-static solution only"));
  if (!balls.empty()) out.push_back(note(prepared, balls, "the bearing has rollers"));
  if (!rollers.empty()) out.push_back(note(prepared, rollers, "the bearing has balls"));
  if (request.until.empty())
    if (std::optional<Issue> issue = no_step_note(prepared.input.deck))
      out.push_back(std::move(*issue));
  return out;
}

std::string why_no_step(const deck::Deck& deck) {
  if (deck.integer("mode") < 0) return {};
  if (deck.integer("maxStps") == 0) return "maxStps is 0";
  return deck.real("fTime") == 0.0 ? "fTime is 0" : "";
}

std::optional<Issue> no_step_note(const deck::Deck& deck) {
  const std::string why = why_no_step(deck);
  if (why.empty()) return std::nullopt;
  const bool steps = why.rfind("maxStps", 0) == 0;
  Issue out;
  out.severity = Severity::Note;
  out.code = "deck.no_step";
  out.file = deck.file;
  out.record = steps ? "1" : "2.1";
  out.variable = steps ? "maxStps" : "fTime";
  out.value = "0";
  out.message = "the run makes no steps, so it computes no motion";
  out.remedy =
      std::string(
          steps ? "enter the number of steps, such as 2000, or give the end of the run with --until"
                : "enter the dimensionless end time, such as 1000, or give the end of the run with "
                  "--until") +
      ". To store every step, set kPltFreq = 1 and kAGraf = 1";
  return out;
}

}  // namespace adore::runs
