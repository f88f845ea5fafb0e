#include "validation/experiment_data.hpp"

#include "base/errors.hpp"
#include "base/json_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace adore::validation {
namespace {

constexpr std::array<std::string_view, 3> kKinds{"calibration", "prediction", "part"};
constexpr std::array<std::string_view, 3> kTypes{"value", "bound", "sign"};
constexpr std::array<std::string_view, 3> kSigns{"+", "-", "0"};

/// @returns the place of the word in the list
template <std::size_t N>
std::size_t word(const JsonMembers& in, std::string_view member, std::string_view text,
                 const std::array<std::string_view, N>& list) {
  const auto* const found = std::find(list.begin(), list.end(), text);
  if (found == list.end())
    in.reject(
        fmt::format("{} = \"{}\": unknown. Use one of {}", member, text, fmt::join(list, ", ")));
  return static_cast<std::size_t>(found - list.begin());
}

DeckSets read_sets(JsonMembers& in, std::string_view name) {
  DeckSets out;
  const nlohmann::json* const sets = in.find(name);
  if (sets == nullptr) return out;
  if (!sets->is_object()) in.reject(fmt::format("member \"{}\" must be an object", name));
  for (const auto& [variable, value] : sets->items()) {
    if (!value.is_number() && !value.is_string())
      in.reject(fmt::format("{}, {}: must be a number or a string", name, variable));
    out.emplace_back(variable, value.is_string() ? value.get<std::string>() : dump_json(value));
  }
  return out;
}

template <class Read>
auto part(JsonMembers& in, std::string_view name, Read read)
    -> std::optional<decltype(read(std::declval<JsonMembers&>()))> {
  const nlohmann::json* const found = in.find(name);
  if (found == nullptr) return std::nullopt;
  JsonMembers members(*found, fmt::format("{}, {}", in.where(), name));
  auto out = read(members);
  members.finish();
  return out;
}

void read_theirs(JsonMembers& in, RowData& row) {
  const nlohmann::json* const theirs = in.find("theirs");
  if (theirs == nullptr) return;
  if (row.type == RowType::Sign) {
    row.their_sign = in.text("theirs");
    (void)word(in, "theirs", row.their_sign, kSigns);
  } else if (theirs->is_array()) {
    const std::vector<double> range = in.numbers("theirs");
    if (range.size() != 2 || !(range[0] <= range[1]))
      in.reject("member \"theirs\" must be a number or a range [least, most]");
    row.theirs = range[0];
    row.theirs_to = range[1];
  } else {
    row.theirs = in.number("theirs");
  }
}

RowData read_row(JsonMembers& in, const std::string& kind, const std::string& certainty) {
  RowData out;
  out.of = in.text("of");
  out.quantity = in.text("quantity", "");
  out.what = in.text("what", "");
  out.unit = in.text("unit");
  out.kind = in.text("kind", kind);
  (void)word(in, "kind", out.kind, kKinds);
  out.type = static_cast<RowType>(word(in, "type", in.text("type", "value"), kTypes));
  read_theirs(in, out);
  out.certainty = in.text("certainty", certainty);
  if (out.certainty.empty())
    in.reject(
        "member \"certainty\" is missing. Give it in the row or in "
        "its run");
  check_certainty(out.certainty, in.where());
  const bool given = out.theirs || !out.their_sign.empty();
  const bool aside = out.certainty.starts_with("kept aside");
  if (aside && given)
    in.reject(
        "a row with certainty \"kept aside\" must not contain the measured value. Remove the "
        "member \"theirs\"");
  if (!aside && !given && out.kind != "part")
    in.reject(
        "member \"theirs\" is missing. Give it, set \"kind\" to \"part\", or set \"certainty\" to "
        "\"kept aside\"");
  out.rating = in.number("rating", 0.0);
  if (in.find("from") != nullptr) out.from = in.number("from");
  if (in.find("reference") != nullptr) out.reference = in.number("reference");
  in.finish();
  return out;
}

VariableSweepData read_over(JsonMembers& in) {
  VariableSweepData out{in.text("variable"), in.numbers("values")};
  if (out.values.size() < 2) in.reject("member \"values\" needs two or more numbers");
  return out;
}
MotionData read_motion(JsonMembers& in) {
  return {in.text("deck", ""), in.text("until"), read_sets(in, "set")};
}
RunDownData read_run_down(JsonMembers& in) {
  return {in.text("deck"), in.number("inertia"), read_sets(in, "set")};
}
TwinDiscData read_discs(JsonMembers& in) {
  return {in.integer("kTrac"), in.number("T"), in.number("radius"), in.number("speed"),
          in.numbers("pressure")};
}
FilmData read_film(JsonMembers& in) {
  return {in.number("radius"), in.number("k"),         in.number("load"),
          in.number("speed"),  in.number("viscosity"), in.number("alpha")};
}
OilFractionData read_oil_share(JsonMembers& in) { return {in.number("c"), in.number("p")}; }
HottestRingData read_ring(JsonMembers& in) {
  HottestRingData out{in.number("temperature"), in.text("certainty")};
  check_certainty(out.certainty, in.where());
  return out;
}

RunData read_run(JsonMembers& in) {
  RunData out;
  out.condition = in.text("condition");
  out.deck = in.text("deck", "");
  out.set = read_sets(in, "set");
  out.options = read_sets(in, "options");
  out.subtract = read_sets(in, "subtract");
  out.over = part(in, "over", read_over);
  out.motion = part(in, "motion", read_motion);
  out.run_down = part(in, "run_down", read_run_down);
  out.discs = part(in, "discs", read_discs);
  out.film = part(in, "film", read_film);
  out.oil_share = part(in, "oil_share", read_oil_share);
  out.hottest_ring = part(in, "hottest_ring", read_ring);
  if (out.deck.empty() && !out.discs && !out.film)
    in.reject("one of the members \"deck\", \"discs\" and \"film\" must be given");
  if (!out.deck.empty() && (out.discs || out.film))
    in.reject("a run with \"discs\" or \"film\" has no deck. Remove \"deck\"");
  const std::string kind = in.text("kind", "prediction"), certainty = in.text("certainty", "");
  for (JsonMembers& row : in.objects("rows", "row"))
    out.rows.push_back(read_row(row, kind, certainty));
  if (out.rows.empty()) in.reject("a run needs at least one row in \"rows\"");
  in.finish();
  return out;
}

NotComputed read_not_computed(JsonMembers& in) {
  NotComputed out{in.text("condition"), in.text("what"),      in.text("unit", "-"),
                  in.text("theirs"),    in.text("certainty"), in.text("reason")};
  check_certainty(out.certainty, in.where());
  in.finish();
  return out;
}

ParameterData read_parameter(JsonMembers& in) {
  ParameterData out{in.text("name"), in.text("meaning"), in.number("value"), in.number("low"),
                    in.number("high")};
  if (!(out.low < out.high) || out.value < out.low || out.value > out.high)
    in.reject(fmt::format("\"value\" = {:g} must be between \"low\" = {:g} and \"high\" = {:g}",
                          out.value, out.low, out.high));
  in.finish();
  return out;
}

ExperimentData read_experiment(JsonMembers& in, std::string_view name) {
  ExperimentData out;
  out.id = in.text("id");
  in.set_where(fmt::format("{}, {}", name, out.id));
  out.source = in.text("source");
  out.about = in.text("about");
  out.open = in.text("open", "");
  out.assumed = in.texts("assumed");
  out.table = in.text("table", "");
  for (JsonMembers& one : in.objects("parameters", "parameter"))
    out.parameters.push_back(read_parameter(one));
  for (JsonMembers& one : in.objects("runs", "run")) out.runs.push_back(read_run(one));
  for (JsonMembers& one : in.objects("not_computed", "not_computed"))
    out.not_computed.push_back(read_not_computed(one));
  if (out.runs.empty() && out.not_computed.empty() && out.table.empty() && out.open.empty())
    in.reject(
        "an experiment needs at least one of the members \"runs\", \"not_computed\", \"table\" and "
        "\"open\"");
  in.finish();
  return out;
}

}  // namespace

const std::vector<std::string>& certainty_words() {
  static const std::vector<std::string> words{
      "printed",         "seen",         "measured",   "digitised", "inferred", "recalled high",
      "recalled medium", "recalled low", "kept aside", "derived",   "none"};
  return words;
}

void check_certainty(const std::string& text, const std::string& where) {
  for (const std::string& one : certainty_words())
    if (text.starts_with(one)) return;
  throw InputError(fmt::format("{}: certainty = \"{}\": must begin with one of {}", where, text,
                               fmt::join(certainty_words(), ", ")));
}

std::vector<ExperimentData> read_experiments(std::string_view json, std::string_view name) {
  const nlohmann::json all = parse_json(json, name);
  JsonMembers in(all, std::string(name));
  (void)in.find("meta");
  std::vector<ExperimentData> out;
  for (JsonMembers& one : in.objects("experiments", "experiment")) {
    out.push_back(read_experiment(one, name));
    for (std::size_t n = 0; n + 1 < out.size(); ++n)
      if (out[n].id == out.back().id) one.reject("two experiments have this id");
  }
  if (out.empty()) in.reject("there is no experiment");
  in.finish();
  return out;
}

}  // namespace adore::validation
