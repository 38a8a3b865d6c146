#include "study/reproduction_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/text.hpp"
#include "core/text_table.hpp"
#include "io/tables/csv_text.hpp"
#include "io/tables/data_table_csv.hpp"
#include "study/error_in_brackets.hpp"

namespace ljmd {

namespace {

// Verlet's numbers are printed with two decimals; their errors are about as large.
constexpr double printed_error_z = 0.05;
constexpr double printed_error_u = 0.03;

std::string printed(const std::optional<Printed>& value) {
    if (!value) {
        return "";
    }
    const char* mark = value->soundness == Soundness::suspect      ? "?"
                       : value->soundness == Soundness::metastable ? "m"
                                                                   : "";
    return fmt::format("{:.2f}{}", value->value, mark);
}

const char* name_of(Soundness soundness) {
    switch (soundness) {
        case Soundness::sound:
            return "sound";
        case Soundness::suspect:
            return "suspect";
        case Soundness::metastable:
            return "metastable";
    }
    return "";
}

/// A column of the table: its name and the text for a row.
struct Column {
    const char* name;
    std::string (*text)(const ReproducedRow&);
    bool dispensable = false;  ///< left out on a narrow terminal
};

const std::vector<Column>& columns() {
    static const std::vector<Column> all{
        {"rho", [](const ReproducedRow& row) { return fmt::format("{:.4f}", row.verlet.density); }},
        {"T", [](const ReproducedRow& row) { return fmt::format("{:.3f}", row.verlet.temperature); }},
        {"Z", [](const ReproducedRow& row) { return with_error_in_brackets(row.z.mean, row.z.standard_error); }},
        {"Verlet", [](const ReproducedRow& row) { return printed(row.verlet.compressibility_factor); }},
        {"Thol", [](const ReproducedRow& row) { return fmt::format("{:.3f}", row.thol.z); }},
        {"cutoff", [](const ReproducedRow& row) { return fmt::format("{:+.3f}", row.beyond_cutoff.z); }, true},
        {"z", [](const ReproducedRow& row) { return fmt::format("{:+.1f}", row.z_scores().z); }},
        {"U", [](const ReproducedRow& row) { return with_error_in_brackets(row.u.mean, row.u.standard_error); }},
        {"Verlet", [](const ReproducedRow& row) { return printed(row.verlet.potential_energy); }},
        {"Thol", [](const ReproducedRow& row) { return fmt::format("{:.3f}", row.thol.u); }},
        {"cutoff", [](const ReproducedRow& row) { return fmt::format("{:+.4f}", row.beyond_cutoff.u); }, true},
        {"z", [](const ReproducedRow& row) { return fmt::format("{:+.1f}", row.z_scores().u); }}};
    return all;
}

constexpr const char* legend =
    "Z = p/(rho T) and U per atom at Verlet's temperatures, in brackets the standard error of the last digits; Verlet "
    "(1967):\n"
    "? contradicted by every other source, m metastable; Thol: equation of state of 2016; cutoff: what g(r) adds "
    "beyond 2.5;\n"
    "z: (found + cutoff - Thol)/standard error.";

std::string chi_square_line(const std::vector<ReproducedRow>& rows) {
    const ChiSquare sum = chi_square(rows);
    return fmt::format("chi-square of the rows that are sound: Z {:.1f} of {}, U {:.1f} of {}", sum.z, sum.z_count,
                       sum.u, sum.u_count);
}

Data data_of(const std::optional<Printed>& value) {
    return value ? Data{{"value", value->value}, {"soundness", name_of(value->soundness)}} : Data(nullptr);
}

/// The table with columns of one width, or with columns that are as narrow as their entries.
TextTable table_of(const std::vector<ReproducedRow>& rows, const std::vector<Column>& shown, bool roomy) {
    std::vector<TextTable::Column> headings;
    for (const Column& column : shown) {
        const std::size_t width = headings.size() < 2 ? 6 : 10;
        headings.push_back({column.name, TextTable::Align::right, roomy ? width : 0, roomy ? 2u : 1u});
    }
    TextTable table(std::move(headings), roomy ? 2 : 0);
    for (const ReproducedRow& row : rows) {
        std::vector<std::string> entries;
        entries.reserve(shown.size());
        for (const Column& column : shown) {
            entries.push_back(column.text(row));
        }
        table.add(entries);
    }
    return table;
}

/// The table that fits a screen; without one, the whole table.
std::string table_text(const std::vector<ReproducedRow>& rows, std::optional<std::size_t> screen) {
    const TextTable whole = table_of(rows, columns(), true);
    if (!screen || whole.columns() <= *screen) {
        return whole.text();
    }
    const TextTable close = table_of(rows, columns(), false);
    if (close.columns() <= *screen) {
        return close.text();
    }
    std::vector<Column> shown = columns();
    std::erase_if(shown, [](const Column& column) { return column.dispensable; });
    return table_of(rows, shown, false).text() + "left out here: cutoff (rows.csv has it)\n";
}

std::string text_of(const std::vector<ReproducedRow>& rows, std::optional<std::size_t> screen) {
    const auto paragraph = [&](std::string text, std::size_t indent) {
        return (screen ? wrapped(text, *screen, indent) : std::move(text)) + '\n';
    };
    std::string text = table_text(rows, screen) + '\n';
    if (screen) {
        std::string in_one_line = legend;
        std::ranges::replace(in_one_line, '\n', ' ');
        text += paragraph(in_one_line, 0);
    } else {
        text += paragraph(legend, 0);
    }
    text += paragraph(chi_square_line(rows), 2);
    for (const ReproducedRow& row : rows) {
        if (const std::string remark = remark_of(row); !remark.empty()) {
            text +=
                paragraph(fmt::format("  {:.4f} {:.3f}: {}", row.verlet.density, row.verlet.temperature, remark), 4);
        }
    }
    return text;
}

Data data_of(const std::vector<ReproducedRow>& rows) {
    Data list = Data::list();
    for (const ReproducedRow& row : rows) {
        const auto [score_z, score_u] = row.z_scores();
        list.push_back({{"rho", row.verlet.density},
                        {"T", row.verlet.temperature},
                        {"T_measured", row.temperature.mean},
                        {"T_standard_error", row.temperature.standard_error},
                        {"Z", row.z.mean},
                        {"Z_standard_error", row.z.standard_error},
                        {"U", row.u.mean},
                        {"U_standard_error", row.u.standard_error},
                        {"Z_beyond_cutoff", row.beyond_cutoff.z},
                        {"U_beyond_cutoff", row.beyond_cutoff.u},
                        {"Z_verlet", data_of(row.verlet.compressibility_factor)},
                        {"U_verlet", data_of(row.verlet.potential_energy)},
                        {"Z_thol2016", row.thol.z},
                        {"U_thol2016", row.thol.u},
                        {"Z_kolafa_nezbeda1994", row.kolafa.z},
                        {"U_kolafa_nezbeda1994", row.kolafa.u},
                        {"z_score_Z", score_z},
                        {"z_score_U", score_u},
                        {"steps", row.steps},
                        {"remark", remark_of(row)}});
    }
    const ChiSquare sum = chi_square(rows);
    return {{"rows", list},
            {"chi_square", {{"Z", sum.z}, {"Z_rows", sum.z_count}, {"U", sum.u}, {"U_rows", sum.u_count}}}};
}

}  // namespace

std::string remark_of(const ReproducedRow& row) {
    std::string text = row.verlet.remark;
    const auto judge = [&](const char* name, const std::optional<Printed>& value, double found, double thol,
                           double limit) {
        if (text.empty() && value && std::abs(value->value - found) > limit && std::abs(thol - found) < limit) {
            text = fmt::format("{} as printed is {:+.2f} off, equations of state agree with what was found", name,
                               value->value - found);
        }
    };
    judge("Z", row.verlet.compressibility_factor, row.z.mean, row.thol.z, printed_error_z);
    judge("U", row.verlet.potential_energy, row.u.mean, row.thol.u, printed_error_u);
    return text;
}

Document reproduction_report(const std::vector<ReproducedRow>& rows, std::optional<std::size_t> screen) {
    return {data_of(rows), text_of(rows, screen)};
}

std::string reproduction_markdown(const std::vector<ReproducedRow>& rows) {
    std::string text = "|";
    std::string rule = "|";
    for (const Column& column : columns()) {
        text += fmt::format(" {} |", column.name);
        rule += "---:|";
    }
    text += " remark |\n" + rule + "---|\n";
    for (const ReproducedRow& row : rows) {
        text += "|";
        for (const Column& column : columns()) {
            text += fmt::format(" {} |", column.text(row));
        }
        text += fmt::format(" {} |\n", remark_of(row));
    }
    return fmt::format("{}\n{}\n\n{}.\n", text, legend, chi_square_line(rows));
}

std::string reproduction_csv(const std::vector<ReproducedRow>& rows) {
    std::string text =
        "rho,T,T_measured,T_standard_error,Z,Z_standard_error,U,U_standard_error,Z_beyond_cutoff,U_beyond_cutoff,"
        "Z_verlet,U_verlet,Z_thol2016,U_thol2016,Z_kolafa_nezbeda1994,U_kolafa_nezbeda1994,z_score_Z,z_score_U,steps,"
        "Z_verlet_soundness,U_verlet_soundness,remark\n";
    const auto value = [](const std::optional<Printed>& number) {
        return number ? fmt::format("{}", number->value) : "";
    };
    const auto soundness = [](const std::optional<Printed>& number) {
        return number ? name_of(number->soundness) : "";
    };
    for (const ReproducedRow& row : rows) {
        const auto [score_z, score_u] = row.z_scores();
        const auto& [rho, t, z, u, remark] = row.verlet;
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", rho, t,
                            row.temperature.mean, row.temperature.standard_error, row.z.mean, row.z.standard_error,
                            row.u.mean, row.u.standard_error, row.beyond_cutoff.z, row.beyond_cutoff.u, value(z),
                            value(u), row.thol.z, row.thol.u, row.kolafa.z, row.kolafa.u, score_z, score_u, row.steps,
                            soundness(z), soundness(u), csv_field(remark_of(row)));
    }
    return text;
}

std::string isotherms_csv() {
    constexpr std::array temperatures{0.75, 1.0, 1.35, 1.75, 2.75, 4.5};
    constexpr double densest = 0.9;
    constexpr double step = 0.01;
    constexpr int steps = 60;
    const EquationOfState thol = equation_of_state("thol2016");
    const EquationOfState kolafa = equation_of_state("kolafa-nezbeda1994");
    DataTable table{"isotherms", {"T", "rho", "Z_thol2016", "Z_kolafa_nezbeda1994"}, {}};
    for (const double t : temperatures) {
        std::vector<std::vector<double>> isotherm;  // from the dense end, as long as the fluid is stable or metastable
        for (int k = 0; k <= steps; ++k) {
            const double rho = densest - k * step;
            const FluidProperties state = properties(thol, t, rho);
            if (state.pressure_density_slope <= 0.0) {
                break;
            }
            isotherm.push_back(
                {t, rho, state.compressibility_factor, properties(kolafa, t, rho).compressibility_factor});
        }
        table.rows.insert(table.rows.end(), isotherm.rbegin(), isotherm.rend());
    }
    return to_csv(table);
}

}  // namespace ljmd
