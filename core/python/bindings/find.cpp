#include "calculators/find.hpp"

#include "base/json_text.hpp"
#include "bindings.hpp"
#include "design/find.hpp"
#include "routines.hpp"

#include <map>

/// Inverse calculations on decks and calculators.
namespace adore::python {
namespace {

struct Question {
  FindUnknown unknown;
  FindTarget target;
  const design::FindQuestion* named = nullptr;
};

Question question_of(const std::string& unknown, double first, double last,
                     const std::string& target, const std::string& question) {
  Question out;
  if (!question.empty()) {
    const design::ParsedFindQuestion asked = design::parse_question(question);
    out = {asked.unknown, asked.target, asked.question};
  }
  if (!unknown.empty()) out.unknown.name = unknown;
  out.unknown.first = first;
  out.unknown.last = last;
  if (!target.empty()) out.target = parse_target(target);
  return out;
}

py::tuple to_tuple(const FindReport& report) {
  return py::make_tuple(dump_json(find_report_json(report)), answer_lines(report));
}

}  // namespace

void bind_find(py::module_& module) {
  module.def(
      "find",
      [](const std::string& text, const std::string& name,
         const std::map<std::string, std::string>& options, const py::object& user,
         const std::string& unknown, double first, double last, const std::string& target,
         const std::string& question, int points) {
        design::FindRequest request;
        request.deck = name;
        request.text = text;
        request.in_memory = true;
        request.options.assign(options.begin(), options.end());
        if (py::isinstance<Routines>(user))
          request.routines = user.cast<const Routines&>().plug_in();
        else if (!user.is_none())
          request.user = user.cast<std::string>();
        const Question asked = question_of(unknown, first, last, target, question);
        request.unknown = asked.unknown;
        request.target = asked.target;
        request.points = points;
        if (asked.named != nullptr) design::add_sets(*asked.named, request);
        return to_tuple(run_interruptible(
            [&](std::stop_token stop) { return design::find_in_deck(request, std::move(stop)); }));
      },
      py::arg("text"), py::arg("name"), py::arg("options"), py::arg("user"), py::arg("unknown"),
      py::arg("first"), py::arg("last"), py::arg("target"), py::arg("question"), py::arg("points"),
      "Inverse calculation on a deck: the answer as JSON, and as sentences.");
  module.def(
      "find_in_calculator",
      [](const std::string& calculator, const std::string& inputs, const std::string& unknown,
         double first, double last, const std::string& target, const std::string& question,
         int points) {
        const Question asked = question_of(unknown, first, last, target, question);
        return to_tuple(calculators::find_in_calculator(calculator, parse_json(inputs, "inputs"),
                                                        asked.unknown, asked.target, points));
      },
      py::arg("calculator"), py::arg("inputs"), py::arg("unknown"), py::arg("first"),
      py::arg("last"), py::arg("target"), py::arg("question"), py::arg("points"),
      "Inverse calculation on a calculator: the answer as JSON, and as sentences.");
  module.def(
      "find_questions",
      [] {
        py::list out;
        for (const design::FindQuestion& one : design::find_questions())
          out.append(py::make_tuple(std::string(one.name), std::string(one.meaning)));
        return out;
      },
      "Name and meaning of the common questions.");
  module.def(
      "find_results",
      [] {
        py::list out;
        for (const design::FindResultInfo& one : design::find_results())
          out.append(py::make_tuple(one.id, one.unit, one.meaning));
        return out;
      },
      "Name, unit and meaning of the results of an equilibrium.");
}

}  // namespace adore::python
