#pragma once

#include "runs/measured_run.hpp"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

/// Cost and influence of each effect of a scene: the deck's own run over a short span, repeated
/// for every effect without it.
namespace adore::studies {

struct WhatIfRequest : runs::DeckRequest {
  double turns = 2.0;  ///< of the shaft, or the deck's whole run where that is shorter
};

/// Change of a key result, over its value in the deck's own run; not a number where it has none.
struct WhatIfChange {
  double speed = 0.0, load = 0.0, heat = 0.0, life = 0.0;
};

struct WhatIfRow {
  std::string effect;   ///< as the plan names it; more than one where a switch decides them
  std::string without;  ///< how it is left out: "effectsOff=gravity", "nCseg=0"
  std::string failure;  ///< why there is no run without it; empty: there is
  double seconds = 0.0;
  double share = 0.0;   ///< of the deck's own run before and after it, set-up included
  WhatIfChange change;  ///< run without it minus run with it
};

struct WhatIf {
  double turns = 0.0;
  double seconds = 0.0;      ///< of the deck's own run
  double time_spread = 0.0;  ///< largest of two such runs one after the other, over their mean
  WhatIfChange noise;        ///< between runs under loads that differ by a millionth
  results::KeyResults base;
  std::vector<WhatIfRow> rows;
};

/// @param row_done called for each effect as it is done
/// @throws InputError for a quasi-static deck; Interrupted when `stop` asks for it
[[nodiscard]] WhatIf what_if(const WhatIfRequest& request,
                             const std::function<void(const WhatIfRow&)>& row_done,
                             std::stop_token stop);

[[nodiscard]] std::string what_if_text(const WhatIf& result);
[[nodiscard]] nlohmann::ordered_json what_if_json(const WhatIf& result);

}  // namespace adore::studies
