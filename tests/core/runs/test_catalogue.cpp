#include "base/errors.hpp"
#include "deck/catalogue.hpp"
#include "deck/templates.hpp"
#include "runs/check.hpp"
#include "runs/prepare.hpp"

#include <catch2/catch.hpp>

using namespace adore;

namespace {

deck::Deck deck_of(std::string_view designation) {
  return deck::read_deck_text(deck::catalogue_deck(deck::find_bearing(designation)),
                              std::string(designation))
      .deck;
}

}  // namespace

TEST_CASE("catalogue: designation → standard outside and estimated internal geometry",
          "[unit][catalogue]") {
  const deck::Deck ball = deck_of("6205");
  CHECK(ball.real("brgBore") == 0.025);
  CHECK(ball.real("brgOD") == 0.052);
  CHECK(ball.real("raceWidth1") == 0.015);
  CHECK(ball.integer("nRe") == 9);            // as every maker's 6205 has
  CHECK(ball.real("bReDia") == 0.0079375);    // 5/16 in, likewise
  CHECK(ball.real("freeIntCls") == 12.5e-6);  // middle of CN, 5 to 20 um
  const deck::Deck angular = deck_of("7208");
  CHECK(angular.real("brgBore") == 0.040);
  CHECK(angular.real("brgOD") == 0.080);
  CHECK(angular.real("freeConAng") == 40.0);
  CHECK(deck_of("7208 ac").real("freeConAng") == 25.0);
  CHECK(deck_of("7208C").real("freeConAng") == 15.0);
  const deck::Deck roller = deck_of("nu 209");
  CHECK(roller.real("brgOD") == 0.085);
  CHECK(roller.integer("nRe") == 15);
  CHECK(roller.real("bReDia") == 0.011);
  const deck::Deck tapered = deck_of("30208");
  CHECK(tapered.real("raceWidth1") == 0.016);
  CHECK(tapered.real("raceWidth2") == 0.018);
  CHECK(tapered.real("raceTaper1") == Approx(14.0 + 2.0 / 60.0 + 10.0 / 3600.0).epsilon(1e-7));
  const deck::Deck spherical = deck_of("22210");
  CHECK(spherical.real("brgBore") == 0.050);
  CHECK(spherical.real("raceWidth1") == 0.0115);  // one of two rows
  CHECK(deck_of("6205-2RS") == deck_of("6205"));
  const deck::Deck small = deck_of("6203");
  CHECK(small.integer("nRe") == 8);  // as published (tests/candidates)
  CHECK(small.real("bReDia") == Approx(6.747e-3).epsilon(1e-4));
  CHECK(deck_of("608").real("brgOD") == 0.022);
  CHECK(deck_of("71908 C").real("brgOD") == 0.062);
  CHECK(deck_of("6060").real("brgBore") == 0.300);
  CHECK(deck_of("23048").real("brgOD") == 0.360);
  CHECK(deck_of("7208 B").real("rpm2") < 4000.0);  // n dm of 200,000 mm/min
}

TEST_CASE("catalogue: designs of cylindrical roller bearings → flanges", "[unit][catalogue]") {
  const auto flanges = [](const char* name) {
    const deck::Deck deck = deck_of(name);
    std::string out;
    for (const char* flange : {"flngHt11", "flngHt21", "flngHt12", "flngHt22"}) {
      const bool present = deck.integer("kFlngInd" + std::string(flange).substr(6)) == 1;
      CHECK((deck.real(flange) > 0.0) == present);
      out += present ? '1' : '0';
    }
    return out;
  };
  CHECK(flanges("NU209") == "1100");
  CHECK(flanges("N209") == "0011");
  CHECK(flanges("NJ209") == "1110");
  CHECK(flanges("NUP209") == "1111");
  CHECK(deck::find_bearing("SKF NJ 209 ECP").designation == "NJ209");
}

TEST_CASE("catalogue: public test rigs → published geometry", "[unit][catalogue]") {
  const std::vector<std::string> rigs = deck::test_rig_names();
  CHECK(rigs.size() >= 12);
  const deck::Deck drive_end = deck_of("cwru-6205-de");
  CHECK(drive_end.integer("nRe") == 9);
  CHECK(drive_end.real("pitchDia") == Approx(0.03904));
  for (const std::string& name : rigs) {
    INFO(name);
    const deck::Deck deck = deck_of(name);
    for (const Issue& issue : runs::check_model(deck)) {
      INFO(issue.text());
      CHECK(issue.severity != Severity::Error);
    }
    std::string story;
    for (const std::string& line : deck::describe_catalogue_bearing(deck::find_bearing(name)))
      story += line;
    CHECK(story.find("Published internal geometry") != std::string::npos);
    CHECK(story.find("assumed: ") != std::string::npos);
  }
}

TEST_CASE("catalogue: list → filters on bore and type", "[unit][catalogue]") {
  const auto all = deck::catalogue_list(25.0, "deep-groove");
  CHECK(all.size() == 8);  // 6005, 6205, 6305, 16005, 61805, 61905, two rigs (one of 25.4 mm)
  for (const deck::CatalogueBearing& one : all) {
    CHECK(std::abs(one.envelope.bore - 0.025) < 0.0005);
    CHECK(one.type == deck::BearingType::DeepGroove);
  }
  CHECK(deck::catalogue_list(0.0, "").size() > 1000);
  CHECK(deck::catalogue_list(1234.0, "").empty());
  CHECK_THROWS_AS(deck::catalogue_list(0.0, "plain"), InputError);
}

TEST_CASE("catalogue: clearance group in a designation → used, or reported as unused",
          "[unit][catalogue]") {
  CHECK(deck_of("6205 C3").real("freeIntCls") == 20.5e-6);  // 13 to 28 um
  CHECK(deck_of("6205-2RSC2").real("freeIntCls") == 6e-6);  // 1 to 11 um
  CHECK(deck_of("6205/C5").real("freeIntCls") == 41.5e-6);
  CHECK(deck_of("6205 CN") == deck_of("6205"));
  CHECK(deck_of("NU209 ECP/C3").real("freeIntCls") == 65e-6);
  CHECK(deck_of("22210 E/C4").real("freeIntCls") == 87.5e-6);
  const auto left = [](std::string_view name) { return deck::find_bearing(name).left_out; };
  CHECK(left("6205 C3").empty());
  CHECK(left("6205-2RS C3") == "2RS");
  CHECK(left("SKF 22210 E/C3") == "SKF E");
  CHECK(left("NU209/C5") == "C5");  // of rollers no such group is known here
  CHECK(left("30208 C3") == "C3");
  CHECK(left("7208 B/C3") == "C3");
  CHECK(deck::find_bearing("7208 C").angle == 15.0);
  for (const char* group : {"C2", "CN", "C3", "C4", "C5"})
    for (const auto& [angle, degrees] :
         {std::pair{"", 40.0}, {"C/", 15.0}, {"AC ", 25.0}, {"B", 40.0}})
      for (const char* size : {"7008 ", "7208", "7308 "}) {
        const std::string name = std::string(size) + angle + group;
        INFO(name);
        CHECK(deck::find_bearing(name).angle == degrees);
        CHECK(left(name) == group);
      }
  // Every group of every type: wider from one to the next, and each in the story.
  for (const char* name : {"6205", "6316", "NU209", "NU320", "22205", "22220"}) {
    double before = -1.0;
    for (const char* group : {"C2", "CN", "C3", "C4"}) {
      const deck::CatalogueBearing found = deck::find_bearing(std::string(name) + " " + group);
      INFO(name << " " << group);
      CHECK(found.clearance == group);
      const double here = deck_of(std::string(name) + " " + group).real("freeIntCls");
      CHECK(here > before);
      before = here;
      std::string story;
      for (const std::string& line : deck::describe_catalogue_bearing(found)) story += line;
      CHECK(story.find("middle of group " + std::string(group)) != std::string::npos);
      CHECK(story.find("Ignored parts") == std::string::npos);
    }
  }
  for (const char* name : {"6205-2RS", "NU209/C5", "30208 C3", "7208 B/C3", "SKF 6205"}) {
    std::string story;
    for (const std::string& line : deck::describe_catalogue_bearing(deck::find_bearing(name)))
      story += line;
    INFO(name);
    CHECK(story.find("Ignored parts of the designation: " + left(name)) != std::string::npos);
  }
}

TEST_CASE("catalogue: tapered bore → reported, with the type of its clearance groups",
          "[unit][catalogue]") {
  const auto told = [](std::string_view name) {
    for (const std::string& sentence : deck::describe_catalogue_bearing(deck::find_bearing(name)))
      if (sentence.starts_with("Bearings with a tapered bore (K)")) return true;
    return false;
  };
  for (const char* name : {"22210 K", "22210 EK", "22210 EK/C3", "SKF 22210 CCK/W33", "22210 K30",
                           "22210-E1-XL-K", "NU209 K"}) {
    CAPTURE(name);
    CHECK(told(name));
  }
  for (const char* name : {"22210", "NSK 22210", "SKF 22210 E/C3", "22210 CC/W33", "6205-2RSK",
                           "NU209 ECP", "30208"}) {
    CAPTURE(name);
    CHECK_FALSE(told(name));
  }
  // Published limits of bore 50 mm, in micrometres: C2 30 to 45, CN to 60, C3 to 80, C4 to 100.
  for (const auto& [group, middle] :
       {std::pair{"C2", 37.5}, {"CN", 52.5}, {"C3", 70.0}, {"C4", 90.0}}) {
    CAPTURE(group);
    const auto clearance = [&](const std::string& name) {
      return deck_of(name + " " + group).real("freeIntCls");
    };
    CHECK(clearance("22210 K") == Approx(middle * 1e-6));
    CHECK(clearance("22210 K") > clearance("22210"));
    CHECK(clearance("NU210 K") == clearance("NU210"));  // not known, and said
  }
  for (const int size : {5, 6, 7, 8, 9, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20}) {
    const std::string name = "222" + std::string(size < 10 ? "0" : "") + std::to_string(size);
    CAPTURE(name);
    CHECK(deck_of(name + " K").real("freeIntCls") > deck_of(name).real("freeIntCls"));
  }
}

TEST_CASE("catalogue: size with blanks or the multiplication sign → accepted",
          "[unit][catalogue]") {
  for (const char* typed : {"deep-groove 25 x 52 x 15", "deep-groove 25\u00d752\u00d715",
                            "deep-groove 25 \u00d7 52 \u00d7 15", "Deep-Groove 25X52X15"}) {
    INFO(typed);
    CHECK(deck_of(typed) == deck_of("deep-groove 25x52x15"));
  }
}

TEST_CASE("catalogue: internal geometry for a deck with a cage → includes the cage",
          "[unit][catalogue]") {
  for (const char* designation : {"6205", "7310 B", "NU209", "NU320", "30208", "30216", "22210"}) {
    INFO(designation);
    deck::Deck moving = deck_of(designation);
    const std::vector<std::pair<std::string, std::string>> motion = {{"mode", "0"}, {"nCseg", "1"}};
    moving.set_all(motion);
    const deck::ProposedInternalGeometry inner = deck::propose_internal_geometry(moving);
    moving.set_all(inner.sets);
    CHECK(moving.real("cageDia1") > moving.real("cageDia2"));
    CHECK(moving.real("cageDia2") > moving.real("brgBore"));
    CHECK(moving.real("cageDia1") < moving.real("brgOD"));
    CHECK(moving.real("bPocCls1") > 0.0);
    for (const Issue& issue : deck::check_deck(moving)) {
      INFO(issue.text());
      CHECK(issue.severity != Severity::Error);
    }
    for (const Issue& issue : runs::check_model(moving)) {
      INFO(issue.text());
      CHECK(issue.severity != Severity::Error);
    }
  }
  deck::Deck english = deck::new_deck("ball-english");
  const deck::ProposedInternalGeometry inner = deck::propose_internal_geometry(english);
  english.set_all(inner.sets);
  CHECK(english.si("cageWidth") == Approx(deck::new_deck("ball").real("cageWidth")).epsilon(0.2));
}

TEST_CASE("catalogue: spherical bearing → reported as one row of two", "[unit][catalogue]") {
  std::string story;
  for (const std::string& line : deck::describe_catalogue_bearing(deck::find_bearing("22210")))
    story += line;
  CHECK(story.find("ONE of the two rows") != std::string::npos);
  CHECK(deck::catalogue_deck(deck::find_bearing("22210")).find("half of the radial load") !=
        std::string::npos);
}

TEST_CASE("catalogue: estimates agree with the example decks of the same sizes",
          "[unit][catalogue]") {
  // The examples were made from textbooks and catalogues: 6 % of a size, one element in fifteen.
  // The NU209 of the textbooks has 14 rollers of 10 mm, fewer and smaller than those of today.
  for (const auto& [designation, example] : {std::pair{"6205", "deep-groove-6205"},
                                             {"30208", "tapered-30208"},
                                             {"22210", "spherical-22210"}}) {
    INFO(designation);
    const deck::Deck mine = deck_of(designation), theirs = deck::new_deck(example);
    CHECK(mine.real("bReDia") == Approx(theirs.real("bReDia")).epsilon(0.02));
    CHECK(std::abs(mine.integer("nRe") - theirs.integer("nRe")) <= 1);
    if (mine.has("bReLen"))
      CHECK(mine.real("bReLen") == Approx(theirs.real("bReLen")).epsilon(0.06));
    if (mine.has("raceTaper2"))
      CHECK(mine.real("raceTaper2") == Approx(theirs.real("raceTaper2")).epsilon(0.01));
    CHECK(mine.real("appLoadZ") == Approx(theirs.real("appLoadZ")).epsilon(0.1));
  }
}

TEST_CASE("catalogue: every bearing → deck without errors", "[unit][catalogue]") {
  const std::vector<std::string> all = deck::catalogue_designations();
  CHECK(all.size() > 250);
  for (const std::string& designation : all) {
    INFO(designation);
    const deck::ReadResult read =
        deck::read_deck_text(deck::catalogue_deck(deck::find_bearing(designation)), designation);
    for (const Issue& issue : read.issues) {
      INFO(issue.text());
      CHECK(issue.severity != Severity::Error);
    }
    for (const Issue& issue : runs::check_model(read.deck)) {
      INFO(issue.text());
      CHECK(issue.severity != Severity::Error);
    }
    CHECK(deck::find_bearing(designation).designation == designation);
  }
}

TEST_CASE("catalogue: every deck → finds its equilibrium", "[physics][catalogue]") {
  for (const char* designation :
       {"6205", "6316", "7208 B", "7020 C", "NU209", "NU320", "30208", "30216", "22210", "22220",
        "deep-groove 25x52x15", "cylindrical 100x180x34"}) {
    INFO(designation);
    runs::DeckRequest request;
    request.text = deck::catalogue_deck(deck::find_bearing(designation));
    const runs::Prepared ready = runs::prepare(request);
    CHECK(ready.race_result().max_load > 0.0);
  }
}

TEST_CASE("catalogue: remarks mark standard values and estimates", "[unit][catalogue]") {
  const std::string text = deck::catalogue_deck(deck::find_bearing("6308"));
  CHECK(text.find("boundary dimensions of 6308: ISO 15") != std::string::npos);
  CHECK(text.find("ESTIMATE of the internal geometry") != std::string::npos);
  CHECK(text.find("size 6205") == std::string::npos);
  const auto story = deck::describe_catalogue_bearing(deck::find_bearing("6308"));
  REQUIRE(story.size() >= 2);
  CHECK(story[0].find("bore 40 mm, outside diameter 90 mm, width 23 mm") != std::string::npos);
}

TEST_CASE("catalogue: unknown designation → error with the known ones", "[unit][catalogue]") {
  for (const char* unknown : {"", "6299", "1205", "7208 X", "NU", "NU200", "deep-groove 25x52",
                              "deep-groove 52x25x15", "deep-groove axbxc", "62O5", "620512"}) {
    INFO(unknown);
    try {
      (void)deck::find_bearing(unknown);
      FAIL("found");
    } catch (const InputError& error) {
      REQUIRE_FALSE(error.issues().empty());
      CHECK(error.issues()[0].remedy.find("6205") != std::string::npos);
    }
  }
  CHECK_THROWS_AS(
      deck::propose_internal_geometry(deck::BearingType::DeepGroove, {0.05, 0.04, 0.01, 0.01}, 0.0),
      InputError);
}
