#include "core/integrators/problems.hpp"

#include <catch2/catch.hpp>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0};
}

// Out of line: the compiler would otherwise see free() meet operator new and warn.
__attribute__((noinline)) void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size ? size : 1)) return p;
  throw std::bad_alloc();
}
__attribute__((noinline)) void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size ? size : 1);
}
__attribute__((noinline)) void operator delete(void* p) noexcept { std::free(p); }
__attribute__((noinline)) void operator delete(void* p, std::size_t) noexcept { std::free(p); }

using namespace adore::integrators;
using namespace adore::test;

namespace {

bool ours(std::string_view name) { return name.starts_with("rk") || name.starts_with("pece"); }

std::string failure_of(Stepper& stepper, double t_end) {
  try {
    run_to(stepper, t_end);
  } catch (const StepFailure& failure) {
    return failure.what();
  }
  return "no failure";
}

/// f with the same function as its stiff part, so that every method can take it.
Problem all_methods(int size, int controlled, const Problem::Function& f) {
  Problem problem(size, controlled, f);
  problem.stiff = f;
  return problem;
}

}  // namespace

TEST_CASE("Integrators: found by name and by intMet code", "[unit][integrators]") {
  REQUIRE(stepper_names().size() == 21);
  for (const auto name : stepper_names()) CHECK(make_stepper(name)->name() == name);
  CHECK(name_of_int_met(1) == "rkf1");
  CHECK(name_of_int_met(7) == "rkf7");
  CHECK(name_of_int_met(41) == "rk4");
  CHECK(name_of_int_met(11) == "pece1");
  CHECK(name_of_int_met(18) == "pece8");
  CHECK(name_of_int_met(21) == "cvode-adams");
  CHECK(name_of_int_met(22) == "cvode-bdf");
  CHECK(name_of_int_met(31) == "arkode-erk");
  CHECK(name_of_int_met(32) == "arkode-dirk");
  CHECK(name_of_int_met(33) == "arkode-imex");
  for (const int bad : {-1, 0, 8, 9, 10, 19, 20, 23, 30, 34}) CHECK(name_of_int_met(bad).empty());
  CHECK_THROWS_AS(make_stepper("rk45"), std::invalid_argument);
  CHECK_THROWS_WITH(make_stepper("rk45"), Catch::Contains("\"rk45\"") &&
                                              Catch::Contains("rkf7, pece1") &&
                                              Catch::Contains("arkode-imex"));
}

TEST_CASE("Step control: contradictory settings → error message", "[unit][integrators]") {
  Problem problem = kepler();
  const auto y0 = kepler_exact(0.0);
  const StepControl bad[] = {{.maximum = 0.0},
                             {.minimum = 2.0, .maximum = 1.0},
                             {.minimum = -1.0, .maximum = 1.0},
                             {.maximum = 1.0, .tolerance = 0.0},
                             {.initial = std::nan(""), .maximum = 1.0}};
  for (const auto name : stepper_names()) {
    const auto stepper = make_stepper(name);
    for (const auto& control : bad) {
      CHECK_THROWS_AS(stepper->start(problem, 0.0, y0, control), std::invalid_argument);
    }
    const std::vector<double> too_short{1.0};
    CHECK_THROWS_AS(stepper->start(problem, 0.0, too_short, {.maximum = 1.0}),
                    std::invalid_argument);
    stepper->start(problem, 0.0, y0, {.maximum = 1.0});
    CHECK_THROWS_AS(stepper->step(0.0), std::invalid_argument);
  }
}

TEST_CASE("Step control: narrow pulse and fast prescribed motion → not stepped over",
          "[physics][integrators]") {
  // y' = pulse of unit area and width 0.01 at t = 5, plus cos(40 t).
  const double begin = 5.0, width = 0.01, rate = 40.0;
  Problem problem = all_methods(1, 1, [&](double t, const double*, double* f) {
    const double x = (t - begin) / width;
    const double s = std::sin(M_PI * x);
    f[0] = (x > 0.0 && x < 1.0 ? 2.0 / width * s * s : 0.0) + std::cos(rate * t);
    return EvalStatus::Ok;
  });
  problem.guard = [&](double t) {
    double guard = 0.25 / rate;
    if (t < begin) guard = std::min(guard, std::max(begin - t, 0.1 * width));
    if (t >= begin && t < begin + width) guard = 0.1 * width;
    return guard;
  };
  const std::vector<double> y0{0.0};
  const double exact = 1.0 + std::sin(rate * 8.0) / rate;
  for (const auto name : stepper_names()) {
    const auto stepper = make_stepper(name);
    stepper->start(problem, 0.0, y0, {.maximum = 1.0, .tolerance = 1e-5});
    double longest = 0.0;
    while (stepper->time() < 8.0) longest = std::max(longest, stepper->step(8.0).h);
    INFO(name << ": " << stepper->state()[0] << ", exact " << exact);
    CHECK(longest <= 0.25 / rate * (1.0 + 1e-6));
    // Some 1400 steps of 1e-5 at most; the low orders use up more of that than the others.
    CHECK(std::abs(stepper->state()[0] - exact) < (stepper->order() == 1 ? 1.4e-2 : 2e-3));
  }
  // Without the guard no estimate knows of a pulse between its nodes: what the guard is for.
  Problem pulse(1, 1, [&](double t, const double*, double* f) {
    f[0] = t > begin && t < begin + width ? 1.0 / width : 0.0;
    return EvalStatus::Ok;
  });
  const auto blind = make_stepper("rkf7");
  blind->start(pulse, 0.0, y0, {.maximum = 1.0, .tolerance = 1e-5});
  run_to(*blind, 8.0);
  CHECK(blind->state()[0] == 0.0);
}

TEST_CASE("Step control: pairs blind to quadratures notice a contact late in the step",
          "[physics][integrators]") {
  // Free flight, then a stiff wall: only stages at the end of the step touch it, and the classical
  // estimate is exactly 0.
  Problem problem = bouncing_mass();
  for (const auto name : {"rkf5", "rkf6", "rkf7"}) {
    const auto stepper = make_stepper(name);
    // The wall is touched 1.5 % before the end of the first step.
    const double touch = std::sqrt(2.0);
    stepper->start(problem, 0.0, std::vector<double>{1.0, 0.0, 0.0},
                   {.initial = 1.015 * touch, .maximum = 1.015 * touch, .tolerance = 1e-6});
    const StepInfo first = stepper->step(10.0);
    INFO(name);
    CHECK(first.h < touch);
    CHECK(stepper->counters().rejected > 0);
  }
}

TEST_CASE("Step control: pure quadratures → resolved by the blind pairs too",
          "[physics][integrators]") {
  Problem problem(1, 1, [](double t, const double*, double* f) {
    f[0] = std::cos(40.0 * t);
    return EvalStatus::Ok;
  });
  for (const auto name : {"rkf5", "rkf6", "rkf7"}) {
    const auto stepper = make_stepper(name);
    stepper->start(problem, 0.0, std::vector<double>{0.0}, {.maximum = 1.0, .tolerance = 1e-7});
    const long steps = run_to(*stepper, 3.0);
    INFO(name << ": " << steps);
    CHECK(std::abs(stepper->state()[0] - std::sin(120.0) / 40.0) < 1e-7 * steps);
    CHECK(steps < 600);
  }
}

TEST_CASE("Step control: steps of the minimum size → accepted with any error, and counted",
          "[unit][integrators]") {
  Problem problem = kepler();
  const auto y0 = kepler_exact(0.0);
  for (const auto name : stepper_names()) {
    const auto stepper = make_stepper(name);
    INFO(name);
    stepper->start(problem, 0.0, y0,
                   {.initial = 0.2, .minimum = 0.1, .maximum = 0.5, .tolerance = 1e-12});
    long counted = 0;
    while (stepper->time() < 2.0) {
      const StepInfo info = stepper->step(2.0);
      CHECK((info.error <= 1.0 || info.at_minimum));
      if (info.at_minimum) {
        ++counted;
        CHECK(info.error > 1.0);
        CHECK(info.h <= 0.1 * (1.0 + 1e-6));
      }
      CHECK(info.h_next >= 0.1);
    }
    CHECK(counted >= 5);
    CHECK(stepper->counters().at_minimum == counted);
    // Order 1 (CVODE falls back to it) makes nothing of h = 0.1, but goes on.
    const bool first_order = stepper->order() == 1 || name.starts_with("cvode");
    CHECK(distance(stepper->state(), kepler_exact(2.0)) < (first_order ? 5.0 : 0.1));
  }
}

TEST_CASE("Stop times: hit exactly, never passed, no effect on the next step",
          "[unit][integrators]") {
  Problem problem = kepler();
  const auto y0 = kepler_exact(0.0);
  const double stops[] = {0.1, 0.1000001, 0.37, 1.0 / 3.0 + 0.1, 1.1, 2.0, 2.0 + 1e-9, 3.0};
  for (const auto name : stepper_names()) {
    const auto stepper = make_stepper(name);
    INFO(name);
    stepper->start(problem, 0.0, y0, {.maximum = 0.2, .tolerance = 1e-7});
    for (const double stop : stops) {
      problem.last_t = -1.0;
      run_to(*stepper, stop);
      CHECK(stepper->time() == stop);
      CHECK(problem.last_t <= stop * (1.0 + 1e-15));  // rounding of t + c h
    }
    const double tight = ours(name) ? 1e-4 : 1e-3;
    CHECK(distance(stepper->state(), kepler_exact(3.0)) < (stepper->order() == 1 ? 5e-3 : tight));
    if (!ours(name)) continue;
    // A step cut to a sliver leaves the proposal as it was.
    const double proposal = stepper->step(4.0).h_next;
    const StepInfo sliver = stepper->step(stepper->time() + 1e-7 * proposal);
    CHECK(sliver.h <= 1.1e-7 * proposal);
    CHECK(sliver.h_next >= 0.99 * proposal);
    CHECK(stepper->step(6.0).h > 0.3 * proposal);
  }
}

TEST_CASE("Constant step: kept to the last bit, or rejected by name", "[unit][integrators]") {
  Problem problem = kepler();
  const auto y0 = kepler_exact(0.0);
  const StepControl control{.initial = 0.0, .minimum = 0.1, .maximum = 0.1, .tolerance = 1e-3};
  for (const auto name : stepper_names()) {
    const auto stepper = make_stepper(name);
    INFO(name);
    CHECK(stepper->can_hold_constant_step() == !name.starts_with("cvode"));
    if (!stepper->can_hold_constant_step()) {
      CHECK_THROWS_WITH(stepper->start(problem, 0.0, y0, control),
                        Catch::Contains(std::string(name)) && Catch::Contains("constant step"));
      continue;
    }
    stepper->start(problem, 0.0, y0, control);
    for (int i = 1; i <= 200; ++i) {
      const StepInfo info = stepper->step(100.0);
      // ARKODE forms the step from differences of times.
      CHECK(std::abs(info.h - 0.1) < (ours(name) ? 1e-300 : 1e-13));
      CHECK(stepper->time() == Approx(0.1 * i).epsilon(1e-13));
    }
    CHECK(stepper->counters().steps == 200);
    CHECK(stepper->counters().rejected == 0);
  }
}

TEST_CASE("State that is not finite → run ends with time, step and component",
          "[unit][integrators]") {
  Problem problem = all_methods(3, 3, [](double t, const double* y, double* f) {
    f[0] = -y[0];
    f[1] = y[0];
    f[2] = t > 0.5 ? std::sqrt(-1.0 - y[0] * y[0]) : 0.0;
    return EvalStatus::Ok;
  });
  const std::vector<double> y0{1.0, 0.0, 0.0};
  for (const auto name : stepper_names()) {
    const auto stepper = make_stepper(name);
    stepper->start(problem, 0.0, y0, {.minimum = 1e-6, .maximum = 0.1, .tolerance = 1e-4});
    const std::string text = failure_of(*stepper, 2.0);
    INFO(text);
    CHECK(text.find(name) == 0);
    CHECK_THAT(text, Catch::Contains("not finite") && Catch::Contains("quantity<2>") &&
                         Catch::Contains("t = 0.") && Catch::Contains("with step"));
    CHECK(stepper->time() == Approx(0.5).margin(0.1));
    const std::vector<double> nan{1.0, std::nan(""), 0.0};
    CHECK_THROWS_WITH(stepper->start(problem, 0.0, nan, {.maximum = 0.1}),
                      Catch::Contains("quantity<1>"));
  }
}

TEST_CASE("Retry: smaller step, and a diagnosis when no step is small enough",
          "[unit][integrators]") {
  // The solution decays and stays positive; a step that is too long asks beyond zero.
  int retries = 0;
  int failures = 0;
  Problem problem = all_methods(1, 1, [&](double, const double* y, double* f) {
    if (y[0] < -0.01) {
      ++retries;
      return EvalStatus::Retry;
    }
    f[0] = -100.0 * y[0];
    return EvalStatus::Ok;
  });
  Problem wall = all_methods(1, 1, [](double t, const double*, double* f) {
    f[0] = 1.0;
    return t > 0.5 ? EvalStatus::Retry : EvalStatus::Ok;
  });
  Problem broken = all_methods(1, 1, [&](double t, const double*, double* f) {
    f[0] = 1.0;
    failures += t > 0.5;
    return t > 0.5 ? EvalStatus::Fail : EvalStatus::Ok;
  });
  const std::vector<double> y0{1.0};
  for (const auto name : stepper_names()) {
    const auto stepper = make_stepper(name);
    retries = failures = 0;
    stepper->start(problem, 0.0, y0, {.initial = 0.1, .maximum = 0.1, .tolerance = 1e-5});
    run_to(*stepper, 0.1);
    INFO(name << ": " << stepper->state()[0]);
    CHECK(std::abs(stepper->state()[0] - std::exp(-10.0)) < 1e-2);
    CHECK(retries > 0);

    stepper->start(wall, 0.0, y0, {.maximum = 0.1, .tolerance = 1e-5});
    CHECK_THAT(failure_of(*stepper, 2.0), Catch::Contains("not valid"));
    stepper->start(broken, 0.0, y0, {.maximum = 0.1, .tolerance = 1e-5});
    CHECK_THAT(failure_of(*stepper, 2.0), Catch::Contains("could not be evaluated"));
    CHECK(failures == 1);  // no second try
    CHECK_THROWS_AS(stepper->start(wall, 1.0, y0, {.maximum = 0.1}), StepFailure);
  }
}

TEST_CASE("Methods of this program: no allocation after the start", "[unit][integrators]") {
  Problem problem = bouncing_mass();
  const std::vector<double> y0{1.0, 0.0, 0.0};
  for (const auto name : stepper_names()) {
    if (!ours(name)) continue;
    const auto stepper = make_stepper(name);
    stepper->start(problem, 0.0, y0, {.maximum = 0.1, .tolerance = 1e-6});
    const long before = allocations;
    for (int i = 0; i < 300; ++i) stepper->step(1e3);
    CHECK(allocations - before == 0);
  }
}

TEST_CASE("Quadratures: no influence on the steps", "[unit][integrators]") {
  // The same mass with and without quadratures that no step could resolve.
  Problem plain = bouncing_mass();
  const auto wild = [&plain](double t, const double* y, double* f) {
    double three[3];
    plain.rhs(t, y, three);
    f[0] = three[0];
    f[1] = three[1];
    f[2] = 1e9 * std::sin(1e7 * t);
    f[3] = y[0] > 0.5 ? 1e12 : 0.0;
    return EvalStatus::Ok;
  };
  Problem loaded(4, 2, wild);
  loaded.stiff = [&plain](double t, const double* y, double* f) {
    double three[3];
    plain.rhs_stiff(t, y, three);
    std::copy(three, three + 3, f);
    f[3] = 0.0;
    return EvalStatus::Ok;
  };
  for (const auto name : stepper_names()) {
    const auto a = make_stepper(name);
    const auto b = make_stepper(name);
    a->start(plain, 0.0, std::vector<double>{1.0, 0.0, 0.0}, {.maximum = 0.1, .tolerance = 1e-5});
    b->start(loaded, 0.0, std::vector<double>(4, 1.0), {.maximum = 0.1, .tolerance = 1e-5});
    b->start(loaded, 0.0, std::vector<double>{1.0, 0.0, 0.0, 0.0},
             {.maximum = 0.1, .tolerance = 1e-5});
    int different = 0;
    for (int i = 0; i < 200; ++i) different += a->step(1e3).t != b->step(1e3).t;
    INFO(name);
    CHECK(different == 0);
    CHECK(a->state()[0] == b->state()[0]);
  }
}

TEST_CASE("Projection: returned states are projected, with the matching derivative",
          "[unit][integrators]") {
  Problem problem = rotation();
  const auto y0 = rotation_exact(0.0);
  for (const auto name : stepper_names()) {
    const auto stepper = make_stepper(name);
    stepper->start(problem, 0.0, y0, {.maximum = 0.5, .tolerance = 1e-6});
    double worst = 0.0;
    double mismatch = 0.0;
    while (stepper->time() < 200.0) {
      stepper->step(200.0);
      const auto q = stepper->state();
      worst =
          std::max(worst, std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1.0));
      double f[4];
      problem.rhs(stepper->time(), q.data(), f);
      for (int i = 0; i < 4; ++i)
        mismatch = std::max(mismatch, std::abs(f[i] - stepper->derivative()[i]));
    }
    const auto& c = stepper->counters();
    INFO(name << ": " << c.steps << " steps, " << c.restarts << " restarts");
    CHECK(worst < 1e-15);
    CHECK(mismatch == 0.0);
    // Renormalising is no reason to begin again: never for our own methods and ARKODE, seldom for
    // CVODE.
    CHECK(c.restarts <= (name.starts_with("cvode") ? c.steps / 10 : 0));
    // The errors of all steps may add up.
    CHECK(distance(stepper->state(), rotation_exact(200.0)) < 2e-6 * c.steps);
  }
}

TEST_CASE("Projection: reaches the state with which the method continues",
          "[physics][integrators]") {
  // A point on the unit circle whose radius would grow without the projection, and whose speed
  // follows the radius.
  Problem problem = all_methods(2, 2, [](double, const double* y, double* f) {
    const double r2 = y[0] * y[0] + y[1] * y[1];
    f[0] = 0.1 * y[0] - r2 * y[1];
    f[1] = 0.1 * y[1] + r2 * y[0];
    return EvalStatus::Ok;
  });
  problem.projection = [](double, double* y) {
    const double r = std::hypot(y[0], y[1]);
    y[0] /= r;
    y[1] /= r;
    return true;
  };
  for (const auto name : stepper_names()) {
    const auto stepper = make_stepper(name);
    stepper->start(problem, 0.0, std::vector<double>{1.0, 0.0},
                   {.maximum = 1e-3, .tolerance = 1e-6});
    run_to(*stepper, 3.0);
    INFO(name << ": " << stepper->counters().restarts << " restarts");
    // The radius lags by half a step of 1e-3 at most: an angle of 3 · 0.1 · 1e-3; CVODE by ten
    // tolerances more.
    CHECK(std::abs(stepper->state()[0] - std::cos(3.0)) < 1e-3);
    CHECK((stepper->counters().restarts > 0) == name.starts_with("cvode"));
  }
}

TEST_CASE("Implicit-explicit method: missing stiff part → error message", "[unit][integrators]") {
  Problem problem = kepler();
  problem.stiff = nullptr;
  const auto stepper = make_stepper("arkode-imex");
  CHECK_THROWS_AS(stepper->start(problem, 0.0, kepler_exact(0.0), {.maximum = 0.1}), StepFailure);
  CHECK_THROWS_WITH(stepper->start(problem, 0.0, kepler_exact(0.0), {.maximum = 0.1}),
                    Catch::Contains("stiff part") && Catch::Contains("arkode-dirk"));
}

TEST_CASE("Implicit methods: long steps over a stiff decay", "[physics][integrators]") {
  // y' = -1e5 (y - cos t): explicit methods need some 1e5 steps for t = 2, stiff ones some
  // hundreds.
  Problem problem = all_methods(2, 1, [](double t, const double* y, double* f) {
    f[0] = -1e5 * (y[0] - std::cos(t));
    f[1] = y[0];
    return EvalStatus::Ok;
  });
  for (const auto name : {"cvode-bdf", "arkode-dirk", "arkode-imex"}) {
    const auto stepper = make_stepper(name);
    stepper->start(problem, 0.0, std::vector<double>{0.0, 0.0},
                   {.maximum = 0.5, .tolerance = 1e-6});
    run_to(*stepper, 2.0);
    INFO(name << ": " << stepper->counters().steps);
    CHECK(stepper->counters().steps < 500);
    CHECK(stepper->counters().jacobians > 0);
    CHECK(stepper->counters().nonlinear_iterations > 0);
    CHECK(std::abs(stepper->state()[0] - std::cos(2.0)) < 2e-5);
    // The boundary layer of 1e-5 s costs the quadrature 1e-5.
    CHECK(std::abs(stepper->state()[1] - (std::sin(2.0) - 1e-5)) < 1e-4);
  }
}

TEST_CASE("Newton's error: below that of the step when a step cap makes that small",
          "[physics][integrators]") {
  // Ten orbits in steps whose own error is far below the tolerance: no tolerance decides any more.
  for (const char* name : {"arkode-dirk", "arkode-imex"})
    for (const double tolerance : {1e-4, 1e-6}) {
      Problem problem = kepler();
      const auto stepper = make_stepper(name);
      stepper->start(problem, 0.0, kepler_exact(0.0), {.maximum = 0.02, .tolerance = tolerance});
      run_to(*stepper, 62.8);
      const std::vector<double> exact = kepler_exact(62.8);
      double error = 0.0;
      for (std::size_t i = 0; i < exact.size(); ++i)
        error = std::max(error, std::abs(stepper->state()[i] - exact[i]));
      INFO(name << " at " << tolerance << ": " << error << " off, "
                << stepper->counters().evaluations << " evaluations");
      CHECK(error < 1e-6);
    }
}

TEST_CASE("Stepper: restart from any state → like a new one", "[unit][integrators]") {
  Problem first = kepler();
  Problem second = bouncing_mass();
  for (const auto name : stepper_names()) {
    const auto used = make_stepper(name);
    const auto fresh = make_stepper(name);
    used->start(first, 0.0, kepler_exact(0.0), {.maximum = 0.1, .tolerance = 1e-6});
    for (int i = 0; i < 30; ++i) used->step(10.0);
    const std::vector<double> y0{1.0, 0.0, 0.0};
    for (auto* s : {used.get(), fresh.get()}) {
      s->start(second, 0.0, y0, {.maximum = 0.1, .tolerance = 1e-6});
      run_to(*s, 2.0);
    }
    INFO(name);
    CHECK(used->state()[0] == fresh->state()[0]);
    CHECK(used->counters().steps == fresh->counters().steps);
    CHECK(used->counters().evaluations == fresh->counters().evaluations);
  }
}

TEST_CASE("Step cap: no more steps than the span needs, and none exceeds it",
          "[unit][integrators]") {
  // A slow motion that every method would take in longer steps.
  Problem problem(1, 1, [](double t, const double*, double* d) {
    d[0] = std::cos(t);
    return EvalStatus::Ok;
  });
  const double cap = 0.01;
  for (const auto name : stepper_names()) {
    if (name == "arkode-imex") continue;  // needs a split
    const auto stepper = make_stepper(name);
    stepper->start(problem, 0.0, std::vector<double>{0.0},
                   {.initial = cap, .maximum = cap, .tolerance = 1e-2});
    double longest = 0.0;
    while (stepper->time() < 1.0) longest = std::max(longest, stepper->step(1.0).h);
    INFO(name << ": " << stepper->counters().steps << " steps, the longest " << longest);
    CHECK(longest <= cap * (1.0 + 2e-6));
    CHECK(stepper->counters().steps < 115);
  }
}

TEST_CASE("Variable-order method: order limited as specified", "[unit][integrators]") {
  Problem problem(2, 2, [](double, const double* y, double* d) {
    d[0] = y[1];
    d[1] = -y[0];
    return EvalStatus::Ok;
  });
  for (const char* name : {"cvode-adams", "cvode-bdf"}) {
    long steps[2] = {0, 0};
    for (const int order : {1, 0}) {
      const auto stepper = make_stepper(name);
      stepper->start(problem, 0.0, std::vector<double>{1.0, 0.0},
                     {.maximum = 1.0, .tolerance = 1e-5, .highest_order = order});
      while (stepper->time() < 3.0) (void)stepper->step(3.0);
      steps[order] = stepper->counters().steps;
    }
    INFO(name << ": " << steps[1] << " steps of order 1, " << steps[0] << " of any");
    CHECK(steps[1] > 3 * steps[0]);
  }
}

TEST_CASE("Error scales: their sign has no effect", "[unit][integrators]") {
  class Signed final : public OdeSystem {
   public:
    explicit Signed(double sign) : scales_{sign, sign * 2.0} {}
    [[nodiscard]] int size() const noexcept override { return 2; }
    [[nodiscard]] int controlled_size() const noexcept override { return 2; }
    [[nodiscard]] std::span<const double> scales() const noexcept override { return scales_; }
    EvalStatus rhs(double, const double* y, double* d) noexcept override {
      d[0] = y[1];
      d[1] = -y[0];
      return EvalStatus::Ok;
    }

   private:
    std::array<double, 2> scales_;
  };
  for (const auto name : stepper_names()) {
    if (name == "arkode-imex") continue;
    std::vector<double> ends[2];
    for (const int k : {0, 1}) {
      Signed system(k == 0 ? 1.0 : -1.0);
      const auto stepper = make_stepper(name);
      stepper->start(system, 0.0, std::vector<double>{1.0, 0.0},
                     {.maximum = 1.0, .tolerance = 1e-6});
      for (int i = 0; i < 20; ++i) (void)stepper->step(50.0);
      ends[k].assign(stepper->state().begin(), stepper->state().end());
      ends[k].push_back(stepper->time());
    }
    INFO(name);
    CHECK(ends[0] == ends[1]);
  }
}

TEST_CASE("Resumed stepper: continues bit for bit, or reports its losses", "[unit][integrators]") {
  Problem orbit = kepler(), spin = rotation(), bounce = bouncing_mass();
  struct Case {
    Problem* problem;
    std::vector<double> y0;
  };
  const Case cases[] = {
      {&orbit, kepler_exact(0.0)}, {&spin, rotation_exact(0.0)}, {&bounce, {1.0, 0.0, 0.0}}};
  for (const auto name : stepper_names()) {
    for (const Case& c : cases) {
      for (const int steps : {1, 3, 37}) {
        const StepControl control{.maximum = 0.1, .tolerance = 1e-6};
        const auto whole = make_stepper(name);
        whole->start(*c.problem, 0.0, c.y0, control);
        for (int i = 0; i < steps; ++i) whole->step(10.0);
        const double t = whole->time();
        const std::vector<double> y(whole->state().begin(), whole->state().end());
        const Memory memory = whole->memory();
        REQUIRE(memory.at("next step") > 0.0);
        const auto part = make_stepper(name);
        part->resume(*c.problem, t, y, control, memory);
        CHECK(part->time() == t);
        run_to(*whole, 6.0);
        run_to(*part, 6.0);
        INFO(name << " resumed after " << steps << " steps, " << whole->loses());
        double difference = 0.0;
        for (std::size_t i = 0; i < y.size(); ++i)
          difference = std::max(difference, std::abs(whole->state()[i] - part->state()[i]));
        if (whole->loses().empty())
          CHECK(difference == 0.0);
        else
          CHECK(difference < 1e-2);
      }
    }
  }
}
