#include "validation/catalogue_torque.hpp"

#include "base/errors.hpp"
#include "base/json_members.hpp"
#include "base/json_text.hpp"
#include "base/resources.hpp"
#include "deck/catalogue.hpp"
#include "deck/templates.hpp"
#include "runs/prepare.hpp"
#include "validation/experiment_data.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace adore::validation {
namespace {

constexpr const char* kFile = "skf-torque.json";
constexpr double kMillimetre = 1e-3, kKilonewton = 1e3;

struct CatalogueBearing {
  std::string name, deck, catalogue, certainty;
  double d = 0.0, D = 0.0;                             // mm
  std::array<double, 5> R{}, S{};                      // from 1
  double Y = 0.0, Kz = 0.0, film = 0.0;                // of the size; φrs; μ of a full film
  double C = 0.0, C0 = 0.0;                            // N
  double limiting_speed = 0.0, reference_speed = 0.0;  // rpm
  double kr = 0.0, ka = 0.0, minimum_share = 0.0;      // of the minimum load
  double radial_per_P = 1.0, axial_per_P = 0.0, rows = 1.0;
  const struct Form* form = nullptr;
  [[nodiscard]] double dm() const noexcept { return 0.5 * (d + D); }
};

/// One point of the formula.
struct Point {
  double n = 0.0, nu = 0.0, radial = 0.0, axial = 0.0;  // rpm, mm²/s, N
};

struct Form {
  std::string_view name;
  std::string_view needs;  ///< constants of the schema
  double (*Grr)(const CatalogueBearing&, const Point&);
  double (*Gsl)(const CatalogueBearing&, const Point&);
  double (*minimum)(const CatalogueBearing&, const Point&);  ///< load [N], of the kind that acts
};

constexpr Form kForms[] = {
    {"deep_groove", "R1 S1 kr",
     [](const CatalogueBearing& b, const Point& p) {
       return b.R[1] * std::pow(b.dm(), 1.96) * std::pow(p.radial, 0.54);
     },
     [](const CatalogueBearing& b, const Point& p) {
       return b.S[1] * std::pow(b.dm(), -0.26) * std::pow(p.radial, 5.0 / 3.0);
     },
     [](const CatalogueBearing& b, const Point& p) {
       const double size = b.dm() / 100.0;
       return kKilonewton * b.kr * std::pow(p.nu * p.n / 1000.0, 2.0 / 3.0) * size * size;
     }},
    {"angular_contact", "R1 R2 R3 S1 S2 S3 ka",
     [](const CatalogueBearing& b, const Point& p) {
       const double Fg = b.R[3] * std::pow(b.dm(), 4.0) * p.n * p.n;
       return b.R[1] * std::pow(b.dm(), 1.97) * std::pow(p.radial + Fg + b.R[2] * p.axial, 0.54);
     },
     [](const CatalogueBearing& b, const Point& p) {
       const double Fg = b.S[3] * std::pow(b.dm(), 4.0) * p.n * p.n;
       return b.S[1] * std::pow(b.dm(), 0.26) *
              (std::pow(p.radial + Fg, 4.0 / 3.0) + b.S[2] * std::pow(p.axial, 4.0 / 3.0));
     },
     [](const CatalogueBearing& b, const Point& p) {
       const double speed = p.n * b.dm() / 1e5;
       return kKilonewton * b.ka * b.C0 / kKilonewton * speed * speed;
     }},
    {"cylindrical", "R1 S2 kr reference_speed",
     [](const CatalogueBearing& b, const Point& p) {
       return b.R[1] * std::pow(b.dm(), 2.41) * std::pow(p.radial, 0.31);
     },
     [](const CatalogueBearing& b, const Point& p) { return b.S[2] * b.dm() * p.radial; },
     [](const CatalogueBearing& b, const Point& p) {
       const double size = b.dm() / 100.0;
       return kKilonewton * b.kr * (6.0 + 4.0 * p.n / b.reference_speed) * size * size;
     }},
    {"tapered", "R1 R2 S1 S2 Y minimum_share",
     [](const CatalogueBearing& b, const Point& p) {
       return b.R[1] * std::pow(b.dm(), 2.38) * std::pow(p.radial + b.R[2] * b.Y * p.axial, 0.31);
     },
     [](const CatalogueBearing& b, const Point& p) {
       return b.S[1] * std::pow(b.dm(), 0.82) * (p.radial + b.S[2] * b.Y * p.axial);
     },
     [](const CatalogueBearing& b, const Point&) { return b.minimum_share * b.C; }},
    {"spherical", "R1 R2 R3 R4 S1 S2 S3 S4 minimum_share",
     [](const CatalogueBearing& b, const Point& p) {
       return std::min(
           b.R[1] * std::pow(b.dm(), 1.85) * std::pow(p.radial + b.R[2] * p.axial, 0.54),
           b.R[3] * std::pow(b.dm(), 2.3) * std::pow(p.radial + b.R[4] * p.axial, 0.31));
     },
     [](const CatalogueBearing& b, const Point& p) {
       return std::min(b.S[1] * std::pow(b.dm(), 0.25) *
                           std::cbrt(std::pow(p.radial, 4.0) + b.S[2] * std::pow(p.axial, 4.0)),
                       b.S[3] * std::pow(b.dm(), 0.94) *
                           std::cbrt(std::pow(p.radial, 3.0) + b.S[4] * std::pow(p.axial, 3.0)));
     },
     [](const CatalogueBearing& b, const Point&) { return b.minimum_share * b.C0; }},
};

struct Oil {
  std::string name;
  double nu40 = 0.0, nu100 = 0.0;     // mm²/s
  double density = 0.0, alpha = 0.0;  // at the temperature of the table
  double nu = 0.0, slope = 0.0;       // there [mm²/s]; d ln ν/d(1/T) [K]
};

struct Tables {
  double temperature = 0.0;
  std::vector<double> speeds, load_ratios;
  std::vector<Oil> oils;
  std::vector<CatalogueBearing> bearings;
};

CatalogueBearing read_bearing(JsonMembers& in) {
  CatalogueBearing out;
  out.name = in.text("name");
  in.set_where(fmt::format("{}, {}", kFile, out.name));
  out.deck = in.text("deck", "");
  out.catalogue = in.text("catalogue", "");
  if (out.deck.empty() == out.catalogue.empty()) in.reject("give either deck or catalogue");
  out.certainty = in.text("certainty");
  check_certainty(out.certainty, in.where());
  const std::string form = in.text("form");
  for (const Form& one : kForms)
    if (one.name == form) out.form = &one;
  if (out.form == nullptr) in.reject(fmt::format("form = \"{}\": unknown", form));
  // Constants of the form are required; others are unknown members.
  const auto constant = [&](const std::string& name) {
    const std::string padded = " " + std::string(out.form->needs) + " ";
    return padded.find(" " + name + " ") != std::string::npos ? in.number(name) : 0.0;
  };
  for (std::size_t n = 1; n < out.R.size(); ++n) {
    out.R[n] = constant("R" + std::to_string(n));
    out.S[n] = constant("S" + std::to_string(n));
  }
  out.Y = constant("Y");
  out.kr = constant("kr");
  out.ka = constant("ka");
  out.minimum_share = constant("minimum_share");
  out.reference_speed = constant("reference_speed");
  out.d = in.number("d");
  out.D = in.number("D");
  out.Kz = in.number("Kz");
  out.film = in.number("film");
  out.C = in.number("C");
  out.C0 = in.number("C0");
  out.limiting_speed = in.number("limiting_speed");
  out.radial_per_P = in.number("radial_per_P", 1.0);
  out.axial_per_P = in.number("axial_per_P", 0.0);
  out.rows = in.number("rows", 1.0);
  in.finish();
  return out;
}

/// lg lg(ν + 0.7) = A - B lg T
Oil read_oil(JsonMembers& in, double temperature) {
  Oil out;
  out.name = in.text("name");
  out.nu40 = in.number("nu40");
  out.nu100 = in.number("nu100");
  out.density = in.number("density");
  out.alpha = in.number("alpha");
  check_certainty(in.text("certainty"), in.where());
  in.finish();
  const auto twice = [](double nu) { return std::log10(std::log10(nu + 0.7)); };
  const double T40 = 313.15, T100 = 373.15;
  const double B = (twice(out.nu40) - twice(out.nu100)) / std::log10(T100 / T40);
  const auto nu_at = [&](double T) {
    return std::pow(10.0, std::pow(10.0, twice(out.nu40) - B * std::log10(T / T40))) - 0.7;
  };
  out.nu = nu_at(temperature);
  constexpr double kStep = 0.1;
  out.slope = std::log(nu_at(temperature - kStep) / nu_at(temperature + kStep)) /
              (1.0 / (temperature - kStep) - 1.0 / (temperature + kStep));
  return out;
}

Tables read_tables(std::string_view data) {
  const nlohmann::json all =
      parse_json(data.empty() ? resources::get(std::string("experiments/") + kFile) : data, kFile);
  JsonMembers in(all, kFile);
  (void)in.find("meta");
  Tables out;
  out.temperature = in.number("temperature");
  out.speeds = in.numbers("speeds");
  out.load_ratios = in.numbers("load_ratios");
  for (JsonMembers& one : in.objects("oils", "oil"))
    out.oils.push_back(read_oil(one, out.temperature));
  for (JsonMembers& one : in.objects("bearings", "bearing"))
    out.bearings.push_back(read_bearing(one));
  in.finish();
  return out;
}

void add_catalogue(const CatalogueBearing& b, const Point& p, TorqueLine& line) {
  const double dm = b.dm(), n = p.n, nu = p.nu;
  const double inlet = 1.0 / (1.0 + 1.84e-9 * std::pow(n * dm, 1.28) * std::pow(nu, 0.64));
  const double starved =
      std::exp(-3e-8 * nu * n * (b.d + b.D) * std::sqrt(b.Kz / (2.0 * (b.D - b.d))));
  const double mixed = std::exp(-2.6e-8 * std::pow(n * nu, 1.4) * dm);
  constexpr double kBoundary = 0.15;
  line.catalogue_rolling =
      kMillimetre * inlet * starved * b.form->Grr(b, p) * std::pow(nu * n, 0.6);
  line.catalogue_sliding =
      kMillimetre * b.form->Gsl(b, p) * (mixed * kBoundary + (1.0 - mixed) * b.film);
}

deck::Deck deck_of(const CatalogueBearing& b) {
  if (b.catalogue.empty()) return deck::new_deck(b.deck);
  return deck::read_deck_text(deck::catalogue_deck(deck::find_bearing(b.catalogue)), b.catalogue)
      .deck;
}

void compute(const CatalogueBearing& b, const Oil& oil, double temperature, TorqueLine& line) {
  runs::LoadedDeck input;
  input.path = runs::kStandardInput;
  input.deck = deck_of(b);
  deck::Deck& deck = input.deck;
  deck.set("kTrac", "9");
  deck.set("kTracType", "1");
  if (deck.has("kStif")) deck.set("kStif", "0");
  const bool rib = b.form->name == "tapered" || b.form->name == "cylindrical";
  if (rib) deck.set("kRFTracType", "2");
  deck.complete();
  const auto real = [&](const char* name, double value) {
    deck.set(name, fmt::format("{:.6e}", value));
  };
  constexpr double kSquareMillimetre = 1e-6;
  const double viscosity = kSquareMillimetre * oil.nu * oil.density;
  deck.set("lubName", fmt::format("'{}'", oil.name));
  real("refTemp", temperature);
  real("refVis", viscosity);
  real("prVisCoeff", oil.alpha);
  real("tempVisCoeff", oil.slope);
  real("lubTherCond", 0.14);
  real("lubDen", oil.density);
  real("lubSpHeat", 2000.0);
  real("refTracVis", viscosity);
  real("tracVisCoeff1", oil.alpha);
  real("tracVisCoeff2", oil.slope / (temperature * temperature));
  // Mixed friction below a film of the roughness, 0.15 as in the catalogue.
  real("reRaceTC1", 0.0);
  real("reRaceTC2", 0.15);
  real("reRaceTC3", 0.14);
  real("reRaceTC4", 0.1);
  real("reRaceFilm", 1.5e-7);
  real("strParam", 10.0);
  if (deck.has("reFlngTC1")) {
    real("reFlngTC1", 0.0);
    real("reFlngTC2", 0.05);
    real("reFlngTC3", 0.5);
  }
  for (const char* name : {"hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp", "roomTemp"})
    real(name, temperature);  // cold clearances stay
  real("rpm2", line.rpm);
  real("appLoadZ", line.radial / b.rows);
  real("appLoadX", line.axial / b.rows);
  const runs::Prepared prepared = runs::prepare(std::move(input));
  const statics::FrictionEstimate& f = *prepared.friction;
  const statics::FrictionOfContact outer = f.of_race(0), inner = f.of_race(1);
  const double scale = b.rows / f.speed;
  line.rolling = scale * (outer.rolling + inner.rolling);
  line.sliding = scale * (outer.sliding + inner.sliding);
  line.spin = scale * (outer.spin + inner.spin);
  line.rib = scale * (f.flange[0] + f.flange[1]);
  line.drag = scale * f.drag();
}

TorqueTable table_of(const Tables& tables, const CatalogueBearing& b, const Oil& oil) {
  constexpr double kSquareMillimetre = 1e-6;
  TorqueTable out;
  out.deck = b.deck.empty() ? b.catalogue : b.deck;
  out.bearing = b.name;
  out.oil = oil.name;
  out.viscosity = kSquareMillimetre * oil.nu;
  out.certainty = b.certainty;
  for (const double ratio : tables.load_ratios)
    for (const double rpm : tables.speeds) {
      TorqueLine line;
      line.rpm = rpm;
      line.load_ratio = ratio;
      line.radial = b.radial_per_P * b.C / ratio;
      line.axial = b.axial_per_P * b.C / ratio;
      const Point point{rpm, oil.nu, line.radial, line.axial};
      if (rpm > b.limiting_speed) {
        ++out.above_speed;
        continue;
      }
      if (std::max(line.radial, line.axial) < b.form->minimum(b, point)) {
        ++out.below_load;
        continue;
      }
      add_catalogue(b, point, line);
      try {
        compute(b, oil, tables.temperature, line);
      } catch (const SolverError& error) {
        line.failed = error.what();
      }
      out.lines.push_back(std::move(line));
    }
  return out;
}

}  // namespace

std::vector<TorqueTable> compute_torque_tables(std::string_view data) {
  const Tables tables = read_tables(data);
  std::vector<TorqueTable> out;
  for (const CatalogueBearing& b : tables.bearings)
    for (const Oil& oil : tables.oils) out.push_back(table_of(tables, b, oil));
  return out;
}

namespace {

/// One row; `cell` writes a value in N mm.
std::string torque_row(const TorqueLine& l, const char* form) {
  constexpr double kMilli = 1e3;
  return fmt::format(fmt::runtime(form), l.radial, l.axial, l.rpm, kMilli * l.rolling,
                     kMilli * l.sliding, kMilli * l.spin, kMilli * l.rib, kMilli * l.total(),
                     kMilli * l.catalogue_rolling, kMilli * l.catalogue_sliding,
                     kMilli * l.catalogue(), l.rolling / l.catalogue_rolling,
                     l.total() / l.catalogue());
}

}  // namespace

std::string torque_text(const std::vector<TorqueTable>& tables) {
  std::string out;
  for (const TorqueTable& table : tables) {
    out += fmt::format(
        "\n{} ({}), {} at 70 degrees Celsius, {:.1f} mm2/s, flooded contacts. Torques are in N mm. "
        "Column groups: computed torque, torque of the catalog formula, computed torque / formula "
        "torque. Omitted operating points: {} above the limiting speed, {} below the minimum "
        "load\n",
        table.bearing, table.deck, table.oil, 1e6 * table.viscosity, table.above_speed,
        table.below_load);
    out += fmt::format(
        "{:>7} {:>7} {:>6} | {:>8} {:>8} {:>6} {:>6} {:>8} | {:>8} {:>8} {:>8} | {:>7} "
        "{:>6}\n",
        "Fr [N]", "Fa [N]", "rpm", "rolling", "sliding", "spin", "rib", "computed", "rolling",
        "sliding", "formula", "rolling", "total");
    for (const TorqueLine& line : table.lines)
      out +=
          torque_row(line,
                     "{:>7.0f} {:>7.0f} {:>6.0f} | {:>8.2f} {:>8.2f} {:>6.2f} {:>6.1f} {:>8.2f} | "
                     "{:>8.2f} {:>8.2f} {:>8.2f} | {:>7.2f} {:>6.2f}\n");
  }
  return out;
}

std::string torque_markdown(const std::vector<TorqueTable>& tables) {
  std::string out;
  for (const TorqueTable& table : tables) {
    out += fmt::format(
        "\n## {}, {}\n\nOil viscosity {:.1f} mm²/s at 70 °C, flooded contacts, no medium in the "
        "cavity. Torques are in N mm. The last two columns are the computed torque divided by the "
        "torque of the catalog formula. Omitted operating points: {} above the limiting speed, {} "
        "below the minimum load.\n\n",
        table.bearing, table.oil, 1e6 * table.viscosity, table.above_speed, table.below_load);
    out +=
        "| Fr [N] | Fa [N] | rpm | rolling | sliding | spin | rib | computed | formula: rolling | "
        "sliding | formula | ratio: rolling | ratio: total "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const TorqueLine& line : table.lines)
      out += torque_row(line,
                        "| {:.0f} | {:.0f} | {:.0f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} | {:.2f} | "
                        "{:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n");
  }
  return out;
}

nlohmann::ordered_json torque_json(const std::vector<TorqueTable>& tables) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const TorqueTable& table : tables) {
    nlohmann::ordered_json lines = nlohmann::ordered_json::array();
    for (const TorqueLine& l : table.lines)
      lines.push_back({{"rpm", l.rpm},
                       {"C/P", l.load_ratio},
                       {"radial load [N]", l.radial},
                       {"axial load [N]", l.axial},
                       {"rolling [N.m]", l.rolling},
                       {"sliding [N.m]", l.sliding},
                       {"spin [N.m]", l.spin},
                       {"rib [N.m]", l.rib},
                       {"drag [N.m]", l.drag},
                       {"catalogue rolling [N.m]", l.catalogue_rolling},
                       {"catalogue sliding [N.m]", l.catalogue_sliding},
                       {"failed", l.failed}});
    out.push_back({{"bearing", table.bearing},
                   {"deck", table.deck},
                   {"oil", table.oil},
                   {"above the limiting speed", table.above_speed},
                   {"below the minimum load", table.below_load},
                   {"viscosity [m2/s]", table.viscosity},
                   {"lines", lines}});
  }
  return out;
}

}  // namespace adore::validation
