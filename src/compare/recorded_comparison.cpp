#include "compare/recorded_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "io/files/shell_word.hpp"
#include "io/tables/json_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// A text of a comparison; empty if it has none.
std::string text_of(const Data& results, const char* key) {
    const Data* found = results.find(key);
    return found != nullptr && found->is_text() ? found->text() : "";
}

Data summary_of(const fs::path& file) {
    return read_json(file, "the results of a comparison", [&](const Data& results) -> Data {
        const Data& checks = results.at("checks");
        std::vector<std::string> failed;
        for (const Data& check : checks.items()) {
            if (!check.at("passed").flag()) {
                failed.push_back(check.at("name").text());
            }
        }
        const Data* diagnoses = results.find("diagnoses");
        const std::string peer = text_of(results, "peer");
        return {{"file", file.filename().string()},
                {"deck", text_of(results, "deck")},
                {"with", text_of(results, "with")},
                {"peer", peer.empty() ? text_of(results, "with") : peer},
                {"checks", static_cast<Index>(checks.size())},
                {"failed", failed},
                {"passed", results.at("passed")},
                {"diagnoses", diagnoses != nullptr ? *diagnoses : Data::list()}};
    });
}

std::string verdict_in_words(const Data& summary) {
    const Index checks = summary.at("checks").integer();
    const auto failed = static_cast<Index>(summary.at("failed").size());
    return checks == 0   ? std::string("nothing was judged")
           : failed == 0 ? fmt::format("all {} checks passed", checks)
                         : fmt::format("{} of {} checks FAILED", failed, checks);
}

}  // namespace

bool is_comparison_result(const std::string& name) {
    return name == "judge.json" || (name.starts_with("compare-") && name.ends_with(".json"));
}

std::vector<fs::path> comparison_results(const fs::path& directory) {
    std::vector<fs::path> found;
    for (const fs::path& entry : files::list(directory)) {
        if (is_comparison_result(entry.filename().string())) {
            found.push_back(entry);
        }
    }
    std::ranges::sort(found);
    return found;
}

bool holds_comparison(const fs::path& directory) {
    return input_is_directory(directory) && !comparison_results(directory).empty();
}

Document comparison_report(const fs::path& directory) {
    Data comparisons = Data::list();
    std::string text;
    for (const fs::path& file : comparison_results(directory)) {
        const Data summary = summary_of(file);
        text += fmt::format("{}: {} against {}\nverdict       {}\n", file.string(), summary.at("deck").text(),
                            printable(summary.at("peer").text(), screen_columns), verdict_in_words(summary));
        for (const Data& name : summary.at("failed").items()) {
            text += fmt::format("failed        {}\n", name.text());
        }
        for (const Data& words : summary.at("diagnoses").items()) {
            text += wrapped("diagnosis     " + words.text(), screen_columns, 14) + "\n";
        }
        comparisons.push_back(summary);
    }
    if (text.empty()) {
        throw DataError(fmt::format("{} holds no comparison", directory.string()));
    }
    text += fmt::format("a page about it: ljmd report {0}; a picture: ljmd plot {0}\n", shell_word(directory));
    return {{{"kind", "comparison"}, {"comparisons", comparisons}}, text};
}

}  // namespace ljmd
