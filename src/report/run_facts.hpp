#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/core/data.hpp"
#include "ljmd/detail/reference/equation_of_state.hpp"
#include "report/page_content.hpp"
#include "run/recorded_run.hpp"

namespace ljmd {

/// What is known of the run in a directory, as far as it can be read.
struct RunFacts {
    std::filesystem::path directory;
    Data record;                     ///< run.json
    std::optional<RecordedRun> run;  ///< nothing if its deck cannot be read
    Data results;                    ///< results.json; null if there is none
    std::string state;               ///< see PageContent
    std::string state_words;
    std::vector<std::string> problems;  ///< what could not be read, and why

    [[nodiscard]] bool is_few_body() const;
    [[nodiscard]] const Deck* deck() const { return run ? &run->deck : nullptr; }
};

/// @throws DataError  there is no run.json, or it is not JSON or not ljmd's
[[nodiscard]] RunFacts run_facts(const std::filesystem::path& directory);

/// What stands at the head and the end of a run's page: title, state, provenance, deck, methods, warnings.
[[nodiscard]] PageContent page_of(const RunFacts& facts);

}  // namespace ljmd
