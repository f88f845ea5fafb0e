#include "command_line/tree.hpp"

#include "base/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace adore::command_line {
namespace {

/// CLI11 options do not store a list of words. Only one thread builds and reads the tree.
std::map<const CLI::Option*, std::vector<std::string>>& words_of() {
  static std::map<const CLI::Option*, std::vector<std::string>> table;
  return table;
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words)
    out += (out.empty() ? "" : &word == &words.back() ? " or " : ", ") + word;
  return out;
}

ValueKind kind_of(const CLI::Option& option, const OptionDescription& text) {
  if (text.value.empty()) return ValueKind::None;
  if (!text.words.empty()) return ValueKind::Words;
  const std::string& type = text.value;
  if (type.find("DECK") != std::string::npos || type.find("FILE") != std::string::npos)
    return ValueKind::File;
  if (type.find("DIR") != std::string::npos) return ValueKind::Folder;
  (void)option;
  return type == "NUMBER" || type == "N" ? ValueKind::Number : ValueKind::Text;
}

OptionDescription describe(const CLI::Option& option) {
  OptionDescription out;
  out.positional = option.get_positional();
  if (out.positional) {
    out.names = {option.get_name(true, false)};
  } else {
    for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  }
  out.help = option.get_description();
  out.required = option.get_required();
  out.many = option.get_items_expected_max() > 1 || option.get_expected_max() > 1;
  if (option.get_type_size() != 0 && option.get_expected_max() != 0) {
    out.value = option.get_type_name();
    out.value.resize(std::min(out.value.find(':'), out.value.size()));  // "DIR:DIR" of a check
    if (out.value == "FLOAT") out.value = "NUMBER";
    if (out.value == "INT" || out.value == "UINT") out.value = "N";
    out.default_value = option.get_default_str();
  }
  if (const auto found = words_of().find(&option); found != words_of().end())
    out.words = found->second;
  out.kind = kind_of(option, out);
  return out;
}

bool is_number(const std::string& text, double least) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value >= least;
}

}  // namespace

CommandDescription describe(const CLI::App& app) {
  CommandDescription out;
  out.name = app.get_name();
  out.help = app.get_description();
  out.footer = app.get_footer();
  for (const bool positional : {true, false})
    for (const CLI::Option* option : app.get_options())
      if (!option->get_group().empty() && option->get_positional() == positional)
        out.options.push_back(describe(*option));
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty()) out.commands.push_back(describe(*command));
  return out;
}

CLI::Option* one_of(CLI::Option* option, std::vector<std::string> words) {
  option->check(CLI::Validator(
      [words](std::string& value) {
        if (std::find(words.begin(), words.end(), value) != words.end()) return std::string();
        const std::string near = nearest(value, words);
        return near.empty() ? fmt::format("\"{}\" is not known; give {}", value, joined(words))
                            : fmt::format("\"{}\" is not known; did you mean {}? Give {}", value,
                                          near, joined(words));
      },
      ""));
  words_of()[option] = std::move(words);
  return option;
}

CLI::Option* suggest_values(CLI::Option* option, std::vector<std::string> words) {
  words_of()[option] = std::move(words);
  return option;
}

CLI::Option* at_least(CLI::Option* option, double least) {
  return option->check(CLI::Validator(
      [least](std::string& value) {
        return is_number(value, least)
                   ? std::string()
                   : fmt::format("\"{}\" is out of range; give a number of at least {:g}", value,
                                 least);
      },
      ""));
}

std::string nearest(const std::string& text, const std::vector<std::string>& words) {
  std::string best;
  std::size_t least = std::max<std::size_t>(1, text.size() / 3) + 1;
  for (const std::string& word : words) {
    std::size_t distance = edit_distance(text, word);
    // The beginning of a word is a good guess, too.
    if (text.size() >= 2 && word.compare(0, text.size(), text) == 0) distance = 1;
    if (distance < least) {
      least = distance;
      best = word;
    }
  }
  return best;
}

}  // namespace adore::command_line
