#pragma once

#include "base/errors.hpp"
#include "base/input_limits.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

/// The only reader of foreign JSON. Deep nesting is rejected, because walking,
/// printing and comparing such a value is recursive and would end in the stack.
namespace adore {

namespace detail {
/// "is a deck, not JSON; ...", or "is not valid JSON: ..." in a clause of bounded length.
std::string json_problem(std::string_view text, std::string_view what);
}  // namespace detail

/// @throws InputError "`name` is not valid JSON: ..."; without the name when that is empty.
template <class Json = nlohmann::json>
Json parse_json(std::string_view text, std::string_view name) {
  const std::string start = name.empty() ? std::string() : std::string(name) + " ";
  const typename Json::parser_callback_t shallow = [&](int depth, auto event, Json&) {
    using Event = typename Json::parse_event_t;
    if (depth >= kMaxNesting && (event == Event::object_start || event == Event::array_start))
      throw InputError(start + "is not valid JSON for this program: it is nested more than " +
                       std::to_string(kMaxNesting) + " levels deep");
    return true;
  };
  try {
    return Json::parse(text, shallow);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(start + detail::json_problem(text, error.what()));
  }
}

/// The text of a value, for files and output. Bytes that are not UTF-8 (names of files may have
/// any) become U+FFFD; the library's own dump() would throw.
template <class Json>
std::string dump_json(const Json& value, int indent = -1) {
  return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace adore
