#include "study/work_share.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string_view>

#include "core/text.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

std::optional<std::size_t> counting_number(std::string_view text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

WorkShare work_share(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash != std::string::npos) {
        const auto part = counting_number(std::string_view(text).substr(0, slash));
        const auto parts = counting_number(std::string_view(text).substr(slash + 1));
        if (part && parts && *part >= 1 && *part <= *parts && *parts <= max_workers) {
            return {*part, *parts};
        }
    }
    throw InputError(
        fmt::format("--work: {} is no share; allowed: K/T with 1 <= K <= T <= {}, as in 2/8 for the second "
                    "of eight workers",
                    in_quotes(text), max_workers));
}

std::vector<RunLine*> lines_of(const WorkShare& share, const std::vector<RunLine*>& lines) {
    std::vector<RunLine*> ours;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        if (share.has(k)) {
            ours.push_back(lines[k]);
        }
    }
    return ours;
}

}  // namespace ljmd
