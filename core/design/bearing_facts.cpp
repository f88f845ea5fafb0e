#include "design/bearing_facts.hpp"

#include "base/errors.hpp"
#include "base/json_members.hpp"
#include "base/json_text.hpp"
#include "deck/number.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <numbers>
#include <span>

namespace adore::design {
namespace {

struct Unit {
  std::string_view name;
  double factor;  ///< to the unit of BearingFacts
};
constexpr Unit kLengthUnits[] = {{"mm", 1e-3}, {"m", 1.0}, {"um", 1e-6}, {"in", 0.0254}};
constexpr Unit kForceUnits[] = {{"kN", 1e3}, {"N", 1.0}, {"MN", 1e6}, {"lbf", 4.4482216152605}};
constexpr Unit kMass[] = {{"kg", 1.0}, {"g", 1e-3}, {"lb", 0.45359237}};
constexpr Unit kAngleUnits[] = {{"deg", 1.0}, {"rad", 180.0 / std::numbers::pi}};
constexpr Unit kSpeed[] = {{"rpm", 1.0}, {"1/min", 1.0}, {"rad/s", 30.0 / std::numbers::pi}};
constexpr double kLargest = 1e9, kSmallest = 1e-9;  // of any quantity in SI

class Reader {
 public:
  Reader(const nlohmann::json& json, std::string_view name) : in_(json, std::string(name)) {}

  void text(std::string_view name, std::string& out) {
    if (in_.find(name) != nullptr) out = in_.text(name);
  }
  void quantity(std::string_view name, std::span<const Unit> units, std::optional<double>& out) {
    const nlohmann::json* value = in_.find(name);
    if (value == nullptr) return;
    std::string known;
    for (const Unit& unit : units)
      known += fmt::format("{}{}", known.empty() ? "" : ", ", unit.name);
    const std::string remedy =
        fmt::format("give a text with a number and its unit ({}), such as \"25 {}\"", known,
                    units.front().name);
    if (!value->is_string()) in_.reject(fmt::format("{}: the unit is missing; {}", name, remedy));
    const auto& written = value->get_ref<const std::string&>();
    const std::size_t blank = written.find(' ');
    double number = 0.0;
    if (blank == std::string::npos || deck::parse_real(written.substr(0, blank), number))
      in_.reject(
          fmt::format("{} = \"{:.40}\": not a number with a unit; {}", name, written, remedy));
    const std::string unit =
        written.substr(written.find_first_not_of(' ', blank) == std::string::npos
                           ? blank
                           : written.find_first_not_of(' ', blank));
    for (const Unit& one : units)
      if (one.name == unit) {
        out = number * one.factor;
        check(name, *out, 0.0 == *out && name == "contact_angle");
        return;
      }
    in_.reject(fmt::format("{} = \"{:.40}\": unknown unit; {}", name, written, remedy));
  }
  void number(std::string_view name, std::optional<double>& out) {
    if (in_.find(name) == nullptr) return;
    out = in_.number(name);
    check(name, *out, false);
  }
  void integer(std::string_view name, int most, std::optional<int>& out) {
    if (in_.find(name) == nullptr) return;
    out = in_.integer(name);
    if (*out < 1 || *out > most)
      in_.reject(fmt::format("{} = {}: out of range; give 1 to {}", name, *out, most));
  }
  [[nodiscard]] const JsonMembers& members() const { return in_; }

 private:
  void check(std::string_view name, double value, bool allowed) const {
    if (!allowed && !(value >= kSmallest && value <= kLargest))
      in_.reject(fmt::format("{} = {:g} (SI): out of range; give a value above 0", name, value));
  }
  JsonMembers in_;
};

}  // namespace

BearingFacts facts_of_json(const nlohmann::json& json, std::string_view name) {
  constexpr int kMaxCount = 400, kMaxRows = 4;
  Reader in(json, name);
  BearingFacts out;
  in.text("designation", out.designation);
  in.text("type", out.type);
  in.text("clearance", out.clearance);
  in.text("cage", out.cage);
  in.text("source", out.source);
  in.quantity("bore", kLengthUnits, out.bore);
  in.quantity("outside", kLengthUnits, out.outside);
  in.quantity("width", kLengthUnits, out.width);
  in.quantity("C", kForceUnits, out.C);
  in.quantity("C0", kForceUnits, out.C0);
  in.quantity("Cu", kForceUnits, out.Cu);
  in.number("BPFO", out.BPFO);
  in.number("BPFI", out.BPFI);
  in.number("FTF", out.FTF);
  in.number("BSF", out.BSF);
  in.quantity("mass", kMass, out.mass);
  in.quantity("element_diameter", kLengthUnits, out.element_diameter);
  in.quantity("element_length", kLengthUnits, out.element_length);
  in.quantity("pitch_diameter", kLengthUnits, out.pitch_diameter);
  in.quantity("contact_angle", kAngleUnits, out.contact_angle);
  in.quantity("limiting_speed", kSpeed, out.limiting_speed);
  in.integer("count", kMaxCount, out.count);
  in.integer("rows", kMaxRows, out.rows);
  in.members().finish();
  return out;
}

BearingFacts read_facts(std::string_view json, std::string_view name) {
  return facts_of_json(parse_json(json, name), name);
}

}  // namespace adore::design
