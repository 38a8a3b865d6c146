#include "ljmd/report/pages/set_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ljmd/report/quantity_names.hpp"

namespace ljmd {

namespace {

using Members = std::vector<std::pair<std::string, PageContent>>;

/// The name of its directory; where two have the same, as it was given.
std::vector<std::string> labels_of(const std::vector<PageContent>& members) {
    std::vector<std::string> labels;
    for (const PageContent& member : members) {
        const std::filesystem::path path = std::filesystem::path(member.source).lexically_normal();
        labels.push_back((path.has_filename() ? path.filename() : path.parent_path().filename()).string());
    }
    for (std::size_t k = 0; k < labels.size(); ++k) {
        if (std::ranges::count(labels, labels[k]) > 1) {
            labels[k] = fmt::format("{}: {}", k + 1, members[k].source);
        }
    }
    return labels;
}

std::vector<std::string> names_of(const Members& members) {
    std::vector<std::string> names;
    for (const auto& [label, member] : members) {
        for (const Quantity& each : member.quantities) {
            if (std::ranges::find(names, each.name) == names.end()) {
                names.push_back(each.name);
            }
        }
    }
    return names;
}

void add_quantities(PageContent& page) {
    PageTable table{.name = "members", .title = "Quantities side by side"};
    std::vector<std::string> labels;
    std::vector<std::string> states;
    for (const auto& [label, member] : page.members) {
        labels.push_back(label);
        states.push_back(member.state);
    }
    table.add({"run"}, labels);
    table.add({"state"}, states);
    for (const std::string& name : names_of(page.members)) {
        std::vector<double> values;
        std::vector<double> errors;
        for (const auto& [label, member] : page.members) {
            const auto found = std::ranges::find(member.quantities, name, &Quantity::name);
            const bool is_there = found != member.quantities.end();
            values.push_back(is_there ? found->value : std::nan(""));
            errors.push_back(is_there ? found->error.value_or(std::nan("")) : std::nan(""));
        }
        table.add(described(name), values);
        table.add(described(name + "_standard_error"), errors);
        page.charts.push_back({.id = name,
                               .title = in_plain_words(name),
                               .caption = "",
                               .lead = page.charts.size() < 3,
                               .x = {"run", "category"},
                               .y = {axis_label(name)},
                               .marks = {{.type = "dots",
                                          .label = "measured",
                                          .table = "members",
                                          .x = "run",
                                          .y = name,
                                          .error = name + "_standard_error"}}});
    }
    page.tables.push_back(std::move(table));
}

/// One chart of what several members have: a line for each.
void add_lines(PageContent& page, const std::string& table, const std::string& x, const std::string& y) {
    std::vector<std::string> labels;
    Data::List of_x;
    Data::List of_y;
    std::size_t runs = 0;
    for (const auto& [label, member] : page.members) {
        const auto found = std::ranges::find(member.tables, table, &PageTable::name);
        if (found == member.tables.end()) {
            continue;
        }
        const auto place = [&](const std::string& name) {
            return std::ranges::find(found->columns, name, &PageColumn::name) - found->columns.begin();
        };
        if (place(x) == std::ssize(found->columns) || place(y) == std::ssize(found->columns)) {
            continue;
        }
        const Data::List& xs = found->values[static_cast<std::size_t>(place(x))];
        const Data::List& ys = found->values[static_cast<std::size_t>(place(y))];
        of_x.insert(of_x.end(), xs.begin(), xs.end());
        of_y.insert(of_y.end(), ys.begin(), ys.end());
        labels.insert(labels.end(), xs.size(), label);
        ++runs;
    }
    if (runs < 2) {
        return;
    }
    PageTable together{.name = table, .title = fmt::format("{} of all runs", described(y).label)};
    together.add({"run"}, labels);
    together.add(described(x), std::move(of_x));
    together.add(described(y), std::move(of_y));
    page.tables.push_back(std::move(together));
    page.charts.push_back({.id = table,
                           .title = fmt::format("{} of all runs", described(y).label),
                           .caption = "",
                           .lead = true,
                           .x = {axis_label(x)},
                           .y = {axis_label(y)},
                           .marks = {{.type = "line", .label = "", .table = table, .x = x, .y = y, .group = "run"}}});
}

}  // namespace

PageContent set_page(std::vector<PageContent> members) {
    const std::vector<std::string> labels = labels_of(members);
    PageContent page{.kind = "set",
                     .title = fmt::format("{} directories side by side", members.size()),
                     .source = fmt::format("{} directories", members.size())};
    std::ptrdiff_t finished = 0;
    for (std::size_t k = 0; k < members.size(); ++k) {
        finished += members[k].state == "finished" ? 1 : 0;
        page.members.emplace_back(labels[k], std::move(members[k]));
    }
    page.state = finished == std::ssize(page.members) ? "finished" : "stopped";
    page.state_words = fmt::format("{} of {} are finished", finished, page.members.size());
    add_quantities(page);
    add_lines(page, "rdf", "r", "g");
    add_lines(page, "msd", "time", "msd");
    add_lines(page, "energy", "time", "energy_error");
    return page;
}

}  // namespace ljmd
