#include "run/footnotes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"

namespace ljmd {

namespace {

constexpr std::size_t hanging = 6;  // indentation of the lines after the first

}  // namespace

std::string Footnotes::mark(const std::string& remark) {
    if (remark.empty()) {
        return "";
    }
    const auto found = std::ranges::find(remarks_, remark);
    const auto number = found - remarks_.begin() + 1;
    if (found == remarks_.end()) {
        remarks_.push_back(remark);
    }
    return fmt::format("[{}]", number);
}

std::string Footnotes::text() const {
    std::string text;
    for (std::size_t k = 0; k < remarks_.size(); ++k) {
        text += wrapped(fmt::format("  [{}] {}", k + 1, remarks_[k]), screen_columns, hanging) + '\n';
    }
    return text;
}

}  // namespace ljmd
