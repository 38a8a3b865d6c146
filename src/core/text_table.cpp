#include "core/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/number_text.hpp"
#include "core/text.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr std::size_t narrowest = 4;  // that the first column is made

}  // namespace

TextTable::TextTable(std::vector<Column> columns, std::size_t indent) : indent_(indent) {
    std::vector<std::string> headings;
    for (Column& column : columns) {
        aligned_.push_back(column.align);
        gaps_.push_back(column.gap);
        widths_.push_back(column.width);
        headings.push_back(std::move(column.heading));
    }
    add(headings);
}

TextTable::Entry TextTable::entry_of(const std::string& text) {
    const std::vector<std::string> characters = printable_characters(without_negative_zero(text));
    Entry entry{"", characters.size()};
    for (const std::string& character : characters) {
        entry.shown += character;
    }
    return entry;
}

void TextTable::add(const std::vector<std::string>& entries) {
    if (entries.size() > widths_.size()) {
        throw ContractViolation(fmt::format("{} entries in a table of {} columns", entries.size(), widths_.size()));
    }
    std::vector<Entry> row;
    for (std::size_t k = 0; k < entries.size(); ++k) {
        row.push_back(entry_of(entries[k]));
        widths_[k] = std::max(widths_[k], row.back().characters);
    }
    rows_.push_back(std::move(row));
}

std::string TextTable::text() const {
    return text_of(widths_);
}

std::size_t TextTable::columns() const {
    std::size_t all = indent_;
    for (std::size_t k = 0; k < widths_.size(); ++k) {
        all += widths_[k] > 0 ? widths_[k] + (all > indent_ ? gaps_[k] : 0) : 0;
    }
    return all;
}

std::string TextTable::text_within(std::size_t columns) const {
    const std::size_t all = this->columns();
    std::vector<std::size_t> widths = widths_;
    if (all > columns) {
        const std::size_t excess = all - columns;
        widths.front() = std::max(narrowest, widths.front() - std::min(excess, widths.front()));
    }
    return text_of(widths);
}

std::string TextTable::text_of(const std::vector<std::size_t>& widths) const {
    const bool headed = std::ranges::any_of(rows_.front(), [](const Entry& entry) { return !entry.shown.empty(); });
    const auto end_line = [](std::string line) {
        line.resize(line.find_last_not_of(' ') + 1);
        return line + '\n';
    };
    std::string text;
    for (std::size_t row = headed ? 0 : 1; row < rows_.size(); ++row) {
        std::string line(indent_, ' ');
        for (std::size_t k = 0; k < rows_[row].size(); ++k) {
            if (widths[k] == 0) {
                continue;
            }
            const Entry& entry = rows_[row][k];
            line += std::string(line.size() > indent_ ? gaps_[k] : 0, ' ');
            if (entry.characters > widths[k]) {  // of the first column
                text += end_line(line + entry.shown);
                line += std::string(widths[k], ' ');
                continue;
            }
            const std::string blanks(widths[k] - entry.characters, ' ');
            line += aligned_[k] == Align::right ? blanks + entry.shown : entry.shown + blanks;
        }
        text += end_line(line);
    }
    return text;
}

std::pair<std::string, std::string> mean_and_error(double mean, double error) {
    constexpr std::string_view between = " +- ";
    const std::string both = with_error(mean, error);
    const std::size_t at = both.find(between);
    if (at == std::string::npos) {
        return {both, error == 0.0 ? "0" : "-"};
    }
    return {both.substr(0, at), both.substr(at + between.size())};
}

}  // namespace ljmd
