#include "deck/unit_text.hpp"
#include "listing/print_file.hpp"
#include "listing/print_words.hpp"
#include "listing/rounding.hpp"
#include "statics/stiffness_difference.hpp"

#include <fmt/format.h>

#include <array>

/// Stiffness-speed table of PRINT.txt.
namespace adore::listing {
namespace {

constexpr std::array<const char*, 5> kLoads{"Fx", "Fy", "Fz", "My", "Mz"},
    kMotions{"x", "y", "z", "rot y", "rot z"};

const UnitPair& motion_unit(std::size_t k) { return k < 3 ? unit::kLength : unit::kRadian; }

/// Text of one entry in the deck's units.
std::string entry(const Report& report, const Eigen::Matrix<double, 5, 5>& K, std::size_t i,
                  std::size_t j) {
  const double value = K(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  if (value == 0.0) return fmt::format("{:>15}", 0);
  const double load = from_si(value, load_unit(i), report.units());
  return fmt::format("{:15.7e}", load * to_si(1.0, motion_unit(j), report.units()));
}

std::string titled(const char* name, const UnitPair& unit, UnitSystem units) {
  return fmt::format("{} [{}]", name, unit_name(unit, units));
}

std::vector<std::string> warnings_of(const statics::StiffnessRow& row) {
  return row.operating ? sentences_of(row.operating->warnings) : std::vector<std::string>();
}

void print_row(Report& report, const statics::StiffnessRow& row) {
  report.heading(fmt::format("Outer race {:.7g} rpm, inner race {:.7g} rpm",
                             from_si(row.speed[0], unit::kRotation, report.units()),
                             from_si(row.speed[1], unit::kRotation, report.units())));
  if (!row.failure.empty()) {
    report.text("Stiffness not computed: " + row.failure);
    for (const std::string& warning : warnings_of(row)) report.text("Warning: " + warning);
    return;
  }
  const auto& differences = row.result.stiffness_by_difference;
  std::vector<std::pair<std::string, std::size_t>> columns{{"per", 12}, {"", 13}};
  for (std::size_t j = 0; j < 5; ++j)
    columns.emplace_back(titled(kMotions[j], motion_unit(j), report.units()), 15);
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](std::size_t i, std::string name, const char* how,
                       const Eigen::Matrix<double, 5, 5>& K) {
    rows.push_back({std::move(name), how});
    for (std::size_t j = 0; j < 5; ++j) rows.back().push_back(entry(report, K, i, j));
  };
  const auto exact = zero_rounding_noise(row.result.stiffness);
  for (std::size_t i = 0; i < 5; ++i) {
    add(i, titled(kLoads[i], load_unit(i), report.units()), "exact", exact);
    if (differences) add(i, "", "by difference", zero_rounding_noise(*differences));
  }
  report.text_table(columns, rows);
  report.item("Largest contact load", row.result.max_load, unit::kForce);
  if (differences)
    report.item("Difference of the two methods / largest entry of the same unit",
                statics::stiffness_disagreement(row.result.stiffness, *differences), unit::kPure);
  for (const Finding& note : row.result.notes)
    report.text(deck::message_in_units(note.message, report.units()));
  if (!row.operating) return;
  const bearing::OperatingFits& fits = *row.operating;
  report.item(fits.axial_setting ? "Change of the diametral clearance at this speed"
                                 : "Diametral clearance at this speed",
              fits.operating.clearance, unit::kLength);
  if (fits.locus[0] > 0.0)
    report.item("Free contact angle at this speed", fits.operating.contact_angle, unit::kAngle);
  for (const std::string& warning : warnings_of(row)) report.text("Warning: " + warning);
}

}  // namespace

void print_stiffness_table(Report& report, const std::vector<statics::StiffnessRow>& rows,
                           double share) {
  report.new_page("STIFFNESS OVER SPEED");
  report.text(
      "Rows: load on the inner race. Columns: displacement of the inner race. Each value is the "
      "exact "
      "derivative at constant speed with all rolling elements in equilibrium.");
  if (share > 0.0)
    report.text(fmt::format(
        "Rows \"by difference\": finite differences for displacements of the inner race by +- "
        "{:.4g} % of the largest contact deflection.",
        100.0 * share));
  for (const statics::StiffnessRow& row : rows) print_row(report, row);
}

}  // namespace adore::listing
