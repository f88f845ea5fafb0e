#pragma once

#include <nlohmann/json.hpp>

#include <iterator>
#include <random>
#include <string>
#include <vector>

/// Random changes of JSON values that keep the text valid JSON: what a reader behind the parser has
/// to stand.
namespace adore::testing {

class JsonMutator {
 public:
  using Json = nlohmann::json;
  explicit JsonMutator(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  /// Changes one value somewhere in it.
  void change(Json& value) {
    std::vector<Json*> all;
    collect(value, all);
    Json& one = *all[below(all.size())];
    if (one.is_object() && !one.empty() && below(2) == 0) {
      one.erase(std::next(one.begin(), static_cast<long>(below(one.size()))));
    } else if (one.is_array() && !one.empty() && below(2) == 0) {
      if (below(2) == 0)
        one.erase(one.begin() + static_cast<long>(below(one.size())));
      else
        one.push_back(one.at(below(one.size())));
    } else if (one.is_number() && below(3) == 0) {
      one = one.get<double>() * factors_[below(factors_.size())];
    } else if (one.is_number() && below(4) > 0) {
      one = numbers_[below(numbers_.size())];
    } else {
      one = others_[below(others_.size())];
    }
  }

 private:
  static void collect(Json& value, std::vector<Json*>& out) {
    out.push_back(&value);
    if (value.is_structured())
      for (Json& item : value) collect(item, out);
  }

  std::mt19937 random_;
  std::vector<double> factors_{-1.0, 0.0, 0.5, 2.0, 1e3, 1e-3, 1e12, 1e-12, 1e200, 1e-200};
  std::vector<Json> numbers_{0,
                             1,
                             -1,
                             2,
                             5,
                             7,
                             1000,
                             1000000,
                             -1e9,
                             1e9,
                             1e18,
                             1e308,
                             -1e308,
                             5e-324,
                             0.5,
                             -0.0,
                             1e-300,
                             2.5,
                             1e100,
                             90.0,
                             2147483647,
                             -2147483648LL,
                             4294967296LL,
                             9223372036854775807LL,
                             1e-9,
                             1e6,
                             180.0,
                             3.14159};
  std::vector<Json> others_{nullptr,        true,
                            false,          "",
                            "text",         Json::array(),
                            Json::object(), Json::array({1, 2, 3}),
                            "inner",        "outer",
                            "nan",          Json::array({Json::array({})}),
                            "\xff\xfe",     std::string(300, 'x')};
};

}  // namespace adore::testing
