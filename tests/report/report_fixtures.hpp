#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "report/page_content.hpp"
#include "run/run_fixtures.hpp"

namespace ljmd::test {

/// Run a deck to its end in its directory.
inline void run_whole(const Deck& deck) {
    run_until(deck, total_steps(deck.stages()));
}

/// Replace a file by this text.
inline void overwrite(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// The statement on a subject.
inline const Verdict& verdict_on(const std::vector<Verdict>& verdicts, const std::string& subject) {
    const auto found = std::ranges::find(verdicts, subject, &Verdict::subject);
    INFO(subject);
    REQUIRE(found != verdicts.end());
    return *found;
}

inline const Quantity& quantity_called(const std::vector<Quantity>& quantities, const std::string& name) {
    const auto found = std::ranges::find(quantities, name, &Quantity::name);
    INFO(name);
    REQUIRE(found != quantities.end());
    return *found;
}

inline const PageTable& table_called(const PageContent& page, const std::string& name) {
    const auto found = std::ranges::find(page.tables, name, &PageTable::name);
    INFO(name);
    REQUIRE(found != page.tables.end());
    return *found;
}

/// The values of a column.
inline const Data::List& values_of(const PageTable& table, const std::string& column) {
    const auto found = std::ranges::find(table.columns, column, &PageColumn::name);
    INFO(column);
    REQUIRE(found != table.columns.end());
    return table.values.at(static_cast<std::size_t>(found - table.columns.begin()));
}

inline const Chart& chart_called(const PageContent& page, const std::string& id) {
    const auto found = std::ranges::find(page.charts, id, &Chart::id);
    INFO(id);
    REQUIRE(found != page.charts.end());
    return *found;
}

/// Every mark draws columns that there are: what the page is drawn from fits together.
inline void check_marks(const PageContent& page) {
    for (const Chart& chart : page.charts) {
        for (const Mark& mark : chart.marks) {
            INFO(chart.id << " " << mark.type << " " << mark.y);
            CHECK(mark.table.empty() == mark.value.has_value());
            if (mark.table.empty()) {
                continue;
            }
            const PageTable& table = table_called(page, mark.table);
            for (const std::string& column : {mark.x, mark.y, mark.error, mark.group, mark.flag, mark.fill, mark.tip}) {
                CHECK((column.empty() || table.has_column(column)));
            }
        }
    }
    for (const PageTable& table : page.tables) {
        INFO(table.name);
        CHECK(table.values.size() == table.columns.size());
        for (const Data::List& values : table.values) {
            CHECK(values.size() == table.values.front().size());
        }
    }
}

}  // namespace ljmd::test
