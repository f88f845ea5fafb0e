#pragma once

#include "bearing/life_inputs.hpp"
#include "bearing/thermal_inputs.hpp"
#include "deck/deck.hpp"
#include "scene/system_options.hpp"
#include "setup/build_imperfections.hpp"
#include "statics/roller_statics.hpp"
#include "statics/stiffness_table.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// How long, how finely and with what output a deck wants to be run.
namespace adore::setup {

enum class StartState : unsigned char {
  Statics,    ///< kIcOpt 0
  FromFinal,  ///< kIcOpt -1: state of FINAL, new files, time zero
  Continue    ///< kIcOpt 1: append to the files of MASTER (N3)
};

/// Record 1, 2.1, 2.3 and 3.4 as named values; step sizes and end time stay dimensionless until the
/// time scale is known.
struct RunControl {
  bool dynamic = false;  ///< mode >= 0
  StartState start = StartState::Statics;
  int print_option = 0, print_every = 0, plot_every = 0, animate_every = 0,
      life_every = 0;    ///< 0: first and last step only
  bool animate = false;  ///< kAGraf > 0
  long max_steps = 0;
  int substeps = 1;
  std::string integrator;  ///< name for integrators::make_stepper
  double step_initial = 0.0, step_minimum = 0.0, step_maximum = 0.0,
         end_time = 0.0;  ///< over the time scale
  double tolerance = 1e-6;
  double light_load_ratio = 0.0;                       ///< qFac, 0 when off
  std::optional<statics::StiffnessRequest> stiffness;  ///< kStif > 0
  std::vector<int>
      monitored;  ///< element numbers of SOL1..SOL6 (1..n elements, cage, outer, inner)
  std::string master_file = "MASTER", final_file = "FINAL";
  std::array<std::string, 8> sol_files{"SOL1", "SOL2", "SOL3", "SOL4",
                                       "SOL5", "SOL6", "SOL7", "SOL8"};
};

/// @throws InputError
[[nodiscard]] RunControl build_run_control(const deck::Deck& deck);

/// Options that are not in the deck: names with defaults (`--opt name=value`, or ADORE.json in the
/// folder of the deck).
struct RunOptions {
  scene::SystemOptions system;
  statics::RollerOptions rollers;
  double checkpoint_seconds = 10.0;   ///< wall time between checkpoints of FINAL and MASTER
  bool results_h5 = true;             ///< write RESULTS.h5
  std::uint64_t seed = kDefaultSeed;  ///< of random imperfections (kReGeoImp 1)
  bool direct_strips = false;         ///< visco-elastic films without a surface
  bool single_films = true;           ///< films by floats where that is enough
  bool recommended_law = false;       ///< traction by the recommended law of the oil
  bool stress_limit = true;           ///< films have their limiting shear stress
  std::optional<double> user_limit;   ///< limiting stress over pressure of the user's lubricant
  double user_softening = 0.003;      ///< its fall with temperature [1/K]
  bool centrifugal_growth = true;     ///< speeds widen the rings (bearing::Mounting)
  bearing::ThermalModel thermal_model = bearing::ThermalModel::Network;
  bearing::Surroundings surroundings;    ///< of the thermal network
  bool thermal_base = true;              ///< the place of kBaseTemp is held at baseTemp
  bool thermal_transient = false;        ///< heat capacities act
  double thermal_acceleration = 1.0;     ///< thermal over mechanical time of a motion
  bearing::LifeChoices life;             ///< fatigue life: what no record holds
  std::vector<std::string> effects_off;  ///< names of the plan's effects that are left out
  bool user_process = false;             ///< a plug-in of --user runs in a separate process
  double user_timeout = 10.0;            ///< after which a call of it there counts as hanging [s]
  int user_sample = 1024;                ///< one in this many calls is repeated; 0: none
};

struct OptionInfo {
  std::string name, default_value, meaning;
};

/// All options with their defaults, in a fixed order: listed by RUN.json, `adore run --help` and
/// the forms.
[[nodiscard]] std::vector<OptionInfo> run_option_list();

/// @throws InputError naming the valid options, or the value that is expected.
[[nodiscard]] RunOptions build_run_options(const std::map<std::string, std::string>& values);

}  // namespace adore::setup
