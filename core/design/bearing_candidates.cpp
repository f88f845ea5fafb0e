#include "design/bearing_candidates.hpp"

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "life/iso281.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace adore::design {
namespace {

constexpr double kMm = 1e-3, kInch64 = 25.4 / 64.0;
constexpr double kWeightLimit =
    0.07;  // the least with at most 5 candidates in the median of "rules"
constexpr std::size_t kMaxListed = 12;
constexpr double kPitchLimit = 0.03, kPitchSpread = 0.008;
constexpr double kFactorSpread = 0.003,
                 kLimit = 4.0;     // spreads of a printed factor; z of all facts
constexpr double kMaxRatio = 0.5;  // γ

/// A fact of the search; bits of a mask.
enum Fact : unsigned {
  kC = 1,
  kC0 = 2,
  kBPFO = 4,
  kBPFI = 8,
  kFTF = 16,
  kBSF = 32,
  kCount = 64,
  kDiameter = 128,
  kLength = 256,
  kPitch = 512,
  kWidth = 1024,
};
constexpr unsigned kAllFacts = 2047;

struct Size {
  double diameter;  ///< [mm]
  double weight;
  double spread;  ///< [mm]
};

std::vector<Size> ball_sizes() {
  std::vector<Size> out;
  for (int n = 4; n <= 64 * 4; ++n) {
    const double diameter = n * kInch64;
    const bool odd = n % 2 == 1, above_3_8 = n > 24, above_1 = n > 64;
    if (odd && n > 56) continue;
    if (above_1 && n % 4 != 0) continue;
    out.push_back({diameter, !odd ? 1.0 : above_3_8 ? 0.25 : 0.5, 0.0});
  }
  for (int half = 2; half <= 100; ++half) out.push_back({0.5 * half, 0.1, 0.0});
  return out;
}

std::vector<Size> roller_sizes() {
  std::vector<Size> out;
  for (int half = 4; half <= 200; ++half) out.push_back({0.5 * half, 1.0, 0.25});
  return out;
}

/// Spread of a maker's rating against the formulas.
struct Convention {
  const char* name;
  double weight, C, C_spread, ratio, ratio_spread;  ///< ratio: C0/C over that of the formulas
  double groove;
};
constexpr Convention kBallConventions[] = {
    {"ISO 281, grooves 0.52", 0.75, 1.015, 0.035, 1.02, 0.02, 0.52},
    {"ISO 281, open grooves 0.55", 0.10, 0.706, 0.03, 0.727, 0.02, 0.55},
    {"C0 by an older rule", 0.15, 1.02, 0.02, 1.25, 0.04, 0.52},
};
constexpr Convention kRollerConventions[] = {{"ISO 281", 1.0, 1.0, 0.08, 1.0, 0.03, 0.0}};

double gauss(double z) { return std::exp(-0.5 * z * z); }
/// Long tails: conventions of makers.
double student(double z) { return std::pow(1.0 + z * z / 4.0, -2.5); }

/// Usual proportions of a type of roller bearings: shares of section, width and circle
/// [estimated].
struct RollerHabit {
  double section, section_spread, width, width_spread, fill, fill_spread, rating_factor;
};
constexpr RollerHabit kCylindrical{0.27, 0.025, 0.60, 0.07, 0.81, 0.06, 1.1};
constexpr RollerHabit kTapered{0.25, 0.03, 0.75, 0.08, 0.90, 0.05, 1.1};
constexpr RollerHabit kSpherical{0.27, 0.025, 0.40, 0.04, 0.86, 0.05, 1.15};

const RollerHabit& habit_of(deck::BearingType type) {
  return type == deck::BearingType::Tapered     ? kTapered
         : type == deck::BearingType::Spherical ? kSpherical
                                                : kCylindrical;
}

bool is_ball(deck::BearingType type) {
  return type == deck::BearingType::DeepGroove || type == deck::BearingType::AngularContact;
}

class Search {
 public:
  Search(const BearingFacts& facts, const deck::CatalogueBearing& bearing, bool spin_is_double)
      : facts_(facts),
        ball_(is_ball(bearing.type)),
        deep_(bearing.type == deck::BearingType::DeepGroove),
        full_(facts.cage == "full complement"),
        habit_(habit_of(bearing.type)),
        angle_(bearing.angle),
        cosine_(std::cos(angle_ * kDegree)),
        bore_(bearing.envelope.bore / kMm),
        outside_(bearing.envelope.outside / kMm),
        width_(bearing.envelope.width / kMm),
        mean_(0.5 * (bore_ + outside_) *
              (bearing.type == deck::BearingType::Spherical ? 1.004 : 1.0)),
        BSF_(facts.BSF ? *facts.BSF * (spin_is_double ? 0.5 : 1.0) : 0.0),
        rows_(facts.rows.value_or(bearing.type == deck::BearingType::Spherical ? 2 : 1)) {}

  /// Those of the facts of the mask, not normalized.
  [[nodiscard]] std::vector<BearingCandidate> find(unsigned mask) const {
    std::vector<BearingCandidate> out;
    const auto has = [&](Fact fact, const auto& value) { return (mask & fact) != 0 && value; };
    std::vector<Size> sizes;
    if (has(kDiameter, facts_.element_diameter))
      sizes.push_back({*facts_.element_diameter / kMm, 1.0, 0.0});
    else
      sizes = ball_ ? ball_sizes() : roller_sizes();
    const int count = has(kCount, facts_.count) ? *facts_.count : count_of_factors(mask);
    constexpr int kMinCount = 4, kMaxCount = 120;
    const int from = count > 0 ? count : kMinCount, to = count > 0 ? count : kMaxCount;
    for (const Size& size : sizes)
      for (int Z = from; Z <= to; ++Z) try_geometry(mask, size, Z, out);
    return out;
  }

 private:
  /// BPFO + BPFI, BPFO/FTF; 0: not fixed.
  [[nodiscard]] int count_of_factors(unsigned mask) const {
    if ((mask & kBPFO) != 0 && (mask & kBPFI) != 0 && facts_.BPFO && facts_.BPFI)
      return static_cast<int>(std::lround(*facts_.BPFO + *facts_.BPFI));
    return 0;
  }
  /// γ of the factors; 0: none of them is known.
  [[nodiscard]] double ratio_of_factors(unsigned mask, int Z) const {
    const bool o = (mask & kBPFO) != 0 && facts_.BPFO, i = (mask & kBPFI) != 0 && facts_.BPFI;
    if (o && i) return (*facts_.BPFI - *facts_.BPFO) / (*facts_.BPFI + *facts_.BPFO);
    if (o) return 1.0 - 2.0 * *facts_.BPFO / Z;
    if (i) return 2.0 * *facts_.BPFI / Z - 1.0;
    if ((mask & kBSF) != 0 && facts_.BSF)  // γ² + 2 b γ / cos α = 1
      return std::sqrt(BSF_ * BSF_ / (cosine_ * cosine_) + 1.0) - BSF_ / cosine_;
    if ((mask & kFTF) != 0 && facts_.FTF) return 1.0 - 2.0 * *facts_.FTF;
    return 0.0;
  }
  [[nodiscard]] bool has_factors(unsigned mask) const {
    return ((mask & kBPFO) != 0 && facts_.BPFO) || ((mask & kBPFI) != 0 && facts_.BPFI) ||
           ((mask & kFTF) != 0 && facts_.FTF) || ((mask & kBSF) != 0 && facts_.BSF);
  }

  void try_geometry(unsigned mask, const Size& size, int Z,
                    std::vector<BearingCandidate>& out) const {
    const double D = size.diameter;
    BearingCandidate one;
    one.count = Z;
    one.rows = rows_;
    one.angle = angle_;
    double weight = size.weight;
    const double gamma_given = ratio_of_factors(mask, Z);
    if (has_factors(mask) && !(gamma_given > 0.0 && gamma_given < kMaxRatio)) return;
    const bool pitch_given = (mask & kPitch) != 0 && facts_.pitch_diameter;
    double pitch = pitch_given         ? *facts_.pitch_diameter / kMm
                   : gamma_given > 0.0 ? D * cosine_ / gamma_given
                                       : mean_;
    if (!(pitch > 1.2 * D)) return;
    const double size_error = 0.5 * size.spread / D;
    if (pitch_given && gamma_given > 0.0) {
      const double z = std::log(D * cosine_ / pitch / gamma_given) / (kFactorSpread + size_error);
      if (std::abs(z) > kLimit) return;
      weight *= gauss(z);
    }
    if (mean_ > 0.0) {
      const double off = pitch / mean_ - 1.0;
      constexpr double kGivenPitchLimit = 0.1;
      if (std::abs(off) > (pitch_given ? kGivenPitchLimit : kPitchLimit) +
                              (gamma_given > 0.0 ? 2.0 * size_error : 0.0))
        return;
      if (!pitch_given) weight *= gauss(off / (kPitchSpread + size_error));
      if (0.5 * (outside_ - pitch) <= 0.5 * D || 0.5 * (pitch - bore_) <= 0.5 * D) return;
    }
    const double gamma = D * cosine_ / pitch;
    one.BPFO = 0.5 * Z * (1.0 - gamma);
    one.BPFI = 0.5 * Z * (1.0 + gamma);
    one.FTF = 0.5 * (1.0 - gamma);
    one.BSF = 0.5 * pitch / D * (1.0 - gamma * gamma);
    const auto agrees = [&](Fact fact, const std::optional<double>& given, double value,
                            double factor = 1.0) {
      if ((mask & fact) == 0 || !given) return true;
      // A factor with three digits is rounded by up to 0.0005.
      const double spread = kFactorSpread + 0.0005 / *given + size_error;
      const double z = std::log(*given * factor / value) / spread;
      weight *= gauss(z);
      return std::abs(z) <= kLimit;
    };
    if (!agrees(kBPFO, facts_.BPFO, one.BPFO) || !agrees(kBPFI, facts_.BPFI, one.BPFI) ||
        !agrees(kFTF, facts_.FTF, one.FTF) ||
        !agrees(kBSF, facts_.BSF, one.BSF, facts_.BSF ? BSF_ / *facts_.BSF : 1.0))
      return;
    const bool fixed_count = ((mask & kCount) != 0 && facts_.count) || count_of_factors(mask) > 0;
    if (!fits(mask, D, Z, pitch, fixed_count, weight)) return;
    one.diameter = D * kMm;
    one.diameter_spread = size.spread * kMm;
    one.pitch = pitch * kMm;
    one.factor_spread =
        gamma_given > 0.0 || pitch_given ? 0.0 : kPitchSpread * gamma / (1.0 - gamma);
    if (ball_)
      rate_balls(mask, weight, one, out);
    else
      rate_rollers(mask, weight, one, out);
  }

  /// Filling and width.
  [[nodiscard]] bool fits(unsigned mask, double D, int Z, double pitch, bool fixed_count,
                          double& weight) const {
    const double half = std::asin(D / pitch), fill = Z * half / std::numbers::pi;
    constexpr double kTouching = 1.0, kFullest = 0.97;
    if (fill > (full_ ? kTouching : kFullest)) return false;
    const bool width_known = (mask & kWidth) != 0 && width_ > 0.0;
    if (ball_) {
      constexpr double kMaxShareOfWidth = 0.8;
      if (width_known && D > kMaxShareOfWidth * width_) return false;
      if (full_) return fill > 0.9;
      if (deep_) {
        const double degrees = 2.0 * (Z - 1) * half / kDegree;
        if (degrees < 150.0 || degrees > 200.0) {  // filling slot, or fewer balls than fit
          if (!fixed_count) return false;
          weight *= 0.02;
        } else {
          weight *= gauss((degrees - 189.0) / 6.0);
        }
      } else {
        if (fill < 0.4 && !fixed_count) return false;
        weight *= gauss((fill - 0.455 - 0.142 * std::log(D)) / 0.055);
      }
      return true;
    }
    const double z = full_ ? (fill - 0.99) / 0.02 : (fill - habit_.fill) / habit_.fill_spread;
    weight *= gauss(z);
    return std::abs(z) <= kLimit;
  }

  [[nodiscard]] double section() const { return outside_ - bore_; }

  void rate_balls(unsigned mask, double weight, BearingCandidate& one,
                  std::vector<BearingCandidate>& out) const {
    const bool has_C = (mask & kC) != 0 && facts_.C, has_C0 = (mask & kC0) != 0 && facts_.C0;
    life::IsoGeometry iso;
    iso.element_diameter = one.diameter / kMm;
    iso.pitch_diameter = one.pitch / kMm;
    iso.count = one.count;
    iso.rows = one.rows;
    iso.contact_angle = angle_ * kDegree;
    const double C = life::iso_dynamic_rating(iso), C0 = life::iso_static_rating(iso).value();
    double best = 0.0;
    for (const Convention& how : kBallConventions) {
      if (!has_C && !has_C0 && &how != &kBallConventions[0]) break;
      double likely = how.weight;
      const auto fact = [&](double value, double spread) {
        const double z = std::log(value) / spread;
        likely *= std::abs(z) > kLimit ? 0.0 : student(z) / spread;
      };
      if (has_C) fact(*facts_.C / (how.C * C), how.C_spread);
      if (has_C && has_C0)
        fact(*facts_.C0 / C0 / (*facts_.C / C) / how.ratio, how.ratio_spread);
      else if (has_C0)
        fact(*facts_.C0 / (how.C * how.ratio * C0), how.C_spread + how.ratio_spread);
      if (section() > 0.0) {
        const bool open = how.groove > 0.54;
        const double share = one.diameter / kMm / section();
        const double centre = open ? 0.22 : deep_ ? 0.30 : 0.295, spread = open ? 0.03 : 0.018;
        const double z = (share - centre) / spread;
        if (share < 0.15 || share > 0.38) likely = 0.0;
        likely *= gauss(z) / spread;
      }
      if (likely <= best) continue;
      best = likely;
      one.convention = has_C || has_C0 ? how.name : "none given";
      one.groove = how.groove;
    }
    if (best <= 0.0) return;
    iso.conformity_inner = iso.conformity_outer = one.groove;
    one.C = life::iso_dynamic_rating(iso);
    one.C0 = C0;
    one.weight = weight * best;
    out.push_back(one);
  }

  void rate_rollers(unsigned mask, double weight, BearingCandidate& one,
                    std::vector<BearingCandidate>& out) const {
    const bool has_C = (mask & kC) != 0 && facts_.C, has_C0 = (mask & kC0) != 0 && facts_.C0;
    const bool has_L = (mask & kLength) != 0 && facts_.element_length;
    life::IsoGeometry iso;
    iso.type = life::IsoType::RadialRoller;
    iso.element_diameter = one.diameter / kMm;
    iso.pitch_diameter = one.pitch / kMm;
    iso.count = one.count;
    iso.rows = one.rows;
    iso.contact_angle = angle_ * kDegree;
    iso.rating_factor = habit_.rating_factor;
    iso.length = 1.0;
    const double C1 = life::iso_dynamic_rating(iso), C01 = life::iso_static_rating(iso).value();
    const Convention& how = kRollerConventions[0];
    double L = 0.0;
    if (has_L)
      L = *facts_.element_length / kMm;
    else if (has_C0)
      L = *facts_.C0 / C01;
    else if (has_C)
      L = std::pow(*facts_.C / C1, 9.0 / 7.0);
    else if (width_ > 0.0)
      L = habit_.width * width_;
    else
      return;
    iso.length = L;
    one.C = life::iso_dynamic_rating(iso);
    one.C0 = life::iso_static_rating(iso).value();
    const auto fact = [&](double value, double centre, double spread) {
      const double z = (value - centre) / spread;
      weight *= std::abs(z) > kLimit ? 0.0 : gauss(z);
    };
    if (has_C) fact(std::log(*facts_.C / one.C), 0.0, how.C_spread);
    // Effective lengths are shorter than printed ones by the corners.
    if (has_L && has_C0) fact(std::log(*facts_.C0 / one.C0), -0.03, 0.04);
    if ((mask & kWidth) != 0 && width_ > 0.0) fact(L / width_, habit_.width, habit_.width_spread);
    if (section() > 0.0)
      fact(one.diameter / kMm / section(), habit_.section, habit_.section_spread);
    const double slenderness = L / (one.diameter / kMm);
    if (slenderness < 0.6 || slenderness > 4.0) return;
    if (weight <= 0.0) return;
    one.length = L * kMm;
    one.convention = has_C || has_C0 ? how.name : "none given";
    one.weight = weight;
    out.push_back(one);
  }

  const BearingFacts& facts_;
  bool ball_, deep_, full_;
  const RollerHabit& habit_;
  double angle_, cosine_, bore_, outside_, width_, mean_, BSF_;
  int rows_;
};

struct NamedFact {
  Fact fact;
  std::string text;
};

std::vector<NamedFact> named_facts(const BearingFacts& f) {
  std::vector<NamedFact> out;
  const auto add = [&](Fact fact, const char* name, const std::optional<double>& value,
                       double factor, const char* unit) {
    if (value) out.push_back({fact, fmt::format("{} = {:.4g}{}", name, *value * factor, unit)});
  };
  add(kC, "C", f.C, 1e-3, " kN");
  add(kC0, "C0", f.C0, 1e-3, " kN");
  add(kBPFO, "BPFO", f.BPFO, 1.0, "");
  add(kBPFI, "BPFI", f.BPFI, 1.0, "");
  add(kFTF, "FTF", f.FTF, 1.0, "");
  add(kBSF, "BSF", f.BSF, 1.0, "");
  if (f.count) out.push_back({kCount, fmt::format("count = {}", *f.count)});
  add(kDiameter, "element_diameter", f.element_diameter, 1e3, " mm");
  add(kLength, "element_length", f.element_length, 1e3, " mm");
  add(kPitch, "pitch_diameter", f.pitch_diameter, 1e3, " mm");
  return out;
}

constexpr const char* kBoundary = "the boundary dimensions and the type";

/// Pairs of facts that no geometry satisfies; when no pair is to blame, each fact without which
/// there is a geometry.
std::vector<Contradiction> contradictions_of(const Search& search,
                                             const std::vector<NamedFact>& facts) {
  std::vector<Contradiction> out;
  std::vector<bool> alone(facts.size(), false);
  for (std::size_t a = 0; a < facts.size(); ++a) {
    alone[a] = search.find(facts[a].fact | kWidth).empty();
    if (alone[a]) out.push_back({facts[a].text, kBoundary});
  }
  for (std::size_t a = 0; a < facts.size(); ++a)
    for (std::size_t b = a + 1; b < facts.size(); ++b)
      if (!alone[a] && !alone[b] && search.find(facts[a].fact | facts[b].fact | kWidth).empty())
        out.push_back({facts[a].text, facts[b].text});
  if (!out.empty()) return out;
  unsigned all = kWidth;
  for (const NamedFact& one : facts) all |= one.fact;
  for (const NamedFact& one : facts)
    if (!search.find(all & ~static_cast<unsigned>(one.fact)).empty())
      out.push_back({one.text, "all other facts together"});
  if (out.empty())
    out.push_back({"the set of all facts",
                   "any bearing geometry, although each pair of facts agrees with a geometry"});
  return out;
}

/// Geometries of the same count whose sizes differ by less than 1.3 % are one with a spread.
void merge(std::vector<BearingCandidate>& all) {
  std::stable_sort(
      all.begin(), all.end(),
      [](const BearingCandidate& a, const BearingCandidate& b) { return a.weight > b.weight; });
  std::vector<BearingCandidate> out;
  for (const BearingCandidate& one : all) {
    constexpr double kSame = 0.013;
    const auto like = std::find_if(out.begin(), out.end(), [&](const BearingCandidate& kept) {
      return kept.count == one.count && kept.convention == one.convention &&
             std::abs(one.diameter / kept.diameter - 1.0) < kSame;
    });
    if (like == out.end()) {
      out.push_back(one);
      continue;
    }
    like->diameter_spread =
        std::max(like->diameter_spread, std::abs(one.diameter - like->diameter));
  }
  all = std::move(out);
}

/// The property in which the listed candidates differ most clearly.
std::string decisive_fact(const std::vector<BearingCandidate>& c) {
  if (c.size() < 2) return "";
  struct Property {
    const char* name;
    double precision;  ///< relative, of a usual measurement or print
    double (*value)(const BearingCandidate&);
    const char* unit;
    double factor;
  };
  constexpr Property kProperties[] = {
      {"The number of elements (count)", 1e-6,
       [](const BearingCandidate& one) { return static_cast<double>(one.count); }, "", 1.0},
      {"The BPFO factor (outer ring defect frequency divided by shaft frequency)", 0.003,
       [](const BearingCandidate& one) { return one.BPFO; }, "", 1.0},
      {"The element diameter", 0.003, [](const BearingCandidate& one) { return one.diameter; },
       " mm", 1e3},
      {"The spin factor (BSF)", 0.004, [](const BearingCandidate& one) { return one.BSF; }, "",
       1.0},
      {"The element length", 0.02, [](const BearingCandidate& one) { return one.length; }, " mm",
       1e3},
  };
  const Property* best = nullptr;
  std::size_t most = 0;
  for (const Property& p : kProperties) {
    std::size_t told = 0;  // candidates that differ from the first by three precisions
    for (std::size_t n = 1; n < c.size(); ++n) {
      const double first = p.value(c[0]);
      if (first > 0.0 && std::abs(p.value(c[n]) / first - 1.0) > 3.0 * p.precision) ++told;
    }
    if (told > most) {
      most = told;
      best = &p;
    }
  }
  if (best == nullptr) return "No single additional property would distinguish these candidates.";
  std::string values;
  for (std::size_t n = 0; n < c.size(); ++n)
    values += fmt::format("{}{:.4g}{} ({})", n == 0 ? "" : ", ", best->value(c[n]) * best->factor,
                          best->unit, n + 1);
  return fmt::format("{} would {}: {}.", best->name,
                     most + 1 == c.size() ? "separate candidate 1 from all others"
                                          : "separate candidate 1 from most others",
                     values);
}

/// Type, boundary dimensions, angle and clearance of designation and facts.
deck::CatalogueBearing bearing_of(const BearingFacts& f, std::vector<Contradiction>& wrong,
                                  std::vector<std::string>& missing) {
  deck::CatalogueBearing out;
  const bool named = !f.designation.empty();
  if (named)
    out = deck::find_bearing(f.designation);
  else
    out.designation = "bearing of facts";
  if (!f.type.empty()) {
    const deck::BearingType type = deck::parse_bearing_type(f.type);
    if (named && type != out.type)
      wrong.push_back(
          {fmt::format("designation = {}", f.designation), fmt::format("type = {}", f.type)});
    out.type = type;
  } else if (!named) {
    missing.emplace_back("designation or type");
  }
  const auto length = [&](const char* name, const std::optional<double>& given, double& value) {
    if (!given) return;
    constexpr double kSame = 1e-3;  // relative: printed in inches or millimeters
    if (named && std::abs(*given / value - 1.0) > kSame)
      wrong.push_back(
          {fmt::format("designation = {} ({} {:.4g} mm)", f.designation, name, value / kMm),
           fmt::format("{} = {:.4g} mm", name, *given / kMm)});
    value = *given;
  };
  length("bore", f.bore, out.envelope.bore);
  length("outside", f.outside, out.envelope.outside);
  const double width = out.envelope.width;
  length("width", f.width, out.envelope.width);
  if (!named || out.envelope.cup_width == width) out.envelope.cup_width = out.envelope.width;
  if (f.contact_angle) {
    if (*f.contact_angle >= 90.0) throw InputError("contact_angle: give 0 to 90 degrees");
    if (out.angle_given && std::abs(*f.contact_angle - out.angle) > 1.0)
      wrong.push_back({fmt::format("designation = {} ({:.4g} deg)", f.designation, out.angle),
                       fmt::format("contact_angle = {:.4g} deg", *f.contact_angle)});
    out.angle = *f.contact_angle;
    out.angle_given = true;
  } else if (!named && out.envelope.outside > out.envelope.bore) {
    out.angle = deck::default_contact_angle(out.type, out.envelope);
  }
  if (!f.clearance.empty()) {
    out.clearance = f.clearance;
    // Checks that the type has the group.
    if (out.envelope.bore > 0.0)
      (void)deck::propose_internal_geometry(out.type, out.envelope, out.angle, out.clearance,
                                            out.tapered_bore);
  }
  if (out.envelope.bore > 0.0 && out.envelope.outside > 0.0 &&
      !(out.envelope.outside > 1.05 * out.envelope.bore))
    wrong.push_back({fmt::format("bore = {:.4g} mm", out.envelope.bore / kMm),
                     fmt::format("outside = {:.4g} mm", out.envelope.outside / kMm)});
  const bool size = out.envelope.bore > 0.0 && out.envelope.outside > 0.0;
  if (!size) {
    if (out.envelope.bore <= 0.0) missing.emplace_back("bore");
    if (out.envelope.outside <= 0.0) missing.emplace_back("outside");
  }
  if (out.envelope.width <= 0.0) missing.emplace_back("width");
  return out;
}

/// Facts that bound, but do not rank: Cu, mass, limiting speed.
void check_bounds(const BearingFacts& f, const deck::CatalogueBearing& b,
                  std::vector<Contradiction>& wrong, std::vector<std::string>& fact_use) {
  const deck::Envelope& e = b.envelope;
  if (f.C && f.C0 && (*f.C0 / *f.C > 3.0 || *f.C0 / *f.C < 0.25))
    wrong.push_back(
        {fmt::format("C = {:.4g} kN", *f.C / 1e3), fmt::format("C0 = {:.4g} kN", *f.C0 / 1e3)});
  if (f.Cu && f.C0) {
    const double ratio = *f.C0 / *f.Cu;
    const double low = is_ball(b.type) ? 12.0 : 5.0, high = is_ball(b.type) ? 40.0 : 16.0;
    if (ratio < low || ratio > high)
      wrong.push_back(
          {fmt::format("Cu = {:.4g} kN", *f.Cu / 1e3),
           fmt::format("C0 = {:.4g} kN (the ratio C0/Cu of this bearing type is {:g} to {:g})",
                       *f.C0 / 1e3, low, high)});
  }
  if (f.Cu)
    fact_use.emplace_back(
        "Cu is only compared with C0; it does not change the ranking of the candidates.");
  if (f.mass && e.outside > e.bore && e.width > 0.0) {
    constexpr double kSteel = 7800.0;
    const double solid =
        kSteel * 0.25 * std::numbers::pi * e.width * (e.outside * e.outside - e.bore * e.bore);
    if (*f.mass < 0.3 * solid || *f.mass > 1.0 * solid)
      wrong.push_back({fmt::format("mass = {:.4g} kg", *f.mass),
                       fmt::format("{} (a solid steel ring has {:.3g} kg)", kBoundary, solid)});
  }
  if (f.mass)
    fact_use.emplace_back(
        "The mass is only compared with the boundary dimensions; it does not change the ranking of "
        "the candidates.");
  if (f.limiting_speed && e.outside > e.bore) {
    const double factor = *f.limiting_speed * 0.5 * (e.bore + e.outside) / kMm;  // n dm [mm/min]
    if (factor < 2e4 || factor > 4e6)
      wrong.push_back({fmt::format("limiting_speed = {:.4g} rpm", *f.limiting_speed), kBoundary});
  }
  if (f.limiting_speed)
    fact_use.emplace_back(
        "The limiting speed is only compared with the size of the bearing; it does not change the "
        "ranking of the candidates.");
  if (!f.cage.empty() && f.cage != "full complement")
    fact_use.push_back(fmt::format(
        "cage = {} has no effect on the candidates. Only \"full complement\" has an effect.",
        f.cage));
  if (f.rows.value_or(1) > 1)
    fact_use.push_back(fmt::format(
        "The ratings apply to all {} rows together. The deck describes one row: enter the "
        "load of one row.",
        *f.rows));
  if (!b.left_out.empty())
    fact_use.push_back(fmt::format("Unused part of the designation: {}.", b.left_out));
}

}  // namespace

CandidateReport find_candidates(const BearingFacts& facts) {
  CandidateReport out;
  out.facts = facts;
  out.bearing = bearing_of(facts, out.contradictions, out.missing);
  check_bounds(facts, out.bearing, out.contradictions, out.fact_use);
  if (!out.missing.empty() || !out.contradictions.empty()) return out;
  Search search(facts, out.bearing, false);
  std::vector<BearingCandidate> all = search.find(kAllFacts);
  if (all.empty() && facts.BSF) {  // some lists print twice the spin
    const Search twice(facts, out.bearing, true);
    all = twice.find(kAllFacts);
    if (!all.empty())
      out.fact_use.emplace_back(
          "BSF is assumed to be twice the spin frequency of an element, because a defect of the "
          "element strikes both races.");
  }
  if (all.empty()) {
    out.contradictions = contradictions_of(search, named_facts(facts));
    return out;
  }
  merge(all);
  const double least = kWeightLimit * all.front().weight;
  std::size_t kept = 0;
  while (kept < all.size() && kept < kMaxListed && all[kept].weight >= least) ++kept;
  out.left_out = static_cast<int>(all.size() - kept);
  all.resize(kept);
  double sum = 0.0;
  for (const BearingCandidate& one : all) sum += one.weight;
  for (BearingCandidate& one : all) one.weight /= sum;
  out.candidates = std::move(all);
  out.decisive = decisive_fact(out.candidates);
  if (!facts.C && !facts.C0 && !facts.BPFO && !facts.BPFI && !facts.count &&
      !facts.element_diameter)
    out.fact_use.emplace_back(
        "Only the boundary dimensions are known, so the candidates are typical designs of this "
        "bearing type. To select among them, add C and C0, or BPFO.");
  return out;
}

deck::CatalogueBearing candidate_bearing(const CandidateReport& report, int number) {
  const auto count = static_cast<int>(report.candidates.size());
  if (number < 1 || number > count)
    throw InputError(count == 0
                         ? candidates_text(report)
                         : fmt::format("candidate {} does not exist; give a number from 1 to {}",
                                       number, count));
  const BearingCandidate& one = report.candidates[static_cast<std::size_t>(number - 1)];
  deck::CatalogueBearing out = report.bearing;
  out.angle = one.angle;
  out.known.count = one.count;
  out.known.diameter = one.diameter;
  out.known.length = one.length;
  out.known.pitch = one.pitch;
  out.known.groove_outer = out.known.groove_inner = one.groove;
  out.known.source =
      fmt::format("candidate {} of {} from published facts{}", number, count,
                  report.facts.source.empty() ? "" : " (" + report.facts.source + ")");
  return out;
}

}  // namespace adore::design
