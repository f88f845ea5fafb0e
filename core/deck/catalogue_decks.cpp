#include "base/counted.hpp"
#include "base/errors.hpp"
#include "deck/catalogue_parts.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "deck/remarks.hpp"
#include "deck/templates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

/// Decks and stories of bearings of the catalogue.
namespace adore::deck {
namespace {

/// Capacity in proportion to that of other bearings of its type: the exponents of ISO 281.
double capacity(BearingType type, const ProposedInternalGeometry& inner) {
  const double count = number(inner, "nRe"), diameter = number(inner, "bReDia");
  const bool ball = type == BearingType::DeepGroove || type == BearingType::AngularContact;
  return ball ? std::pow(count, 2.0 / 3.0) * std::pow(diameter, 1.8)
              : std::pow(count, 3.0 / 4.0) * std::pow(number(inner, "bReLen"), 7.0 / 9.0) *
                    std::pow(diameter, 29.0 / 27.0);
}

double two_digits(double value) {
  if (value == 0.0) return 0.0;
  const double scale = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
  return std::round(value / scale) * scale;
}

std::string read(const Deck& deck, std::string_view name) {
  return fmt::format("{}", deck.real(name));
}

/// Boundary, inside, load and speed of the deck of a type.
std::vector<std::pair<std::string, std::string>> changes(const CatalogueBearing& bearing,
                                                         const ProposedInternalGeometry& inner,
                                                         const Deck& example) {
  const Envelope& e = bearing.envelope;
  auto sets = inner.sets;
  const auto set = [&](const std::string& name, double value) {
    sets.emplace_back(name, fmt::format("{}", std::round(value * 1e7) / 1e7));
  };
  sets.emplace_back("runID", bearing.designation);
  const bool row = bearing.type == BearingType::Spherical;
  set("brgBore", e.bore);
  set("brgOD", e.outside);
  set("hsngOD", e.outside + std::max(0.028, 0.35 * e.outside));
  set("raceWidth1", row ? 0.5 * e.width : e.cup_width);
  set("raceWidth2", row ? 0.5 * e.width : e.width);
  ProposedInternalGeometry there;  // the example's own elements
  there.sets = {{"nRe", fmt::format("{}", example.integer("nRe"))},
                {"bReDia", read(example, "bReDia")}};
  if (example.has("bReLen")) there.sets.emplace_back("bReLen", read(example, "bReLen"));
  const double load = capacity(bearing.type, inner) / capacity(bearing.type, there);
  for (const char* name : {"appLoadX", "appLoadY", "appLoadZ"})
    if (example.has(name) && example.real(name) != 0.0)
      set(name, two_digits(example.real(name) * load));
  const double size = (example.real("brgBore") + example.real("brgOD")) / (e.bore + e.outside);
  // At most n dm = 200,000 mm/min of angular contact bearings, whose example turns at 1.25 million:
  // a usual speed with grease [recalled high].
  constexpr double kGreaseSpeed = 200e3;
  double rpm = example.real("rpm2") * size;
  if (bearing.type == BearingType::AngularContact)
    rpm = std::min(rpm, kGreaseSpeed / (0.5 * (e.bore + e.outside) / kMm));
  set("rpm2", two_digits(rpm));
  if (!bearing.design.empty() && bearing.design != "NU") {
    // Flanges: NU both on the outer ring (1), N both on the inner ring (2), NJ both on the outer
    // and one on the inner ring, NUP both on both rings.
    const bool outer = bearing.design != "N";
    const double height = number(inner, "flngHt11"), angle = example.real("flngAng11");
    std::erase_if(sets, [](const auto& one) { return one.first.starts_with("flng"); });
    for (const auto& [code, present] :
         {std::pair{"11", outer}, {"21", outer}, {"12", true}, {"22", bearing.design != "NJ"}}) {
      sets.emplace_back(fmt::format("kFlngInd{}", code), present ? "1" : "0");
      set(fmt::format("flngHt{}", code), present ? height : 0.0);
      set(fmt::format("flngAng{}", code), present ? angle : 0.0);
    }
    set("flngCls2", example.real("flngCls1"));
  }
  return sets;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out{""};
  for (const char c : text)
    if (c == '\n')
      out.emplace_back();
    else
      out.back() += c;
  if (out.back().empty()) out.pop_back();
  return out;
}

}  // namespace

std::string catalogue_deck(const CatalogueBearing& bearing) {
  const BearingTypeInfo& info = bearing_type_info(bearing.type);
  const std::string text(template_text(info.template_name));
  const Deck example = read_deck_text(text, "example").deck;
  const ProposedInternalGeometry inner =
      propose_internal_geometry(bearing.type, bearing.envelope, bearing.angle, bearing.clearance,
                                bearing.tapered_bore, bearing.known);
  Deck deck = example;
  deck.set_all(changes(bearing, inner, example));
  const std::string outside =
      bearing.rig        ? "boundary dimensions of the test rig bearing (some are assumed)"
      : bearing.standard ? fmt::format("boundary dimensions of {}: {}", bearing.designation,
                                       bearing.type == BearingType::Tapered ? "ISO 355" : "ISO 15")
                         : std::string("boundary dimensions as given");
  const std::vector<std::string> lines = lines_of(with_deck(text, deck).text);
  demand(lines.size() == deck.records.size(), "an example deck has a record on more than one line");
  std::string out;
  for (std::size_t r = 0; r < lines.size(); ++r) {
    const std::string& id = deck.records[r].id;
    std::string remark;
    if (id == "4")
      remark = std::string(kCatalogueOutside) + " [m]: " + outside;
    else if (id == "3.1")
      remark = "name of the run";
    else if (id == "5A" || id == "5B.1" || id == "5C" || id == "5D.1")
      remark = (bearing.rig ? "internal geometry: " : "ESTIMATE of the internal geometry: ") +
               inner.reasons;
    else if (id == "5B.2" || id == "5D.2" || id == "5F")
      remark = "ESTIMATE of the internal geometry";
    else if (id == "9.1.1")
      remark =
          "forces on the inner race, displacements [N, m]: values of the example deck, scaled to "
          "the load capacity of this size; enter your own values" +
          std::string(bearing.type == BearingType::Spherical
                          ? " for one row (half of the radial load of the bearing)"
                          : "");
    else if (id == "9.1.2")
      remark =
          "moments, misalignments, speeds of outer and inner race [N.m, rad, rpm]: enter your own "
          "values";
    if (remark.empty()) {
      out += lines[r] + "\n";
      continue;
    }
    Deck alone;
    alone.records.push_back(deck.records[r]);
    std::string line = write_deck(alone);
    line.pop_back();
    out += line + "   " + remark + "\n";
  }
  return out;
}

std::vector<std::string> describe_catalogue_bearing(const CatalogueBearing& bearing) {
  const Envelope& e = bearing.envelope;
  const ProposedInternalGeometry inner = propose_internal_geometry(
      bearing.type, e, bearing.angle, bearing.clearance, bearing.tapered_bore, bearing.known);
  std::vector<std::string> out;
  const bool known = bearing.known.diameter > 0.0;
  const double pitch = number(inner, "pitchDia");
  out.push_back(fmt::format("{}, {}: bore {:g} mm, outside diameter {:g} mm, width {:g} mm ({}).",
                            bearing.designation, bearing_type_info(bearing.type).name, e.bore / kMm,
                            e.outside / kMm, e.width / kMm,
                            bearing.rig         ? "test rig bearing, some dimensions are assumed"
                            : !bearing.standard ? "as given"
                            : bearing.type == BearingType::Tapered ? "ISO 355"
                                                                   : "ISO 15"));
  if (bearing.angle != 0.0)
    out.push_back(fmt::format(
        "{} {:.4g} degrees ({}).",
        bearing.type == BearingType::Tapered ? "Cup half angle" : "Contact angle", bearing.angle,
        bearing.type == BearingType::Tapered && bearing.angle_given ? "ISO 355"
        : bearing.angle_given                                       ? "from the designation"
        : bearing.type == BearingType::AngularContact
            ? "assumed, because the designation has no suffix for the angle; C means 15, AC 25, B "
              "40 degrees"
            : "an estimate"));
  out.push_back(
      fmt::format("{}: {} of {:.4g} mm on a pitch circle of {:.4g} mm; {}.",
                  bearing.rig ? "Published internal geometry"
                  : known     ? "Internal geometry from published facts"
                              : "ESTIMATED internal geometry (manufacturers do not publish it)",
                  counted(number(inner, "nRe"), "element"), number(inner, "bReDia") / kMm,
                  (pitch > 0.0 ? pitch : 0.5 * (e.bore + e.outside)) / kMm, inner.reasons));
  if (!bearing.left_out.empty())
    out.push_back(
        fmt::format("Ignored parts of the designation: {}. Adore takes only the size, the contact "
                    "angle and the clearance group (of deep groove, cylindrical and spherical "
                    "bearings) from the "
                    "designation.",
                    bearing.left_out));
  if (bearing.tapered_bore && bearing.type == BearingType::Spherical)
    out.push_back(fmt::format(
        "Bearings with a tapered bore (K) have separate clearance groups. The deck has the "
        "clearance of group {} for tapered bores before mounting. Mounting on the tapered seat "
        "reduces this clearance. The bore in the deck is cylindrical: enter its fit (raceFit2), or "
        "the clearance after mounting (freeIntCls).",
        bearing.clearance));
  else if (bearing.tapered_bore)
    out.push_back(fmt::format(
        "Bearings with a tapered bore (K) have separate clearance groups, which are "
        "not available in Adore. The deck has the clearance of group {} for cylindrical "
        "bores.",
        bearing.clearance));
  if (bearing.type == BearingType::Spherical)
    out.emplace_back(
        "The deck describes ONE of the two rows: enter half of the radial load of the bearing. The "
        "life of the bearing is shorter than the life of one row.");
  out.emplace_back(
      "Load and speed are scaled from the example deck of this bearing type: enter your own "
      "values. The deck is quasi-static (mode -1); mode 0 simulates the motion of every element.");
  return out;
}

}  // namespace adore::deck
