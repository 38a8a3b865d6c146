#include "report/pages/set_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace ljmd {

namespace {

/// The name of its directory; where two have the same, as it was given.
std::vector<std::string> labels_of(const std::vector<PageContent>& members) {
    std::vector<std::string> labels;
    for (const PageContent& member : members) {
        const std::filesystem::path path = std::filesystem::path(member.source).lexically_normal();
        labels.push_back((path.has_filename() ? path.filename() : path.parent_path().filename()).string());
    }
    const std::vector<std::string> names = labels;
    for (std::size_t k = 0; k < labels.size(); ++k) {
        if (std::ranges::count(names, names[k]) > 1) {
            labels[k] = fmt::format("{}: {}", k + 1, members[k].source);
        }
    }
    return labels;
}

}  // namespace

PageContent set_page(std::vector<PageContent> members) {
    const std::vector<std::string> labels = labels_of(members);
    const auto finished = std::ranges::count(members, std::string("finished"), &PageContent::state);
    PageContent page{.kind = "set",
                     .title = fmt::format("{} directories side by side", members.size()),
                     .source = fmt::format("{} directories", members.size()),
                     .state = finished == std::ssize(members) ? "finished" : "stopped",
                     .state_words = fmt::format("{} of {} are finished", finished, members.size())};
    for (std::size_t k = 0; k < members.size(); ++k) {
        page.members.emplace_back(labels[k], std::move(members[k]));
    }
    return page;
}

}  // namespace ljmd
