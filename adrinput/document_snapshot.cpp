#include "adrinput/document.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>

/// A document as bytes (CBOR, so that numbers and foreign characters are restored exactly), for
/// crash recovery.
namespace adore::adrinput {
namespace {

using Json = nlohmann::json;
constexpr int kVersion = 1;

Json json_of(const deck::Value& value) {
  if (const auto* integer = std::get_if<long long>(&value)) return *integer;
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return nullptr;
}

deck::Value value_in(const Json& json) {
  if (json.is_number_float()) return json.get<double>();
  if (json.is_number_integer()) return json.get<long long>();
  if (json.is_string()) return json.get<std::string>();
  return std::monostate();
}

Json json_of(const deck::RecordData& record) {
  Json values = Json::array(), defaulted = Json::array();
  for (const std::vector<deck::Value>& elements : record.values) {
    Json list = Json::array();
    for (const deck::Value& value : elements) list.push_back(json_of(value));
    values.push_back(std::move(list));
  }
  for (const deck::RecordData::Element& at : record.defaulted)
    defaulted.push_back({at.variable, at.element});
  return {{"id", record.id},
          {"instance", record.instance},
          {"line", record.line},
          {"values", std::move(values)},
          {"defaulted", std::move(defaulted)}};
}

deck::RecordData record_in(const Json& json) {
  deck::RecordData record;
  record.id = json.at("id").get<std::string>();
  if (deck::find_record(record.id) == nullptr)
    throw InputError("the file contains a record that is unknown in this version of AdrInput: " +
                     record.id);
  record.instance = json.at("instance").get<int>();
  record.line = json.at("line").get<int>();
  for (const Json& list : json.at("values")) {
    record.values.emplace_back();
    for (const Json& value : list) record.values.back().push_back(value_in(value));
  }
  if (record.values.size() != deck::find_record(record.id)->variables.size())
    throw InputError("record " + record.id +
                     " has a different number of variables in this version of AdrInput");
  for (const Json& at : json.at("defaulted"))
    record.defaulted.push_back({at.at(0).get<std::size_t>(), at.at(1).get<std::size_t>()});
  return record;
}

Json json_of(const deck::Deck& deck) {
  Json records = Json::array();
  for (const deck::RecordData& record : deck.records) records.push_back(json_of(record));
  return {{"records", std::move(records)}, {"lines", deck.user_lines}};
}

deck::Deck deck_in(const Json& json) {
  deck::Deck deck;
  for (const Json& record : json.at("records")) deck.records.push_back(record_in(record));
  deck.user_lines = json.at("lines").get<std::vector<std::string>>();
  return deck;
}

Json json_of(const std::map<Cell, std::string>& drafts) {
  Json out = Json::array();
  for (const auto& [cell, text] : drafts)
    out.push_back({cell.record, cell.instance, cell.variable, cell.element, text});
  return out;
}

std::map<Cell, std::string> drafts_in(const Json& json) {
  std::map<Cell, std::string> out;
  for (const Json& item : json) {
    const Cell cell{item.at(0).get<std::string>(), item.at(1).get<int>(),
                    item.at(2).get<std::size_t>(), item.at(3).get<std::size_t>()};
    if (variable_of(cell) != nullptr) out[cell] = item.at(4).get<std::string>();
  }
  return out;
}

Json json_of(const Issue& issue) {
  return {static_cast<int>(issue.severity),
          issue.file,
          issue.line,
          issue.record,
          issue.variable,
          issue.value,
          issue.message,
          issue.remedy};
}

Issue issue_in(const Json& json) {
  Issue issue;
  issue.severity = static_cast<Severity>(json.at(0).get<int>());
  issue.file = json.at(1).get<std::string>();
  issue.line = json.at(2).get<int>();
  issue.record = json.at(3).get<std::string>();
  issue.variable = json.at(4).get<std::string>();
  issue.value = json.at(5).get<std::string>();
  issue.message = json.at(6).get<std::string>();
  issue.remedy = json.at(7).get<std::string>();
  return issue;
}

}  // namespace

std::string Document::snapshot(std::string_view page) const {
  Json shelf = Json::array(), issues = Json::array(), typed_since = Json::array();
  for (const Cell& cell : state_.typed_since)
    typed_since.push_back({cell.record, cell.instance, cell.variable, cell.element});
  for (const auto& [place, record] : state_.shelf) shelf.push_back(json_of(record));
  for (const Issue& issue : file_issues_) issues.push_back(json_of(issue));
  const Json json = {
      {"adrinput", kVersion},
      {"page", page},
      {"path", path_.string()},
      {"deck", json_of(state_.deck)},
      {"shelf", std::move(shelf)},
      {"drafts", json_of(state_.drafts)},
      {"options", state_.options},
      {"saved_deck", json_of(saved_deck_)},
      {"saved_drafts", json_of(saved_unparsed_texts_)},
      {"saved_options", saved_options_},
      {"original", original_text_},
      {"comments", state_.comments},
      {"saved_comments", saved_comments_},
      {"original_kept", original_matches_deck_},
      {"issues", std::move(issues)},
      {"option_file", option_file_.text()},
      {"has_option_file", option_file_.exists()},
      {"numbers_in",
       state_.previous_units ? Json(static_cast<int>(*state_.previous_units)) : Json()},
      {"typed_since", std::move(typed_since)}};
  std::string out;
  Json::to_cbor(json, out);
  return out;
}

std::string Document::restore(std::string_view bytes) {
  try {
    const Json json = Json::from_cbor(bytes);
    if (json.at("adrinput").get<int>() != kVersion)
      throw InputError("the file was written by a different version of AdrInput");
    State state;
    state.deck = deck_in(json.at("deck"));
    for (const Json& item : json.at("shelf")) {
      deck::RecordData record = record_in(item);
      std::pair place(record.id, record.instance);
      state.shelf[std::move(place)] = std::move(record);
    }
    state.drafts = drafts_in(json.at("drafts"));
    // An earlier release had no question of units in its files.
    const Json none = Json::array();
    const Json previous_units = json.value("numbers_in", Json());
    if (!previous_units.is_null())
      state.previous_units =
          previous_units.get<int>() == static_cast<int>(deck::UnitSystem::English)
              ? deck::UnitSystem::English
              : deck::UnitSystem::SI;
    for (const Json& item : json.value("typed_since", none)) {
      const Cell cell{item.at(0).get<std::string>(), item.at(1).get<int>(),
                      item.at(2).get<std::size_t>(), item.at(3).get<std::size_t>()};
      if (variable_of(cell) != nullptr) state.typed_since.insert(cell);
    }
    state.options = json.at("options").get<std::map<std::string, std::string>>();
    deck::Deck saved_deck = deck_in(json.at("saved_deck"));
    std::map<Cell, std::string> saved_drafts = drafts_in(json.at("saved_drafts"));
    auto saved_options = json.at("saved_options").get<std::map<std::string, std::string>>();
    std::vector<Issue> issues;
    for (const Json& item : json.at("issues")) issues.push_back(issue_in(item));
    auto original = json.at("original").get<std::string>();
    state.comments = json.value("comments", std::string());
    auto saved_comments = json.value("saved_comments", std::string());
    const bool kept = json.at("original_kept").get<bool>();
    // An earlier release stored relative paths: their folder is unknown.
    std::filesystem::path path = json.at("path").get<std::string>();
    if (path.is_relative()) path.clear();
    const bool has_options = json.at("has_option_file").get<bool>();
    auto option_text = json.at("option_file").get<std::string>();
    auto page = json.at("page").get<std::string>();
    // From here on nothing throws.
    path_ = path;
    original_text_ = std::move(original);
    original_matches_deck_ = kept;
    option_file_ =
        has_options ? runs::OptionFile::from_text(std::move(option_text)) : runs::OptionFile();
    file_has_errors_ = std::any_of(issues.begin(), issues.end(), [](const Issue& issue) {
      return issue.severity == Severity::Error;
    });
    file_issues_ = std::move(issues);
    start(std::move(state));
    saved_deck_ = std::move(saved_deck);
    saved_unparsed_texts_ = std::move(saved_drafts);
    saved_options_ = std::move(saved_options);
    saved_comments_ = std::move(saved_comments);
    notify();
    return page;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("the file does not contain a deck stored by AdrInput: ") +
                     error.what());
  }
}

}  // namespace adore::adrinput
