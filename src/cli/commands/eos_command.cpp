#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/streams.hpp"
#include "core/text.hpp"
#include "input/reduced_number.hpp"
#include "io/tables/data_list_csv.hpp"
#include "ljmd/core/errors.hpp"
#include "reference/equation_report.hpp"
#include "study/sweep_points.hpp"

namespace ljmd {

namespace {

/// Options of `ljmd eos`.
struct EosOptions {
    std::string model{};        ///< empty: thol2016
    std::string temperature{};  ///< a number, FROM:TO:COUNT or A|B|C; empty: not given. Also those below
    std::string density{};
    std::string pressure{};
    bool csv = false;
    bool json = false;
};

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

/// Check of an option that takes a number in reduced units, a range or a list, whose numbers are checked where they
/// are read.
CLI::Validator each_reduced(const std::string& unit, Dimension dimension) {
    return {[=](const std::string& text) {
                const bool several = text.find_first_of(":|") != std::string::npos;
                return several ? std::string() : not_reduced(text, unit, dimension);
            },
            ""};
}

class EosCommand : public Command {
  public:
    EosCommand()
        : Command("eos", Part::studies,
                  "equations of state of the Lennard-Jones fluid: a state from a temperature with a density "
                  "or a pressure; coexistence from a temperature or a pressure alone; tables from ranges") {}

    void add_options(CLI::App& command) override {
        command.add_option("--temperature", options_.temperature, "in epsilon/k_B: a number, FROM:TO:COUNT or A|B|C")
            ->type_name("T")
            ->check(each_reduced("epsilon/k_B", Dimension::temperature));
        command.add_option("--density", options_.density, "atoms per sigma^3, as the temperature")
            ->type_name("RHO")
            ->check(each_reduced("atoms per sigma^3", Dimension::density));
        command
            .add_option("--pressure", options_.pressure, "in epsilon/sigma^3, as the temperature; instead of a density")
            ->type_name("P")
            ->check(each_reduced("epsilon/sigma^3", Dimension::pressure));
        command.add_option("--model", options_.model, "one that `ljmd eos` lists, thol2016 by default")
            ->type_name("EQUATION");
        command.add_flag("--csv", options_.csv, "print it as CSV, with a column for each property");
        command.add_flag("--json", options_.json, "print it as JSON");
    }

    void run() override {
        const EquationOfState equation = equation_of_state(options_.model.empty() ? "thol2016" : options_.model);
        check_options(options_);
        if (options_.temperature.empty() && options_.pressure.empty()) {
            const Document equations = equations_document();
            if (options_.csv) {
                print_result(data_list_csv(equations.data));
            } else {
                print_document(equations, options_.json);
            }
            return;
        }
        const EquationPoints points{numbers_of("--temperature", options_.temperature, false),
                                    numbers_of("--density", options_.density, true),
                                    numbers_of("--pressure", options_.pressure, false)};
        const bool one =
            points.temperatures.size() <= 1 && points.densities.size() <= 1 && points.pressures.size() <= 1;
        if (one) {
            const Document found = document_of(equation, points);
            for (const Data& warning : found.data.at("warnings").items()) {
                warn(warning.text());
            }
            if (!options_.csv) {
                print_document(found, options_.json);
                return;
            }
        }
        const Document table = points_document(equation, points);
        if (options_.csv) {
            print_result(csv_of(table.data.at("points")));
        } else {
            print_document(table, options_.json);
        }
    }

  private:
    EosOptions options_;
};

}  // namespace

std::shared_ptr<Command> eos_command() {
    return std::make_shared<EosCommand>();
}

}  // namespace ljmd
