#include "io/tables/data_table_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string_view>

#include "io/files/input_file.hpp"
#include "io/files/text_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// A name in a header as other programs write it: behind a '#', or in quotes.
std::string_view plain_name(std::string_view name) {
    if (name.starts_with('#')) name = without_blanks(name.substr(1));
    const bool is_quoted =
        name.size() > 1 && (name.front() == '"' || name.front() == '\'') && name.back() == name.front();
    return is_quoted ? without_blanks(name.substr(1, name.size() - 2)) : name;
}

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t comma = 0; comma != std::string_view::npos; line.remove_prefix(std::min(comma + 1, line.size()))) {
        comma = line.find(',');
        fields.push_back(without_blanks(line.substr(0, comma)));
    }
    return fields;
}

std::vector<std::string> names_in(std::string_view header) {
    std::vector<std::string> names;
    for (const std::string_view name : fields_of(header)) {
        names.emplace_back(plain_name(name));
    }
    return names;
}

constexpr double largest_step = 9007199254740992.0;  // 2^53: up to here, all integers are doubles

/// Line of a row in a file whose first line is the header.
Index line_of_row(Index row) {
    return row + 2;
}

/// Whether a file ends with a line end. True for a file that cannot be read: reading it will report why.
bool ends_with_a_line(const std::filesystem::path& path) {
    std::ifstream file = open_input(path);
    file.seekg(0, std::ios::end);
    char last = '\n';
    if (file && file.tellg() > 0) {
        file.seekg(-1, std::ios::end);
        file.get(last);
    }
    return last == '\n';
}

/// @param without_last_line  it may not be complete
/// @param loss  receives why the table ends before a number that is not finite; null: such a table is refused
DataTable read(const std::filesystem::path& path, bool without_last_line, std::string* loss = nullptr) {
    TextFile file(path);
    DataTable table{path.stem().string(), {}, {}};
    if (!file.next_line()) {
        file.fail_at(0, "no header: the file is empty");
    }
    table.columns = names_in(file.line());
    while (file.next_line()) {
        if (without_last_line && file.bytes_left() == 0) {
            break;
        }
        const std::vector<std::string_view> fields = fields_of(file.line());
        if (fields.size() != table.columns.size()) {
            file.fail(fmt::format("{} fields, but {} columns", fields.size(), table.columns.size()));
        }
        std::vector<double>& row = table.rows.emplace_back();
        try {
            for (std::size_t k = 0; k < fields.size(); ++k) {
                row.push_back(fields[k].empty() ? std::numeric_limits<double>::quiet_NaN()
                                                : file.number(fields[k], table.columns[k]));
            }
        } catch (const NotFinite& error) {
            if (loss == nullptr || table.rows.size() == 1) {
                throw;
            }
            table.rows.pop_back();
            *loss = error.what();
            break;
        }
    }
    return table;
}

}  // namespace

std::string csv_header(const std::vector<std::string>& columns) {
    return fmt::format("{}\n", fmt::join(columns, ","));
}

std::string csv_row(const std::vector<double>& row) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
        line += k == 0 ? "" : ",";
        line += std::isfinite(row[k]) ? fmt::format("{}", row[k]) : "";
    }
    return line + '\n';
}

std::string to_csv(const DataTable& table) {
    std::string text = csv_header(table.columns);
    for (const auto& row : table.rows) {
        text += csv_row(row);
    }
    return text;
}

std::vector<std::string> csv_columns(const std::filesystem::path& path) {
    TextFile file(path);
    return file.next_line() ? names_in(file.line()) : std::vector<std::string>{};
}

DataTable read_csv(const std::filesystem::path& path) {
    return read(path, false);
}

DataTable read_finite_csv(const std::filesystem::path& path, std::string& loss) {
    return read(path, false, &loss);
}

DataTable read_growing_csv(const std::filesystem::path& path) {
    return read(path, !ends_with_a_line(path));
}

std::vector<double> column(const DataTable& table, const std::string& name) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), name);
    if (found == table.columns.end()) {
        throw DataError(fmt::format("{}.csv has no column '{}'", table.name, name));
    }
    const auto k = static_cast<std::size_t>(found - table.columns.begin());
    std::vector<double> values;
    values.reserve(table.rows.size());
    for (const auto& row : table.rows) {
        values.push_back(row[k]);
    }
    return values;
}

std::vector<double> full_column(const DataTable& table, const std::string& name, const std::filesystem::path& path) {
    std::vector<double> values = column(table, name);
    const auto empty = std::ranges::find_if(values, [](double value) { return std::isnan(value); });
    if (empty != values.end()) {
        throw DataError(fmt::format("{}:{}: '{}' is empty", path.string(), line_of_row(empty - values.begin()), name));
    }
    return values;
}

std::vector<Index> step_column(const DataTable& table, const std::filesystem::path& path) {
    std::vector<Index> steps;
    for (const double value : full_column(table, "step", path)) {
        const bool is_count = value >= 0.0 && value <= largest_step && std::floor(value) == value;
        if (!is_count || (!steps.empty() && static_cast<Index>(value) <= steps.back())) {
            throw DataError(fmt::format("{}:{}: 'step' is {}, allowed: whole numbers that grow from row to row",
                                        path.string(), line_of_row(std::ssize(steps)), value));
        }
        steps.push_back(static_cast<Index>(value));
    }
    return steps;
}

}  // namespace ljmd
