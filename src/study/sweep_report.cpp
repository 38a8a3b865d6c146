#include "study/sweep_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/text.hpp"
#include "core/text_table.hpp"
#include "io/tables/csv_text.hpp"
#include "io/tables/json_text.hpp"
#include "run/footnotes.hpp"
#include "study/error_in_brackets.hpp"
#include "study/sweep_points.hpp"

namespace ljmd {

namespace {

/// A column of the table.
struct TableColumn {
    const char* observable;
    const char* heading;
};

/// Energies are per atom for a fluid, and totals for few bodies, which have no temperature.
const std::vector<TableColumn>& columns_for(bool fluid) {
    static const std::vector<TableColumn> of_fluid{
        {"temperature", "T"}, {"potential_energy", "U/N"}, {"pressure", "p"}, {"compressibility_factor", "Z"}};
    static const std::vector<TableColumn> of_bodies{
        {"potential_energy", "potential"}, {"kinetic_energy", "kinetic"}, {"total_energy", "total energy"}};
    return fluid ? of_fluid : of_bodies;
}

const ObservedMean* find_mean(const SweptPoint& point, const std::string& name) {
    const auto found =
        std::find_if(point.found.begin(), point.found.end(), [&](const ObservedMean& one) { return one.name == name; });
    return found == point.found.end() ? nullptr : &*found;
}

bool has_temperature(const SweptPoint& point) {
    return find_mean(point, "temperature") != nullptr;
}

std::string in_words(const ObservedMean* found) {
    return found == nullptr || std::isnan(found->mean) ? "-" : with_error(found->mean, found->standard_error);
}

/// Like in_words(), with "1.250(12)" for "1.250 +- 0.012".
std::string in_short_words(const ObservedMean* found) {
    const bool has_error = found != nullptr && std::isfinite(found->mean) && found->standard_error > 0.0;
    return has_error ? with_error_in_brackets(found->mean, found->standard_error) : in_words(found);
}

/// How much room a table takes.
struct TableLayout {
    std::size_t observables;  ///< columns of observables, from the first on
    bool roomy;               ///< columns of one width, errors as "+- 0.012"; otherwise "(12)"
};

std::string remarks_of(const SweptPoint& point) {
    std::string text;
    for (const ObservedMean& one : point.found) {
        if (!one.remark.empty()) {
            text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", one.name, one.remark);
        }
    }
    for (const std::string& doubt : point.doubts) {
        text += fmt::format("{}{}", text.empty() ? "" : "; ", doubt);
    }
    return text;
}

std::string number_or_nothing(double value) {
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

/// A value of --set: a number, a flag or an array as itself, anything else as a string.
Data value_of_setting(const std::string& value) {
    try {
        return parse_json(value);
    } catch (const WrongData&) {
        return value;
    }
}

/// The observables of all points without repetition, in order of appearance.
std::vector<std::string> observables_of(const SweptPoints& swept) {
    std::vector<std::string> names;
    for (const SweptPoint& point : swept.points) {
        for (const ObservedMean& one : point.found) {
            if (std::find(names.begin(), names.end(), one.name) == names.end()) {
                names.push_back(one.name);
            }
        }
    }
    return names;
}

bool is_of_fluid(const SweptPoints& swept) {
    return std::any_of(swept.points.begin(), swept.points.end(), has_temperature);
}

/// The entry of an observable, with the mark of its remark.
std::string entry_of(const SweptPoint& point, const char* observable, bool roomy, Footnotes& footnotes) {
    if (!point.failure.empty()) {
        return "failed";
    }
    const ObservedMean* found = find_mean(point, observable);
    const std::string mark = found == nullptr ? "" : footnotes.mark(found->remark);
    return (roomy ? in_words(found) : in_short_words(found)) + (mark.empty() ? "" : " " + mark);
}

TextTable table_of(const SweptPoints& swept, const TableLayout& layout, Footnotes& footnotes) {
    constexpr std::size_t usual_width = 21;
    std::vector<TableColumn> shown = columns_for(is_of_fluid(swept));
    shown.resize(layout.observables);
    std::vector<TextTable::Column> columns;
    for (const std::string& heading : short_keys(swept.keys)) {
        columns.push_back({heading});
    }
    for (const TableColumn& column : shown) {
        columns.push_back({column.heading, TextTable::Align::right, layout.roomy ? usual_width : 0});
    }
    columns.push_back({"", TextTable::Align::left});
    TextTable table(std::move(columns), 2);
    for (const SweptPoint& point : swept.points) {
        std::vector<std::string> entries = point.values;
        for (const TableColumn& column : shown) {
            entries.push_back(entry_of(point, column.observable, layout.roomy, footnotes));
        }
        std::string marks;
        for (const std::string& doubt : point.doubts) {
            marks += footnotes.mark(doubt);
        }
        entries.push_back(marks);
        table.add(entries);
    }
    return table;
}

/// "left out here: p, Z (sweep.csv has all)": the observables that a layout does not show; empty if it shows all.
std::string left_out(const SweptPoints& swept, const TableLayout& layout) {
    const std::vector<TableColumn>& all = columns_for(is_of_fluid(swept));
    std::string names;
    for (std::size_t k = layout.observables; k < all.size(); ++k) {
        names += fmt::format("{}{}", names.empty() ? "" : ", ", all[k].heading);
    }
    return names.empty() ? "" : fmt::format("  left out here: {} (sweep.csv has all)\n", names);
}

/// The table in the roomiest layout that fits; where there is no screen, in full.
std::string text_of(const SweptPoints& swept, std::optional<std::size_t> screen) {
    TableLayout layout{columns_for(is_of_fluid(swept)).size(), true};
    const auto made = [&]() {
        Footnotes footnotes;
        TextTable table = table_of(swept, layout, footnotes);
        return std::pair(std::move(table), footnotes.text());
    };
    auto [table, remarks] = made();
    while (screen && table.columns() > *screen && (layout.roomy || layout.observables > 1)) {
        layout = {layout.roomy ? layout.observables : layout.observables - 1, false};
        std::tie(table, remarks) = made();
    }
    return (screen ? table.text_within(*screen) : table.text()) + remarks + left_out(swept, layout);
}

Data data_of(const SweptPoints& swept) {
    Data points = Data::list();
    for (const SweptPoint& point : swept.points) {
        Data values = Data::object();
        for (std::size_t k = 0; k < swept.keys.size(); ++k) {
            values[swept.keys[k]] = value_of_setting(point.values[k]);
        }
        Data observables = Data::object();
        for (const auto& [name, mean, error, remark] : point.found) {
            observables[name] = {{"mean", mean}, {"standard_error", error}};
            if (!remark.empty()) {
                observables[name]["remark"] = remark;
            }
        }
        points.push_back({{"name", point.name},
                          {"directory", point.directory.string()},
                          {"values", values},
                          {"failure", point.failure.empty() ? Data(nullptr) : Data(point.failure)},
                          {"doubts", point.doubts},
                          {"observables", observables}});
    }
    return {{"keys", swept.keys}, {"points", points}};
}

}  // namespace

Document sweep_report(const SweptPoints& swept, std::optional<std::size_t> screen) {
    return {data_of(swept), text_of(swept, screen)};
}

std::string sweep_csv(const SweptPoints& swept) {
    const std::vector<std::string> observables = observables_of(swept);
    std::string text;
    for (const std::string& key : swept.keys) {
        text += (text.empty() ? "" : ",") + csv_field(key);
    }
    for (const std::string& name : observables) {
        text += fmt::format(",{},{}", csv_field(name), csv_field(name + "_standard_error"));
    }
    text += ",remarks";
    for (const SweptPoint& point : swept.points) {
        std::string line;
        for (const std::string& value : point.values) {
            line += (line.empty() ? "" : ",") + csv_field(value);
        }
        for (const std::string& name : observables) {
            const ObservedMean* found = find_mean(point, name);
            line += found == nullptr ? ",,"
                                     : fmt::format(",{},{}", number_or_nothing(found->mean),
                                                   number_or_nothing(found->standard_error));
        }
        text += '\n' + line + ',' + csv_field(remarks_of(point));
    }
    return text + '\n';
}

std::string point_line(const SweptPoint& point) {
    std::string text;
    for (const auto& [observable, heading] : columns_for(has_temperature(point))) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", heading, in_words(find_mean(point, observable)));
    }
    return text;
}

}  // namespace ljmd
