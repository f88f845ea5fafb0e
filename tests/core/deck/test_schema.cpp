#include "base/errors.hpp"
#include "bearing/material.hpp"
#include "core/deck/deck_variants.hpp"
#include "deck/condition.hpp"
#include "deck/lookup.hpp"
#include "deck/schema.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace adore::deck;

namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::vector<Row> parse_tsv(const std::string& text) {
  std::vector<std::string> lines = split(text, '\n');
  if (lines.back().empty()) lines.pop_back();
  const std::vector<std::string> header = split(lines.front(), '\t');
  std::vector<Row> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i], '\t');
    REQUIRE(cells.size() == header.size());
    Row row;
    for (std::size_t j = 0; j < header.size(); ++j) row[header[j]] = cells[j];
    rows.push_back(row);
  }
  return rows;
}

std::vector<Row> reference_rows() {
  std::ifstream in(adore::test::source_dir().string() + "/tests/reference/records.tsv");
  REQUIRE(in);
  std::stringstream text;
  text << in.rdbuf();
  return parse_tsv(text.str());
}

/// The codes in front of '=' in an options cell; a table stays as it is.
std::vector<std::string> codes_of(const std::string& options) {
  std::vector<std::string> codes;
  for (std::string part : split(options, ';')) {
    part.erase(0,
               part.find_first_not_of(' ') == std::string::npos ? 0 : part.find_first_not_of(' '));
    if (!part.empty()) codes.push_back(part.substr(0, part.find('=')));
  }
  return codes;
}

/// A second evaluation of the conditions, written apart from the first: it cuts the text at its
/// outermost operator instead of reading it from left to right.
class Outermost {
 public:
  explicit Outermost(const Deck& deck) : deck_(deck) {}

  bool value(std::string text) const {
    text = strip(text);
    for (const std::string op : {"||", "&&"}) {
      const std::size_t at = find_outside(text, op);
      if (at == std::string::npos) continue;
      const bool left = value(text.substr(0, at));
      const bool right = value(text.substr(at + 2));
      return op == "||" ? left || right : left && right;
    }
    if (text == "true") return true;
    if (text.front() == '(' && text.back() == ')') return value(text.substr(1, text.size() - 2));
    if (const std::size_t in = text.find(" in ("); in != std::string::npos) {
      const std::vector<std::string> items = split(text.substr(in + 5, text.size() - in - 6), ',');
      return std::count(items.begin(), items.end(), std::to_string(number(text.substr(0, in)))) > 0;
    }
    for (const std::string op : {"==", "!=", "<=", ">=", "<", ">"}) {
      const std::size_t at = text.find(op);
      if (at == std::string::npos) continue;
      const long long left = number(text.substr(0, at));
      const long long right = number(text.substr(at + op.size()));
      if (op == "==") return left == right;
      if (op == "!=") return left != right;
      if (op == "<=") return left <= right;
      if (op == ">=") return left >= right;
      return op == "<" ? left < right : left > right;
    }
    FAIL("cannot evaluate " << text);
    return false;
  }

 private:
  static std::string strip(std::string text) {
    text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
  }
  static std::size_t find_outside(const std::string& text, const std::string& op) {
    int depth = 0;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
      if (text[i] == '(') ++depth;
      if (text[i] == ')') --depth;
      if (depth == 0 && text.compare(i, 2, op) == 0) return i;
    }
    return std::string::npos;
  }
  long long number(const std::string& raw) const {
    const std::string text = strip(raw);
    if (text == "user()") return 0;
    if (text == "max(iCageGuide)") {
      long long largest = 0;
      for (int i = 1; i <= 4; ++i) largest = std::max(largest, deck_.integer("iCageGuide", i));
      return largest;
    }
    if (std::isdigit(static_cast<unsigned char>(text[0])) || text[0] == '-')
      return std::stoll(text);
    return deck_.integer(text);
  }

  const Deck& deck_;
};

}  // namespace

TEST_CASE("schema: equal to the reference list, line by line", "[unit][schema]") {
  const std::vector<Row> expected = reference_rows();
  std::vector<Row> actual = parse_tsv(schema_tsv());
  std::erase_if(actual, [](const Row& row) { return is_extension(row.at("record")); });
  REQUIRE(expected.size() == 756);
  REQUIRE(actual.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Row& want = expected[i];
    const Row& have = actual[i];
    CAPTURE(want.at("record"), want.at("variable"));
    for (const std::string column : {"record", "required_when", "repeat", "order", "variable",
                                     "type", "length", "unit_si", "unit_en", "default"})
      CHECK(have.at(column) == want.at(column));
    const std::vector<std::string> codes = codes_of(have.at("options"));
    for (const std::string& code : codes_of(want.at("options")))
      CHECK(std::count(codes.begin(), codes.end(), code) == 1);
    if (want.at("options").empty()) CHECK(codes.empty());
    CHECK(have.at("meaning").size() > 5);
    CHECK_FALSE(have.at("title").empty());
  }
}

TEST_CASE("conditions: same records as an independent evaluation", "[unit][schema]") {
  const std::vector<Row> reference = reference_rows();
  std::set<std::string> seen;
  for (const Deck& deck : deck_variants::all()) {
    const Outermost independent(deck);
    std::set<std::string> wanted;
    for (const Row& row : reference)
      if (row.at("order") == "0" && row.at("record") != "12" &&
          independent.value(row.at("required_when")))
        wanted.insert(row.at("record"));
    std::set<std::string> present;
    for (const RecordData& record : deck.records) present.insert(record.id);
    CHECK(present == wanted);
    seen.insert(present.begin(), present.end());
  }
  for (const RecordSpec& record : schema())
    if (record.id != "12" && !is_extension(record.id)) {
      INFO("no variant has record " << record.id);
      CHECK(seen.count(std::string(record.id)) == 1);
    }
}

TEST_CASE("conditions: syntax error → InternalError", "[unit][schema]") {
  const ConditionScope scope{[](std::string_view name) { return name == "kBrg" ? 3LL : 0LL; },
                             [](std::string_view) {
                               return std::vector<long long>{1, 5, 2};
                             },
                             7};
  CHECK(evaluate("kBrg in (1,3,5)", scope));
  CHECK(evaluate("max(anything) == 5 && user() == 7", scope));
  CHECK(evaluate("kBrg == 1 || (kBrg > 2 && absent <= 0)", scope));
  CHECK(evaluate("absent != -1", scope));
  CHECK_FALSE(evaluate("kBrg < 3", scope));
  for (const char* broken : {"", "kBrg", "kBrg ==", "kBrg == 1 &&", "(kBrg == 1", "kBrg == 1)",
                             "kBrg in 1", "kBrg in (1", "max(", "kBrg = 1", "== 1"})
    CHECK_THROWS_AS(evaluate(broken, scope), adore::InternalError);
  CHECK(variable_names_in("kBrg in (1,2) && max(iCageGuide) > 0 || user() > 0 && kBrg == 1") ==
        std::vector<std::string_view>{"kBrg", "iCageGuide"});
}

TEST_CASE("units: factors of the exact definitions", "[unit][schema]") {
  const auto factor = [](std::string_view name) {
    return find_variable(name).front().spec().unit.en_factor;
  };
  // Rounding of the products only.
  const auto is = [](double expected) { return Catch::WithinRel(expected, 1e-15); };
  CHECK_THAT(factor("pitchDia"), is(0.0254));
  CHECK_THAT(factor("bReMass"), is(0.45359237));
  CHECK_THAT(factor("appLoadX"), is(4.4482216152605));
  CHECK_THAT(factor("roomTemp"), is(5.0 / 9.0));
  CHECK_THAT(factor("reCTE"), is(1.8));
  CHECK_THAT(factor("reEM"), is(6894.757293168361));
  CHECK_THAT(factor("reDen"), is(27679.904710203125));
  CHECK_THAT(factor("appMomY"), is(0.1129848290276167));
  CHECK_THAT(factor("reTC"), is(8.0067989074689));  // 1 lbf/(s R) in W/(m K)
  CHECK_THAT(factor("reHTC"), is(315.2283034436575));
  CHECK_THAT(factor("cFlowRate"), is(1.6387064e-5));
  CHECK_THAT(factor("reRaceTC2"), is(1.0 / 0.0254));
  // 1 BTU = 9338.0319 lbf in, and 1 BTU/(lbm R) = 4186.8 J/(kg K) by definition (International
  // Table). Table).
  CHECK(factor("reSH") * 9338.0318994 == Approx(4186.8).epsilon(1e-6));
  // lbm, lbf, in and s are not coherent: their constant is 386.09 lbm in/(lbf s^2).
  CHECK_THAT(factor("appLoadX") / (factor("bReMass") * factor("pitchDia")), is(386.0885826771653));
  CHECK_THAT(find_variable("freeConAng").front().spec().unit.si_factor, is(0.017453292519943295));
  CHECK_THAT(find_variable("rpm1").front().spec().unit.si_factor, is(0.10471975511965977));
}

TEST_CASE("schema: every variable has a help text, every default is valid", "[unit][schema]") {
  std::set<std::string_view> ids;
  for (const RecordSpec& record : schema()) {
    CHECK(ids.insert(record.id).second);
    for (const VariableSpec& variable : record.variables) {
      CAPTURE(record.id, variable.name);
      CHECK((variable.help.ends_with('.') || variable.help.ends_with(')')));
      CHECK(variable.range.min <= variable.range.max);
      CHECK(std::isfinite(variable.unit.en_factor));
      CHECK(variable.unit.en_factor > 0.0);
      if (variable.unit.si == variable.unit.en)
        CHECK(variable.unit.si_factor == variable.unit.en_factor);
      if (variable.type == VarType::String && variable.name != "userLine")
        CHECK(variable.max_length > 0);
      if (variable.default_value.empty() || variable.type == VarType::String) continue;
      const double value = std::stod(std::string(variable.default_value));
      CHECK((variable.range.min_exclusive ? value > variable.range.min
                                          : value >= variable.range.min));
      CHECK(value <= variable.range.max);
    }
  }
}

TEST_CASE("schema: material codes are those of the material table", "[unit][schema]") {
  std::vector<int> codes;
  for (const OptionSpec& option : option_table("@materials"))
    codes.push_back(std::stoi(std::string(option.code)));
  CHECK(codes == adore::bearing::material_codes());
  CHECK_THROWS_AS(option_table("@nothing"), adore::InternalError);
}

TEST_CASE("schema: export as JSON and Markdown", "[unit][schema]") {
  const nlohmann::json json = nlohmann::json::parse(schema_json());
  REQUIRE(json.at("records").size() == schema().size());
  const nlohmann::json& mode = json.at("records").at(0).at("variables").at(1);
  CHECK(mode.at("name") == "mode");
  CHECK(mode.at("options").size() == 5);
  CHECK(json.at("option_tables").at("@churning").size() == 15);
  const std::string markdown = schema_markdown();
  CHECK_THAT(markdown, Catch::Contains("## 5A Ball bearing geometry"));
  CHECK_THAT(markdown, Catch::Contains("`cageGcPos(3)`"));
}

TEST_CASE("lookup: mistyped name → suggestions", "[unit][schema]") {
  CHECK(find_variable("bReDia").size() == 5);
  CHECK(find_variable("nothing").empty());
  CHECK(find_variable("recID").empty());
  REQUIRE(find_record("7.2.i") != nullptr);
  CHECK(find_record("7.2.i")->repeat == "nGL");
  CHECK(find_record("7.2.1") == nullptr);
  CHECK(similar_variables("pichDia").front() == "pitchDia");
  CHECK(similar_variables("NRE").front() == "nRe");
  CHECK(similar_variables("ptichDia").front() == "pitchDia");
  CHECK(similar_variables("zz").empty());
  CHECK(similar_variables("cageGs").size() == 3);
  CHECK(similar_variables("zzzzzzzzzz").empty());
}
