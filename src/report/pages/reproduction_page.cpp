#include <fmt/format.h>

#include <cmath>

#include "io/files/input_file.hpp"
#include "io/tables/data_table_csv.hpp"
#include "report/pages/study_pages.hpp"
#include "report/quantity_names.hpp"
#include "report/run_charts.hpp"
#include "study/reproduction_report.hpp"
#include "study/study_report.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

bool is_unsound(const std::optional<Printed>& value) {
    return value && value->soundness != Soundness::sound;
}

double value_of(const std::optional<Printed>& value) {
    return value ? value->value : std::nan("");
}

std::string label_of(const ReproducedRow& row) {
    return fmt::format("{:.4g}, {:.4g}", row.verlet.density, row.verlet.temperature);
}

/// One value of every row.
template <class Value>
auto each(const std::vector<ReproducedRow>& rows, const Value& value) {
    std::vector<decltype(value(rows.front()))> values;
    values.reserve(rows.size());
    for (const ReproducedRow& row : rows) {
        values.push_back(value(row));
    }
    return values;
}

Data::List flags(const std::vector<ReproducedRow>& rows, std::optional<Printed> VerletRow::*printed) {
    Data::List list;
    for (const ReproducedRow& row : rows) {
        list.emplace_back(is_unsound(row.verlet.*printed));
    }
    return list;
}

PageTable rows_table(const std::vector<ReproducedRow>& rows) {
    PageTable table{.name = "rows", .title = "The table of 1967", .file = "rows.csv", .lead = true, .flag = "suspect"};
    table.add({"row", "density, temperature"}, each(rows, label_of));
    table.add(described("rho"), each(rows, [](const auto& row) { return row.verlet.density; }));
    table.add(described("T"), each(rows, [](const auto& row) { return row.verlet.temperature; }));
    table.add(described("Z"), each(rows, [](const auto& row) { return row.z.mean; }));
    table.add(described("Z_standard_error"), each(rows, [](const auto& row) { return row.z.standard_error; }));
    table.add({"Z_verlet", "Z, Verlet"},
              each(rows, [](const auto& row) { return value_of(row.verlet.compressibility_factor); }));
    table.add({"Z_thol2016", "Z, Thol 2016"}, each(rows, [](const auto& row) { return row.thol.z; }));
    table.add({"z_score_Z", "z-score of Z"}, each(rows, [](const auto& row) { return row.z_scores().z; }));
    table.add({"Z_suspect", "Z as printed is suspect"}, flags(rows, &VerletRow::compressibility_factor));
    table.add(described("U"), each(rows, [](const auto& row) { return row.u.mean; }));
    table.add(described("U_standard_error"), each(rows, [](const auto& row) { return row.u.standard_error; }));
    table.add({"U_verlet", "U/N, Verlet"},
              each(rows, [](const auto& row) { return value_of(row.verlet.potential_energy); }));
    table.add({"U_thol2016", "U/N, Thol 2016"}, each(rows, [](const auto& row) { return row.thol.u; }));
    table.add({"z_score_U", "z-score of U"}, each(rows, [](const auto& row) { return row.z_scores().u; }));
    table.add({"U_suspect", "U as printed is suspect"}, flags(rows, &VerletRow::potential_energy));
    table.add({"Z_verlet_off", "Z as printed less Z found"},
              each(rows, [](const auto& row) { return value_of(row.verlet.compressibility_factor) - row.z.mean; }));
    table.add({"U_verlet_off", "U/N as printed less U/N found"},
              each(rows, [](const auto& row) { return value_of(row.verlet.potential_energy) - row.u.mean; }));
    Data::List suspect;
    for (const ReproducedRow& row : rows) {
        suspect.emplace_back(is_unsound(row.verlet.compressibility_factor) || is_unsound(row.verlet.potential_energy));
    }
    table.add({"suspect"}, std::move(suspect));
    table.add({"remark"}, each(rows, [](const auto& row) { return remark_of(row); }));
    return table;
}

Chart score_chart(const std::string& quantity) {
    return {.id = "scores-" + quantity,
            .title = fmt::format("z-scores of {}", quantity == "Z" ? "Z" : "U/N"),
            .caption =
                "(found + correction for the cutoff - Thol 2016)/standard error of each row, named by density and "
                "temperature. Two of three should lie between -1 and 1.",
            .lead = true,
            .x = {"z-score"},
            .y = {"density, temperature", "category"},
            .marks = {{.type = "diverging-dots",
                       .label = quantity,
                       .table = "rows",
                       .x = "z_score_" + quantity,
                       .y = "row",
                       .flag = quantity + "_suspect"}}};
}

Chart printed_chart(const std::string& quantity) {
    return {.id = "printed-" + quantity,
            .title = fmt::format("{0} as printed in 1967 less {0} found", quantity == "Z" ? "Z" : "U/N"),
            .caption = "Numbers that every other source contradicts, and those of metastable states, are marked.",
            .x = {"density, temperature", "category"},
            .y = {"printed - found"},
            .marks = {{.type = "rule-y", .label = "", .value = 0.0, .colour = 7},
                      {.type = "dots",
                       .label = quantity,
                       .table = "rows",
                       .x = "row",
                       .y = quantity + "_verlet_off",
                       .error = quantity + "_standard_error",
                       .flag = quantity + "_suspect"}}};
}

/// Z against density: lines of Thol's equation, and the rows.
void add_isotherms(PageContent& page, const fs::path& file) {
    page.tables.push_back(page_table(read_csv(file), "Isotherms of equations of state", "isotherms.csv"));
    page.charts.push_back(
        {.id = "isotherms",
         .title = "Isotherms",
         .caption = "Z = p/(rho T) of the rows, and lines of Thol's equation of state at temperatures "
                    "near theirs. Suspect rows are marked.",
         .lead = true,
         .x = {axis_label("rho")},
         .y = {"Z"},
         .marks = {
             {.type = "line", .label = "Thol 2016", .table = "isotherms", .x = "rho", .y = "Z_thol2016", .group = "T"},
             {.type = "dots", .label = "found", .table = "rows", .x = "rho", .y = "Z", .error = "Z_standard_error"},
             {.type = "dots",
              .label = "Verlet 1967",
              .table = "rows",
              .x = "rho",
              .y = "Z_verlet",
              .flag = "Z_suspect",
              .colour = 1}}});
}

Verdict chi_square_verdict(const ChiSquare& sum) {
    const auto is_likely = [](double value, int count) {
        constexpr double deviations = 3.0;
        return value <= count + deviations * std::sqrt(2.0 * count);  // its mean is the count, its variance twice that
    };
    const bool good = is_likely(sum.z, sum.z_count) && is_likely(sum.u, sum.u_count);
    return {"agreement", good ? "good" : "doubt",
            fmt::format("{} the equation of state of Thol (2016): chi-square of the sound rows is {:.1f} of {} for Z, "
                        "{:.1f} of {} for U.",
                        good ? "Agrees with" : "Differs from", sum.z, sum.z_count, sum.u, sum.u_count)};
}

}  // namespace

PageContent reproduction_page(const fs::path& directory) {
    PageContent page{
        .kind = "reproduction", .title = "Verlet's table of 1967, computed anew", .source = directory.string()};
    const Data study = study_report(directory).data;
    add_study_state(page, study);
    page.points = study_points(study["runs"], directory);
    std::vector<ReproducedRow> rows;
    for (const VerletRow& row : verlet1967_table()) {
        const fs::path run = directory / "rows" / row_name(row);
        if (input_is_there(run / "results.json")) {
            add_if_readable(page.warnings, [&] { rows.push_back(evaluate_row(row, run)); });
        }
    }
    if (rows.empty()) {
        return page;
    }
    page.verdicts.push_back(chi_square_verdict(chi_square(rows)));
    page.tables.push_back(rows_table(rows));
    page.charts = {score_chart("Z"), score_chart("U")};
    if (input_is_there(directory / "isotherms.csv")) {
        add_if_readable(page.warnings, [&] { add_isotherms(page, directory / "isotherms.csv"); });
    }
    page.charts.push_back(printed_chart("Z"));
    page.charts.push_back(printed_chart("U"));
    return page;
}

}  // namespace ljmd
