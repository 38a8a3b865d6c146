#include "ljmd/study/sweep_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ljmd/core/text.hpp"
#include "ljmd/core/text_table.hpp"
#include "ljmd/io/tables/csv_text.hpp"
#include "ljmd/io/tables/json_text.hpp"
#include "ljmd/run/footnotes.hpp"
#include "ljmd/study/sweep_points.hpp"

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

/// Like in_words(), with the mark of its remark.
std::string in_marked_words(const ObservedMean* found, Footnotes& footnotes) {
    const std::string mark = found == nullptr ? "" : footnotes.mark(found->remark);
    return in_words(found) + (mark.empty() ? "" : " " + mark);
}

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

std::string text_of(const SweptPoints& swept) {
    std::vector<TextTable::Column> columns;
    for (const std::string& heading : short_keys(swept.keys)) {
        columns.push_back({heading});
    }
    const bool fluid = std::any_of(swept.points.begin(), swept.points.end(), has_temperature);
    for (const auto& [observable, heading] : columns_for(fluid)) {
        columns.push_back({heading, TextTable::Align::right, 21});
    }
    columns.push_back({"", TextTable::Align::left});
    Footnotes footnotes;
    TextTable table(std::move(columns), 2);
    for (const SweptPoint& point : swept.points) {
        std::vector<std::string> entries = point.values;
        for (const auto& [observable, heading] : columns_for(fluid)) {
            entries.push_back(point.failure.empty() ? in_marked_words(find_mean(point, observable), footnotes)
                                                    : "failed");
        }
        std::string marks;
        for (const std::string& doubt : point.doubts) {
            marks += footnotes.mark(doubt);
        }
        entries.push_back(marks);
        table.add(entries);
    }
    return table.text() + footnotes.text();
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

Document sweep_report(const SweptPoints& swept) {
    return {data_of(swept), text_of(swept)};
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
