#pragma once

#include <cstdlib>
#include <random>

/// Random walks through a window: a short one of a fixed seed in every test run, a long one of
/// another seed by the environment: ADORE_WALK_ACTIONS=10000 ADORE_WALK_SEED=7.
namespace adore::test {

inline int walk_number(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr && std::atoi(text) > 0 ? std::atoi(text) : otherwise;
}
inline int walk_actions() {
  constexpr int kShort = 1500;
  return walk_number("ADORE_WALK_ACTIONS", kShort);
}
inline std::mt19937 walk_random() {
  constexpr int kSeed = 15;
  return std::mt19937(static_cast<unsigned>(walk_number("ADORE_WALK_SEED", kSeed)));
}

}  // namespace adore::test
