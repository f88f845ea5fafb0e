#include "adrinput/start_check.hpp"

#include "adrinput/window_words.hpp"

#include <exception>
#include <memory>
#include <utility>

namespace adore::adrinput {

void StartCheck::ask(Document::Candidate candidate) {
  if (!busy()) return start(std::move(candidate));
  if (!next_ && asked_ && *asked_ == candidate) return;  // not given up
  next_ = std::move(candidate);
  background_.stop();
}

void StartCheck::forget() {
  asked_.reset();
  next_.reset();
  background_.stop();
}

void StartCheck::start(Document::Candidate candidate) {
  asked_ = candidate;
  auto answer = std::make_shared<std::optional<runs::Rehearsal>>();
  background_.start(
      [candidate, answer](const std::stop_token& stop) {
        try {
          runs::LoadedDeck input;
          input.path = candidate.path;
          input.deck = candidate.deck;
          input.option_values = candidate.options;
          input.stop = stop;
          *answer = runs::rehearse_run(std::move(input));
          const auto in_words = [](Issue& issue) {
            issue.message = in_window_words(std::move(issue.message));
            issue.remedy = in_window_words(std::move(issue.remedy));
          };
          for (Issue& issue : (*answer)->refusals) in_words(issue);
          for (Finding& finding : (*answer)->remarks) in_words(finding);
        } catch (const std::exception&) {
          answer->reset();  // given up
        }
      },
      [this, candidate, answer] {
        const bool awaited = asked_.has_value();
        asked_.reset();
        if (next_) return start(*std::exchange(next_, std::nullopt));
        if (awaited && *answer && found) found(candidate, std::move(**answer));
      });
}

}  // namespace adore::adrinput
