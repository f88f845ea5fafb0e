#pragma once

#include <functional>
#include <string_view>
#include <vector>

/// The grammar of `required_when`: integers, names of earlier scalar variables, == != < <= > >=, in
/// (a,b,..), &&, ||, parentheses, true, max(array), user(). A variable of an absent record counts
/// as 0.
namespace adore::deck {

struct ConditionScope {
  std::function<long long(std::string_view name)> integer;  ///< 0 for an absent variable
  std::function<std::vector<long long>(std::string_view name)>
      array;                 ///< empty for an absent array
  long long user_lines = 0;  ///< value of user()
};

/// @throws InternalError when the expression does not parse (a schema bug; a test evaluates all of
/// them).
bool evaluate(std::string_view condition, const ConditionScope& scope);

/// The variables that a condition asks for, each once.
std::vector<std::string_view> variable_names_in(std::string_view condition);

}  // namespace adore::deck
