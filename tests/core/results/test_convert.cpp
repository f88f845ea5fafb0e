#include "base/errors.hpp"
#include "results/convert.hpp"
#include "results/restart.hpp"
#include "results/results_h5.hpp"
#include "results/run_json.hpp"
#include "results/sol_writer.hpp"
#include "synthetic.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <functional>
#include <locale>
#include <sstream>

using namespace adore;
using namespace adore::results;
using namespace adore::testing;
using Catch::Matchers::Contains;
using Json = nlohmann::json;

namespace {

std::string converted(const std::filesystem::path& path, std::string_view format) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  std::ostringstream out;
  out.imbue(std::locale(std::locale::classic(), new Comma));  // must not matter
  convert_file(path, format, out);
  return out.str();
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
  return parts;
}

void write_all(const TemporaryFolder& folder, const bearing::Bearing& bearing) {
  ChannelRecorder recorder(bearing, UnitSystem::SI, channel_table());
  SolWriter sol = SolWriter::create(folder / "SOL1", make_sol_header(bearing, 1, UnitSystem::SI),
                                    UnitSystem::SI);
  Sol8Writer animation = Sol8Writer::create(folder / "SOL8", bearing, UnitSystem::SI);
  H5Writer h5 = H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
  for (long step = 0; step < 5; ++step) {
    const StepRecord& record = recorder.record(make_snapshot(bearing, step));
    sol.write(record);
    animation.write(make_snapshot(bearing, step));
    h5.write(record);
  }
  MasterState master;
  master.last.run_id = bearing.run_id;
  master.last.scales = {0.00635, 1000.0, 2e-5};
  master.last.components = {"element.x[1] [m]"};
  master.last.state = {0.1};
  master.averages["average time"] = 0.5;
  master.files = {{"SOL1", "SOL1", 100, {}}};
  write_master(master, folder / "MASTER");
  write_final(master.last, folder / "FINAL");
}

RunSummary make_summary() {
  const bearing::Bearing bearing = make_bearing();
  RunSummary run;
  run.run_id = bearing.run_id;
  run.deck_file = "DATA.txt";
  run.status = "done";
  run.plan = {{"unknowns", 42}};
  run.scales = scene::Scales{0.00635, 1000.0, 2e-5};
  run.integrator = "rkf5";
  run.tolerance = 1e-6;
  run.options = {{"ellipse_major", "12"}};
  run.seeds = {{"start", 1}};
  run.steps = 500;
  run.counters = {{"steps", 500}, {"rejected", 3}};
  run.energy = make_snapshot(bearing, 100).energy;
  run.max_quaternion_error = 1e-16;
  run.cost = {{"race contacts", 1000, 0.6}, {"stepper", 500, 0.3}};
  run.seconds = 1.0;
  run.files = {"PRINT.txt", "SOL7"};
  return run;
}

}  // namespace

TEST_CASE("every result file is recognized by its content and described", "[unit][convert]") {
  TemporaryFolder folder;
  const bearing::Bearing bearing = make_bearing();
  write_all(folder, bearing);
  write_run_json(make_summary(), folder / "RUN.json");
  CHECK(file_kind(folder / "SOL1") == FileKind::Sol);
  CHECK(file_kind(folder / "SOL8") == FileKind::Animation);
  CHECK(file_kind(folder / "RESULTS.h5") == FileKind::ResultsH5);
  CHECK(file_kind(folder / "FINAL") == FileKind::Final);
  CHECK(file_kind(folder / "MASTER") == FileKind::Master);
  CHECK(file_kind(folder / "RUN.json") == FileKind::RunJson);
  CHECK_THAT(describe_file(folder / "SOL1"),
             Contains("Rolling Element 1") && Contains("contact load, outer race") &&
                 Contains("complete steps             5") && Contains("contact.load.inner") &&
                 Contains("synthetic run 7"));
  CHECK_THAT(describe_file(folder / "SOL8"), Contains("animation file") &&
                                                 Contains("element 3 pocket force") &&
                                                 Contains("pitch diameter"));
  CHECK_THAT(describe_file(folder / "RESULTS.h5"),
             Contains("contact.load.3.2") && Contains("energy.residual"));
  CHECK_THAT(describe_file(folder / "MASTER"),
             Contains("element.x[1] [m]") && Contains("100 bytes") && Contains("average time"));
  CHECK_THAT(describe_file(folder / "RUN.json"), Contains("\"unknowns\": 42"));
  const std::string text = read_bytes(folder / "SOL1");
  write_bytes(folder / "SOL1", text.substr(0, text.size() - 30));
  CHECK_THAT(describe_file(folder / "SOL1"),
             Contains("complete steps             4") && Contains("cut off in step 4"));
  write_bytes(folder / "deck", "'1', 0, 0\n'2'\n");
  CHECK_THAT(message_of([&] { (void)describe_file(folder / "deck"); }),
             Contains("not a SOL1-SOL8 file"));
  CHECK_THAT(message_of([&] { (void)describe_file(folder / "."); }), Contains("folder"));
  CHECK_THAT(message_of([&] { (void)describe_file(folder / "none"); }),
             Contains("cannot be opened"));
  write_bytes(folder / "broken", "{ \"a\": ");
  CHECK_THAT(message_of([&] { (void)describe_file(folder / "broken"); }),
             Contains("not valid JSON"));
}

TEST_CASE("what is wrong with a result file is said, whatever it is turned into",
          "[unit][convert]") {
  TemporaryFolder folder;
  write_all(folder, make_bearing());
  for (const char* name : {"SOL1", "SOL8"}) {
    const std::string whole = read_bytes(folder / name);
    std::string cut = whole.substr(0, whole.size() - 30), stars = whole, word = whole;
    const std::size_t number = whole.rfind("E+");
    REQUIRE(number != std::string::npos);
    for (std::size_t k = number - 4; k < number + 4; ++k) stars[k] = '*';
    for (std::size_t k = number; whole[k - 1] != ' '; --k) stars[k - 1] = '*';
    word.replace(number - 4, 3, "abc");
    const std::pair<std::string, std::string> files[] = {{whole, ""},
                                                         {cut, "cut off in step 4"},
                                                         {word, "damaged in step 4"},
                                                         {stars, "1 value is not finite"}};
    for (const auto& [text, said] : files)
      for (const char* format : {"csv", "json"}) {
        CAPTURE(name, said, format);
        write_bytes(folder / "file", text);
        std::ostringstream out;
        const std::string note = convert_file(folder / "file", format, out);
        CHECK(note.empty() == said.empty());
        CHECK_THAT(note, Contains(said));
        CHECK_THAT(describe_file(folder / "file"), Contains(said));
        CHECK_THAT(describe_file_json(folder / "file"), Contains(said));
      }
  }
}

TEST_CASE("conversion to CSV and JSON keeps every value", "[unit][convert]") {
  TemporaryFolder folder;
  const bearing::Bearing bearing = make_bearing();
  write_all(folder, bearing);
  const SolFile sol = read_sol(folder / "SOL1");
  const auto lines = split(converted(folder / "SOL1", "csv"), '\n');
  REQUIRE(lines.size() == 6);
  CHECK_THAT(lines[0], Contains("step,revolutions [rev],") && Contains("contact.load.outer [N]") &&
                           Contains("contact.spin_to_roll.outer,"));
  const auto fields = split(lines[3], ',');
  REQUIRE(fields.size() == 5 + 38);
  CHECK(fields[0] == "2");
  for (std::size_t k = 0; k < 38; ++k) CHECK(std::stod(fields[5 + k]) == sol.steps[2].values[k]);
  const Json json = Json::parse(converted(folder / "SOL1", "json"));
  CHECK(json["header"]["run"] == "synthetic run 7");
  CHECK(json["columns"].size() == 5 + 38);
  CHECK(json["columns"][20]["unit"] == "N");
  CHECK(json["steps"][4][20] == sol.steps[4].values[15]);
  CHECK(json["note"] == "");

  const Json h5 = Json::parse(converted(folder / "RESULTS.h5", "json"));
  CHECK(h5["steps"].size() == 5);
  CHECK(h5["steps"][3].size() == h5["columns"].size());
  for (std::size_t k = 0; k < h5["columns"].size(); ++k)
    if (h5["columns"][k]["id"] == "contact.load.2.2") CHECK(h5["steps"][0][k] == 1200.0);
  CHECK(split(converted(folder / "SOL8", "csv"), '\n').size() == 6);
  CHECK_THAT(converted(folder / "FINAL", "csv"), Contains("state.element.x[1] [m],0.1"));
  CHECK(Json::parse(converted(folder / "MASTER", "json"))["files"][0]["bytes"] == 100);
  CHECK_THAT(message_of([&] { converted(folder / "SOL1", "xml"); }), Contains("csv and json"));

  // Stars are missing values.
  std::string text = read_bytes(folder / "SOL1");
  text.replace(text.rfind('\n') - 16, 16, 16, '*');
  write_bytes(folder / "SOL1", text);
  CHECK(Json::parse(converted(folder / "SOL1", "json"))["steps"][4][5 + 37].is_null());
  CHECK(split(converted(folder / "SOL1", "csv"), '\n')[5].back() == ',');
}

TEST_CASE("RUN.json differs between equal runs only under 'measured'", "[unit][run_json]") {
  RunSummary a = make_summary(), b = make_summary();
  b.seconds = 2.5;
  b.cost[0].seconds = 1.7;
  Json ja = run_json(a), jb = run_json(b);
  CHECK(ja["measured"] != jb["measured"]);
  CHECK(ja["measured"]["cost"][0]["share"] == 0.6);
  CHECK(ja["measured"]["accounted seconds"] == Approx(0.9));
  ja.erase("measured");
  jb.erase("measured");
  CHECK(ja.dump() == jb.dump());
  const scene::EnergyLedger e = *a.energy;
  CHECK(ja["conservation"]["energy"]["residual [J]"] == e.residual());
  // 0.75 J of work and 0.055 J of heat at 1 ms: the larger is the measure.
  CHECK(ja["conservation"]["energy"]["residual over energy moved"] == e.residual() / 0.75);
  CHECK(ja["counters"]["rejected"] == 3);
  CHECK(ja["program"] == "Adore 0.9.0");
  TemporaryFolder folder;
  write_run_json(a, folder / "RUN.json");
  Json stored = Json::parse(read_bytes(folder / "RUN.json"))["measured"];
  Json expected = Json(run_json(a))["measured"];
  CHECK(stored["checksum of this file"] != expected["checksum of this file"]);  // not yet summed
  stored.erase("checksum of this file");
  expected.erase("checksum of this file");
  CHECK(stored == expected);
  CHECK_THAT(message_of([&] { write_run_json(a, "/no/such/RUN.json"); }), Contains("/no/such"));
}
