#include "ljmd/io/data_table_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace ljmd {

std::string to_csv(const DataTable& table) {
    std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
    for (const auto& row : table.rows) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            text += k == 0 ? "" : ",";
            text += std::isnan(row[k]) ? "" : fmt::format("{}", row[k]);
        }
        text += '\n';
    }
    return text;
}

}  // namespace ljmd
