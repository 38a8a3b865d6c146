#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "ljmd/cli/commands.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/text.hpp"
#include "ljmd/io/tables/data_list_csv.hpp"
#include "ljmd/reference/equation_report.hpp"
#include "ljmd/study/sweep_points.hpp"

namespace ljmd {

namespace {

/// The numbers of an option: none if it is not given, several for a range or a list. @throws InputError
std::vector<double> numbers_of(const std::string& option, const std::string& text, bool or_zero) {
    if (text.empty()) {
        return {};
    }
    Diagnostics diagnostics;
    const Location where{std::make_shared<const Source>(Source{option + " " + text, text})};
    std::vector<double> numbers;
    for (const std::string& value : axis_values(text, option, where, diagnostics)) {
        const auto number = to_number(value);
        if (!number || *number < 0.0 || (*number == 0.0 && !or_zero)) {
            throw InputError(
                fmt::format("{}: {} is not allowed: a finite number {} 0", option, value, or_zero ? ">=" : ">"));
        }
        numbers.push_back(*number);
    }
    diagnostics.throw_if_errors();
    return numbers;
}

/// Refuse options that do not go together.
void check_options(const EosOptions& options) {
    if (options.json && options.csv) {
        throw InputError("--json and --csv are two forms of one output: give one of them");
    }
    if (!options.density.empty() && !options.pressure.empty()) {
        throw InputError("--density and --pressure: the equation gives one from the other, give one of them");
    }
    if (!options.temperature.empty() || !options.pressure.empty()) {
        return;
    }
    if (!options.model.empty()) {
        throw InputError("--model wants a --temperature; without one all equations are listed");
    }
    if (!options.density.empty()) {
        throw InputError("--density wants a --temperature");
    }
}

/// A table as CSV, with a text for the phases that are metastable.
std::string csv_of(const Data& points) {
    Data rows = Data::list();
    for (Data point : points.items()) {
        if (const Data* others = point.find("metastable")) {
            Data texts = Data::list();
            for (const Data& other : others->items()) {
                texts.push_back(
                    fmt::format("{} of density {}", other.at("phase").text(), other.at("density").number()));
            }
            point["metastable"] = texts;
        }
        rows.push_back(std::move(point));
    }
    return data_list_csv(rows);
}

Document document_of(const EquationOfState& equation, const EquationPoints& points) {
    if (points.temperatures.empty()) {
        return saturation_document(equation, points.pressures.front());
    }
    const double temperature = points.temperatures.front();
    if (!points.pressures.empty()) {
        return pressure_document(equation, temperature, points.pressures.front());
    }
    return points.densities.empty() ? coexistence_document(equation, temperature)
                                    : state_document(equation, temperature, points.densities.front());
}

}  // namespace

void eos_command(const EosOptions& options) {
    const EquationOfState equation = equation_of_state(options.model.empty() ? "thol2016" : options.model);
    check_options(options);
    if (options.temperature.empty() && options.pressure.empty()) {
        const Document equations = equations_document();
        if (options.csv) {
            print_result(data_list_csv(equations.data));
        } else {
            print_document(equations, options.json);
        }
        return;
    }
    const EquationPoints points{numbers_of("--temperature", options.temperature, false),
                                numbers_of("--density", options.density, true),
                                numbers_of("--pressure", options.pressure, false)};
    const bool one = points.temperatures.size() <= 1 && points.densities.size() <= 1 && points.pressures.size() <= 1;
    if (one) {
        const Document found = document_of(equation, points);
        for (const Data& warning : found.data.at("warnings").items()) {
            warn(warning.text());
        }
        if (!options.csv) {
            print_document(found, options.json);
            return;
        }
    }
    const Document table = points_document(equation, points);
    if (options.csv) {
        print_result(csv_of(table.data.at("points")));
    } else {
        print_document(table, options.json);
    }
}

}  // namespace ljmd
