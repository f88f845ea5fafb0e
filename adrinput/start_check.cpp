#include "adrinput/start_check.hpp"

#include "adrinput/window_words.hpp"

#include <exception>
#include <memory>
#include <utility>

namespace adore::adrinput {

void StartCheck::ask(Document::Candidate candidate) {
  if (!busy()) return start(std::move(candidate));
  if (!next_candidate_ && running_candidate_ && *running_candidate_ == candidate)
    return;  // not given up
  next_candidate_ = std::move(candidate);
  background_task_.stop();
}

void StartCheck::invalidateResult() {
  running_candidate_.reset();
  next_candidate_.reset();
  background_task_.stop();
}

void StartCheck::start(Document::Candidate candidate) {
  running_candidate_ = candidate;
  auto answer = std::make_shared<std::optional<runs::DryRunResult>>();
  background_task_.start(
      [candidate, answer](const std::stop_token& stop) {
        try {
          runs::LoadedDeck input;
          input.path = candidate.path;
          input.deck = candidate.deck;
          input.option_values = candidate.options;
          input.stop = stop;
          *answer = runs::dry_run_with_files(std::move(input));
          const auto in_words = [](Issue& issue) {
            issue.message = replace_cli_terms(std::move(issue.message));
            issue.remedy = replace_cli_terms(std::move(issue.remedy));
          };
          for (Issue& issue : (*answer)->refusals) in_words(issue);
          for (Finding& finding : (*answer)->remarks) in_words(finding);
        } catch (const std::exception&) {
          answer->reset();  // given up
        }
      },
      [this, candidate, answer] {
        const bool awaited = running_candidate_.has_value();
        running_candidate_.reset();
        if (next_candidate_) return start(*std::exchange(next_candidate_, std::nullopt));
        if (awaited && *answer && found) found(candidate, std::move(**answer));
      });
}

}  // namespace adore::adrinput
