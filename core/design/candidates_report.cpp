#include "design/bearing_candidates.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace adore::design {
namespace {

std::string list_of(const std::vector<std::string>& items) {
  std::string out;
  for (const std::string& one : items) out += (out.empty() ? "" : ", ") + one;
  return out;
}

}  // namespace

std::string candidates_text(const CandidateReport& report) {
  std::string out;
  const deck::Envelope& e = report.bearing.envelope;
  out += fmt::format("{} ({}), {:g} x {:g} x {:g} mm\n", report.bearing.designation,
                     deck::type_name(report.bearing.type), e.bore * 1e3, e.outside * 1e3,
                     e.width * 1e3);
  for (const Contradiction& one : report.contradictions)
    out += fmt::format("CONTRADICTION: {} does not agree with {}.\n", one.first, one.second);
  if (!report.missing.empty())
    out += fmt::format("Missing: {}. Enter these facts.\n", list_of(report.missing));
  if (!report.candidates.empty()) {
    const bool rollers = report.candidates.front().length > 0.0;
    out += fmt::format(
        "{:>3} {:>6} {:>3} {:>8} {:>8} {:>7} {:>6} {:>8} {:>8} {:>7} {:>7} {:>7} {:>7}  "
        "{}\n",
        "", "weight", "Z", "D [mm]", rollers ? "L [mm]" : "groove", "dm [mm]", "angle", "C [kN]",
        "C0 [kN]", "BPFO", "BPFI", "FTF", "BSF", "ratings");
    int number = 0;
    for (const BearingCandidate& one : report.candidates)
      out += fmt::format(
          "{:>3} {:>5.0f}% {:>3} {:>8.3f} {:>8.3g} {:>7.4g} {:>6.4g} {:>8.4g} {:>8.4g} {:>7.4f} "
          "{:>7.4f} {:>7.4f} {:>7.4f}  {}\n",
          ++number, 100.0 * one.weight, one.count, one.diameter * 1e3,
          rollers ? one.length * 1e3 : one.groove, one.pitch * 1e3, one.angle, one.C / 1e3,
          one.C0 / 1e3, one.BPFO, one.BPFI, one.FTF, one.BSF, one.convention);
    const BearingCandidate& first = report.candidates.front();
    out += fmt::format(
        "ESTIMATES from published facts. C and C0 are computed with ISO 281 and ISO 76 for each "
        "geometry. The weight ranks the candidates; it is not a probability. Uncertainty of "
        "candidate 1: element diameter D +- {:.2g} mm, BPFO +- {:.2g} %.\n",
        first.diameter_spread * 1e3, 100.0 * first.factor_spread);
    if (report.left_out > 0)
      out += fmt::format(
          "{} further geometries with less than 7 % of the largest weight are not listed.\n",
          report.left_out);
    if (!report.decisive.empty()) out += report.decisive + "\n";
  }
  for (const std::string& note : report.fact_use) out += note + "\n";
  return out;
}

nlohmann::ordered_json candidates_json(const CandidateReport& report) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BearingCandidate& one : report.candidates)
    list.push_back({{"weight", one.weight},
                    {"count", one.count},
                    {"rows", one.rows},
                    {"element_diameter [m]", one.diameter},
                    {"element_diameter_spread [m]", one.diameter_spread},
                    {"element_length [m]", one.length},
                    {"pitch_diameter [m]", one.pitch},
                    {"contact_angle [deg]", one.angle},
                    {"groove_factor", one.groove},
                    {"C_iso [N]", one.C},
                    {"C0_iso [N]", one.C0},
                    {"BPFO", one.BPFO},
                    {"BPFI", one.BPFI},
                    {"FTF", one.FTF},
                    {"BSF", one.BSF},
                    {"BPFO_spread", one.factor_spread},
                    {"ratings", one.convention}});
  nlohmann::ordered_json wrong = nlohmann::ordered_json::array();
  for (const Contradiction& one : report.contradictions) wrong.push_back({one.first, one.second});
  nlohmann::ordered_json given;  // the user's ratings: those of a maker, not estimates
  if (report.facts.C) given["C [N]"] = *report.facts.C;
  if (report.facts.C0) given["C0 [N]"] = *report.facts.C0;
  if (report.facts.Cu) given["Cu [N]"] = *report.facts.Cu;
  return {{"designation", report.bearing.designation},
          {"type", deck::bearing_type_keyword(report.bearing.type)},
          {"bore [m]", report.bearing.envelope.bore},
          {"outside [m]", report.bearing.envelope.outside},
          {"width [m]", report.bearing.envelope.width},
          {"given_ratings", given.is_null() ? nlohmann::ordered_json::object() : given},
          {"candidates", list},
          {"not_listed", report.left_out},
          {"contradictions", wrong},
          {"missing", report.missing},
          {"decisive", report.decisive},
          {"fact_use", report.fact_use}};
}

}  // namespace adore::design
