#include "deck/schema_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

/// Records 1 to 3.5: run control, names, options.
namespace adore::deck {
namespace {

using range::between;

constexpr Range kCount = between(0, kInfinity);

RecordSpec run_mode() {
  return record(
      "1", "Run mode and output control", "true",
      {choice("mode",
              {{"-n", "same as code -1"},
               {"-1", "quasi-static solution only"},
               {"0", "motion of all bodies in six degrees of freedom"},
               {"1", "radial force balance of elements (balls, tapered rollers: also axial)"},
               {"2", "same as code 1, and force balance of the inner race"}},
              "Kind of simulation. 0 integrates the motion of every body. 1 and 2 replace fast "
              "contact vibration by force balance, which allows larger steps. A negative value "
              "stops after the static solution."),
       choice(
           "kDCR",
           {{"0", "built-in race constraints (prescribed displacement)"},
            {"1", "constraints given on record 2.2"}},
           "Source of the constraints on the motion of the races. With the built-in constraints, "
           "both races keep the position of the static solution and rotate at their given speeds.",
           "0"),
       choice("kDOF",
              {{"0", "no additional suppression"},
               {"1", "no axial translation of rolling elements and cage"},
               {"2", "same as code 1, and no rotation about y and z"},
               {"3", "no axial translation of rolling elements"},
               {"4", "same as code 3, and no rotation about y and z"},
               {"5", "all six accelerations of rolling elements are zero"},
               {"6", "chosen in user routine ADRX1"}},
              "Degrees of freedom that are suppressed in addition to those that mode replaces by "
              "force balance. A suppressed degree of freedom keeps its initial velocity. Its "
              "acceleration is zero, and no force balance is solved for it."),
       choice("kIcOpt",
              {{"-1", "new run at time zero from the state in file FINAL, with new files"},
               {"0", "start from the quasi-static solution"},
               {"1", "continue the run in MASTER and FINAL (without MASTER, same as code -1)"}},
              "Initial state of a dynamic run. Use -1 to start a new run from an earlier final "
              "state, and 1 to continue a stopped run.",
              "0"),
       choice("kFnOpt", {{"0", "default file names"}, {"1", "names given on record 2.3"}},
              "Names of the data files. The defaults are MASTER, FINAL and SOL1 to SOL8.", "0"),
       choice("kPrtOpt",
              {{"-2", "section 4 only"},
               {"-1", "sections 3 and 4"},
               {"0", "sections 2, 3 and 4"},
               {"1", "all sections, every rolling element"},
               {"n", "all sections, but only every n-th rolling element"}},
              "Contents of each printed step in PRINT.txt. The sections are 1 (rolling elements), "
              "2 (races and cage), 3 (applied parameters) and 4 (summary of the step)."),
       choice("kPrtFreq",
              {{"0", "first and last step only"}, {"1", "every step"}, {"n", "every n-th step"}},
              "Interval between printed steps. Step 0 is time zero."),
       choice("kPltFreq",
              {{"0", "first and last step only"}, {"1", "every step"}, {"n", "every n-th step"}},
              "Interval between the steps that are stored in the plot files SOL1 to SOL7."),
       choice("kAGraf", {{"0", "no animation file"}, {"n", "store every n-th step"}},
              "Interval between the steps that are stored for animation in SOL8. 0 stores no "
              "animation."),
       choice("kLifeFreq",
              {{"0", "first and last step only"}, {"1", "every step"}, {"n", "every n-th step"}},
              "Interval between the steps for which SOL7 contains a fatigue life. The life of a "
              "step is computed from the loads of that step alone. The life of the whole run uses "
              "the loads of every step."),
       choice("kTherm", {{"0", "off"}, {"1", "on"}},
              "Thermal analysis. When it is on, temperatures follow from the heat that the run "
              "generates. Records 3.5 and 9.7 then specify coolant and heat transfer."),
       integer("maxStps", kCount,
               "Largest number of counted integration steps (see nStps). The run ends at this "
               "number of counted steps or at fTime, whichever comes first."),
       integer(
           "nStps", kCount,
           "Interval between counted integration steps. With n, only every n-th integration step "
           "is counted and stored. With 0 or 1, every integration step is counted and stored."),
       choice("intMet",
              {{"1", "explicit Runge-Kutta-Fehlberg, order 1"},
               {"2", "explicit, order 2"},
               {"3", "explicit, order 3"},
               {"4", "explicit, order 4"},
               {"5", "explicit, order 5"},
               {"6", "explicit, order 6"},
               {"7", "explicit, order 7"},
               {"11", "predictor-corrector, order 1"},
               {"12", "predictor-corrector, order 2"},
               {"13", "predictor-corrector, order 3"},
               {"14", "predictor-corrector, order 4"},
               {"15", "predictor-corrector, order 5"},
               {"16", "predictor-corrector, order 6"},
               {"17", "predictor-corrector, order 7"},
               {"18", "predictor-corrector, order 8"},
               {"21", "CVODE Adams (extension)"},
               {"22", "CVODE BDF (extension)"},
               {"31", "ARKODE explicit (extension)"},
               {"32", "ARKODE diagonally implicit (extension)"},
               {"33", "ARKODE implicit-explicit (extension)"},
               {"41", "classical Runge-Kutta, order 4 (extension)"}},
              "Integration method. The explicit method of order 5 suits most runs. Codes above 18 "
              "are extensions, which the classic program does not have.",
              "5")});
}

RecordSpec step_control() {
  return record(
      "2.1", "Time step control", "mode >= 0",
      {real("stpInit", unit::kPure, range::kNotNegative,
            "First trial step in dimensionless time (multiples of the time scale that PRINT.txt "
            "reports). When a run is continued, 0 reuses the last step size stored in file MASTER.",
            "0.050"),
       real("stpMin", unit::kPure, range::kPositive,
            "Smallest step in dimensionless time. A step of this size is accepted even if its "
            "error is too large; the run reports the number of such steps. stpMin = stpMax gives a "
            "constant step.",
            "5.0e-04"),
       real("stpMax", unit::kPure, range::kPositive,
            "Largest step in dimensionless time. It limits the time resolution of plots.", "0.50"),
       real("fTime", unit::kPure, range::kNotNegative, "End of the run in dimensionless time.",
            "1000"),
       real("tol", unit::kPure, Range{0.0, 1.0, true},
            "Allowed error per step, relative to the scale of each variable. A smaller value makes "
            "the run more accurate and slower.",
            "1.0e-06"),
       real("qFac", unit::kPure, range::kNotNegative,
            "Load ratio up to which rolling elements are quasi-static in mode 0. An element is in "
            "force balance while its contact load is at most qFac times the largest applied load. "
            "With 0, no element is quasi-static.")});
}

RecordSpec race_constraints() {
  RecordSpec spec = record("2.2", "Race force or displacement constraints", "kDCR == 1", {});
  constexpr std::array<std::pair<int, std::string_view>, 2> kRaces = {{{1, "outer"}, {2, "inner"}}};
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  for (const auto& [race, race_name] : kRaces)
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
      spec.variables.push_back(
          choice(intern_string(fmt::format("kFD{}{}", axis + 1, race)),
                 {{"0", "race accelerates under the prescribed force"},
                  {"1", "race position from the static solution or from a prescribed motion"}},
                 intern_string(fmt::format(
                     "Translation constraint of the {} race along {}. With 0, the race moves "
                     "freely under its load.",
                     race_name, kAxes[axis])),
                 "1"));
  constexpr std::array<std::string_view, 3> kMoments = {"zero", "appMomY", "appMomZ"};
  for (const auto& [race, race_name] : kRaces)
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
      spec.variables.push_back(choice(
          intern_string(fmt::format("kMD{}{}", axis + 1, race)),
          {{"0", "race accelerates under the moments on it"},
           {"1", "fixed speed or prescribed angular acceleration"}},
          intern_string(fmt::format(
              "Rotation constraint of the {} race about {}. With 0, the moments on the race change "
              "its speed. Without user routine ADRX1, the external moment is {}{}.",
              race_name, kAxes[axis], axis > 0 && race == 1 ? "minus " : "", kMoments[axis])),
          "1"));
  return spec;
}

RecordSpec file_names() {
  RecordSpec spec = record(
      "2.3", "Names of data files", "kFnOpt == 1",
      {text("masName", 10,
            "Name of the file with the data for continuing a run, at most 10 characters.",
            "MASTER"),
       text("finName", 10,
            "Name of the file of the final state, at most 10 characters. A run can start from this "
            "state (kIcOpt).",
            "FINAL")});
  for (int i = 1; i <= 6; ++i)
    spec.variables.push_back(
        text(intern_string(fmt::format("pltNames{}", i)), 10,
             intern_string(fmt::format(
                 "Name of the plot file of monitored body {}, at most 10 characters.", i)),
             intern_string(fmt::format("SOL{}", i))));
  spec.variables.push_back(text(
      "pltNames7", 10, "Name of the file of power loss and life, at most 10 characters.", "SOL7"));
  spec.variables.push_back(
      text("pltNames8", 10, "Name of the file of animation data, at most 10 characters.", "SOL8"));
  return spec;
}

RecordSpec run_identification() {
  return record(
      "3.1", "Run identification", "true",
      {text("runID", 36,
            "Bearing code or name of the run, at most 36 characters. It is printed on every page "
            "and stored in every data file. It must be the same when a run is continued.")});
}

VariableSpec race_imperfection(int race, std::string_view race_name) {
  return choice(intern_string(fmt::format("kRaceGeoImp{}", race)),
                {{"0", "ideal"},
                 {"1", "elliptical roundness, other errors sinusoidal"},
                 {"2", "all errors sinusoidal"},
                 {"3", "user routine ADRX6"}},
                intern_string(fmt::format("Geometry errors of the {} race.", race_name)));
}

VariableSpec flange(int side, int race, std::string_view where) {
  return choice(intern_string(fmt::format("kFlngInd{}{}", side, race)),
                {{"0", "none"}, {"1", "present"}},
                intern_string(fmt::format("Roller guide flange on the {} x side. Ball and "
                                          "spherical roller bearings have no guide flanges.",
                                          where)));
}

RecordSpec bearing_type() {
  return record(
      "3.2", "Program options 1: bearing type and imperfections", "true",
      {choice("kUnit", {{"1", "SI"}, {"2", "English"}},
              "Unit system of all dimensional values in the deck and in the output files."),
       choice("kBrg",
              {{"1", "ball"},
               {"2", "cylindrical roller"},
               {"3", "spherical roller, one radially loaded row"},
               {"4", "tapered roller"},
               {"5", "spherical tapered roller"}},
              "Bearing type. It determines which geometry record (5A to 5E) follows."),
       integer("nRe", between(1, 10000),
               "Number of rolling elements. It may exceed 40, the limit of the classic program. "
               "Some classic file formats have space for at most 88 elements."),
       counted("nCseg", between(0, 1000),
               {{"0", "no cage"}, {"1", "one-piece cage"}, {"n", "cage cut into n equal segments"}},
               "Number of cage segments. 0 is no cage, 1 is a one-piece cage, and n is a cage cut "
               "into n equal segments.",
               "1"),
       choice("kRaceFlex", {{"0", "rigid"}, {"1", "flexible (not available)"}},
              "Flexibility of the outer race. Only rigid races can be simulated.", "0"),
       choice("kReGeoImp",
              {{"0", "ideal"},
               {"1", "random, normally distributed"},
               {"2", "diameters listed one by one"},
               {"3", "user routine ADRX8"}},
              "Geometry errors of the rolling elements. A list of diameters always has 40 values."),
       race_imperfection(1, "outer"), race_imperfection(2, "inner"),
       flange(1, 1, "outer race, negative"), flange(2, 1, "outer race, positive"),
       flange(1, 2, "inner race, negative"), flange(2, 2, "inner race, positive")});
}

VariableSpec static_constraint(std::string_view name, std::string_view direction, bool rotation) {
  if (rotation)
    return choice(name, {{"0", "moment given"}, {"1", "misalignment given"}},
                  intern_string(fmt::format(
                      "Moment or misalignment {} as input to the static solution.", direction)));
  return choice(name, {{"0", "force given"}, {"1", "displacement given"}},
                intern_string(fmt::format(
                    "Force or displacement {} as input to the static solution.", direction)));
}

VariableSpec material(std::string_view name, std::string_view default_material,
                      std::string_view given, std::string_view part) {
  return with_option_table(
      choice(name, {{"0", default_material}, {"1", given}, {"2", "user routine ADRX0"}},
             intern_string(
                 fmt::format("Material of the {}. 0 is the default material, and 1 takes the "
                             "properties from the deck. The material table lists the other codes.",
                             part)),
             "0"),
      "@materials");
}

RecordSpec statics_and_materials() {
  return record(
      "3.3", "Program options 2: static constraints and materials", "true",
      {static_constraint("kFS1", "along x (bearing axis, thrust normally positive)", false),
       static_constraint("kFS2", "along y", false),
       static_constraint("kFS3", "along z (usual radial load axis)", false),
       static_constraint("kFS4", "about y", true), static_constraint("kFS5", "about z", true),
       choice("kAngVel",
              {{"0", "least frictional heat"},
               {"1", "race control"},
               {"2", "spin axis direction from record 9.0"}},
              "Rule for the spin axis of balls in the static solution. Race control suits fast "
              "bearings. Least frictional heat suits slow bearings. Codes 0 and 1 are not used for "
              "balls in friction equilibrium (run option ballFriction)."),
       counted("kStif", between(0, 10000), {{"0", "none"}, {"n", "number of speed points"}},
               "Number of speeds in the table of stiffness against speed. 0 means no table."),
       with_option_table(
           choice("kChrn", {}, "Medium that causes churning drag on rolling elements and cage."),
           "@churning"),
       material("kReMat", "AISI 52100 steel", "record 8.1", "rolling elements"),
       material("kRaceMat1", "AISI 52100 steel", "record 8.2.1", "outer race"),
       material("kRaceMat2", "AISI 52100 steel", "record 8.2.2", "inner race"),
       material("kHsngMat", "mild steel", "housing record 8.4", "housing"),
       material("kShftMat", "mild steel", "shaft record 8.3", "shaft"),
       choice("kLifeCons", {{"0", "built-in constants"}, {"1", "records 8.6.0 to 8.6.3"}},
              "Source of the constants of the fatigue life models.", "0")});
}

RecordSpec time_variation() {
  return record(
      "3.4", "Program options 3: time variation, inertia, monitored bodies", "mode >= 0",
      {choice("kVarLoad",
              {{"0", "steady"},
               {"1", "rotating load from orbiting races (record 9.3A)"},
               {"2", "sinusoidal race motion (record 9.3B)"}},
              "Variation of loads over time."),
       choice("kVarSpeed",
              {{"0", "steady"},
               {"1", "constant acceleration in a time window (record 9.4A)"},
               {"2", "sinusoidal (record 9.4B)"}},
              "Variation of race speeds over time."),
       choice("kRotFrame",
              {{"0", "base frame fixed in space"}, {"1", "base frame orbits (record 9.5)"}},
              "Orbital motion of the whole bearing, as in a planetary gear.", "0"),
       choice("kReIP",
              {{"0", "from ideal geometry"},
               {"1", "record 6.1 for element 1 only"},
               {"2", "record 6.1 for all elements"},
               {"3", "user routine ADRX8"}},
              "Source of mass and inertia of the rolling elements.", "0"),
       choice("kRaceIP1", {{"0", "from ideal geometry"}, {"1", "record 6.2.1"}},
              "Source of mass and inertia of the outer race. It is needed only if that race is "
              "free to move.",
              "0"),
       choice("kRaceIP2", {{"0", "from ideal geometry"}, {"1", "record 6.2.2"}},
              "Source of mass and inertia of the inner race. It is needed only if that race is "
              "free to move.",
              "0"),
       integer("kNumPltElem", between(0, 12000),
               "Number of bodies whose motion is stored for plots. The classic files SOL1 to SOL6 "
               "contain at most six bodies."),
       array(integer("kPltElemInd", between(1, 12000),
                     "Numbers of the bodies whose motion is stored, in increasing order. 1 to nRe "
                     "are rolling elements. The nCseg cage segments, the outer race and the inner "
                     "race follow."),
             "kNumPltElem")});
}

RecordSpec thermal_options() {
  return record("3.5", "Thermal options", "kTherm > 0",
                {with_option_table(
                     choice("kCoolant", {},
                            "Coolant that carries the heat away. 0 means no circulating coolant."),
                     "@coolants"),
                 choice("kBaseTemp",
                        {{"0", "outer race at housing interface"},
                         {"1", "housing outer diameter"},
                         {"2", "coolant outlet"},
                         {"3", "coolant inlet"},
                         {"4", "inner race at shaft interface"},
                         {"5", "shaft bore"}},
                        "Location of the reference temperature baseTemp (record 9.7)."),
                 choice("kHTC", {{"0", "computed"}, {"1", "given on record 9.7"}},
                        "Source of the convection coefficients of rolling elements and cage."),
                 choice("kGeoMod",
                        {{"0", "geometry not updated"},
                         {"1", "geometry updated at each thermal step"},
                         {"n", "geometry updated at every n-th thermal step"}},
                        "Interval between updates of the geometry for thermal expansion."),
                 choice("kMatPropMod",
                        {{"0", "constant properties"},
                         {"1", "temperature-dependent properties, updated before the geometry"}},
                        "Temperature dependence of the material properties.")});
}

}  // namespace

void add_control_records(std::vector<RecordSpec>& out) {
  for (RecordSpec (*make)() :
       {run_mode, step_control, race_constraints, file_names, run_identification, bearing_type,
        statics_and_materials, time_variation, thermal_options})
    out.push_back(make());
}

}  // namespace adore::deck
