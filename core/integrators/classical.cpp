#include "integrators/tableau.hpp"

namespace adore::integrators {
namespace {

constexpr Tableau kClassical = {4,
                                5,
                                {0.0, 1.0 / 2.0, 1.0 / 2.0, 1.0, 1.0},
                                {{{},
                                  {1.0 / 2.0},
                                  {0.0, 1.0 / 2.0},
                                  {0.0, 0.0, 1.0},
                                  {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0}}},
                                {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0, 0.0},
                                {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 0.0, 1.0 / 6.0},
                                true,
                                3};

}  // namespace

const Tableau& classical() { return kClassical; }

}  // namespace adore::integrators
