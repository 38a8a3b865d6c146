#include "io/tables/data_list_csv.hpp"

#include <algorithm>
#include <vector>

#include "io/tables/csv_text.hpp"
#include "io/tables/json_text.hpp"

namespace ljmd {

namespace {

/// A field with the name of its column.
struct Field {
    std::string column;
    std::string text;
};

bool is_of_texts(const Data& list) {
    return std::ranges::all_of(list.items(), [](const Data& item) { return item.is_text(); });
}

std::string joined(const Data& texts) {
    std::string text;
    for (const Data& item : texts.items()) {
        text += (text.empty() ? "" : "; ") + item.text();
    }
    return text;
}

void add_fields(const Data& object, const std::string& prefix, std::vector<Field>& fields) {
    for (const auto& [key, value] : object.members()) {
        const std::string column = prefix + key;
        if (value.is_object()) {
            add_fields(value, column + "_", fields);
        } else if (value.is_list()) {
            if (is_of_texts(value)) {
                fields.push_back({column, joined(value)});
            }
        } else {
            fields.push_back({column, value.is_null() ? "" : value.is_text() ? value.text() : to_json(value)});
        }
    }
}

}  // namespace

std::string data_list_csv(const Data& objects) {
    std::vector<std::vector<Field>> rows;
    std::vector<std::string> columns;
    for (const Data& object : objects.items()) {
        std::vector<Field>& row = rows.emplace_back();
        add_fields(object, "", row);
        for (const Field& field : row) {
            if (std::ranges::find(columns, field.column) == columns.end()) {
                columns.push_back(field.column);
            }
        }
    }
    const auto line = [](const std::vector<std::string>& fields) {
        std::string text;
        for (std::size_t k = 0; k < fields.size(); ++k) {
            text += (k == 0 ? "" : ",") + csv_field(fields[k]);
        }
        return text + '\n';
    };
    std::string text = line(columns);
    for (const std::vector<Field>& row : rows) {
        std::vector<std::string> fields;
        fields.reserve(columns.size());
        for (const std::string& column : columns) {
            const auto found = std::ranges::find(row, column, &Field::column);
            fields.push_back(found == row.end() ? "" : found->text);
        }
        text += line(fields);
    }
    return text;
}

}  // namespace ljmd
