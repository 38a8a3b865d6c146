#include "run/results.hpp"

#include <cmath>
#include <limits>
#include <sstream>

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

ObservableAverage average(const std::string& name, const std::string& unit, double mean, double error,
                          double independent = 100.0) {
    return {name, "X", unit, Estimate{mean, error, independent, 1000, true}};
}

/// A run of argon's state near the triple point, as Verlet's; two stages.
RunResult some_result() {
    return {.atoms = 864,
            .density = 0.8442,
            .edges = Vec3(10.0, 10.5, 11.0),
            .averages = {average("temperature", "epsilon/k_B", 0.722, 0.0021),
                         average("potential_energy", "epsilon", -6.08712, 0.00123),
                         average("pressure", "epsilon/sigma^3", 0.5, 0.25),
                         average("compressibility_factor", "1", 0.9, unknown, unknown)},
            .requested_temperature = 0.722,
            .at_requested = std::nullopt,
            .equation_of_state = std::nullopt,
            .order_at_sampling = 0.0125,
            .stages = {{"equilibrate", "velocity-verlet", 0, 5000, 0.004, false, true, false, std::nullopt, "a", "b"},
                       {"production", "velocity-verlet", 5000, 25000, 0.004, true, false, false, -1.5e-7, "b", "c"}},
            .tables = {},
            .warnings = {"a doubt"},
            .search = {},
            .seconds = {},
            .first = {},
            .last = {}};
}

Deck deck_with(const std::string& extra) {
    return DeckFolder(small_deck + extra).load();
}

/// The line of a table that begins so.
std::string line_of_table(const std::string& table, const std::string& beginning) {
    const std::size_t begin = table.find("\n  " + beginning);
    INFO(table);
    REQUIRE(begin != std::string::npos);
    return table.substr(begin + 1, table.find('\n', begin + 1) - begin - 1);
}

/// What the table makes of a mean and its error.
std::string shown_with_error(double mean, double error) {
    RunResult result = some_result();
    result.averages = {average("pressure", "unit", mean, error)};
    const std::string line = line_of_table(results_report(deck_with(""), result).text, "pressure");
    const std::string text = line.substr(line.find_first_not_of(' ', line.find(" X ") + 3));
    return text.substr(0, text.find("  "));
}

}  // namespace

TEST_CASE("results.json has the keys that scripts rely on") {
    const Data json = results_report(deck_with(""), some_result()).data;
    const Data& temperature = json.at("observables").at("temperature");
    CHECK(temperature.at("mean") == 0.722);
    CHECK(temperature.at("standard_error") == 0.0021);
    CHECK(temperature.at("independent_samples") == 100.0);
    CHECK(temperature.at("unit") == "epsilon/k_B");
    CHECK(temperature.at("samples") == 1000);
    CHECK(temperature.at("error_is_converged") == true);
    CHECK_FALSE(temperature.contains("si"));
    REQUIRE(json.at("stages").size() == 2);
    const Data& production = json.at("stages")[1];
    CHECK(production.at("name") == "production");
    CHECK(production.at("steps") == 20000);
    CHECK(production.at("first_step") == 5000);
    CHECK(production.at("energy_drift") == -1.5e-7);
    CHECK(json.at("stages")[0].at("energy_drift").is_null());
    CHECK(json.at("title") == "A small liquid");
    CHECK(json.at("system").at("atoms") == 864);
    CHECK(json.at("system").at("density") == 0.8442);
    CHECK(json.at("system").at("box_edges") == Data::list({10.0, 10.5, 11.0}));
    CHECK_FALSE(json.at("system").contains("density_g_per_cm3"));
    CHECK(json.at("translational_order_at_sampling") == 0.0125);
    CHECK(json.at("warnings") == Data::list({"a doubt"}));
}

TEST_CASE("what a run has at the temperature that was asked stands in results.json and below the table") {
    RunResult result = some_result();
    const Data found = results_report(deck_with(""), result).data;
    CHECK(found.at("asked_temperature") == 0.722);
    CHECK(found.at("at_asked_temperature").is_null());
    CHECK_THAT(results_report(deck_with(""), result).text, !Contains("brought to"));
    result.at_requested =
        AtRequestedTemperature{0.73, "thol2016", {average("pressure", "epsilon/sigma^3", 0.52, 0.011)}};
    const Data there = results_report(deck_with(""), result).data.at("at_asked_temperature");
    CHECK(there.at("temperature") == 0.73);
    CHECK(there.at("equation_of_state") == "thol2016");
    CHECK(there.at("observables").at("pressure").at("mean") == 0.52);
    CHECK(there.at("observables").at("pressure").at("standard_error") == 0.011);
    const std::string table = results_report(deck_with(""), result).text;
    const std::size_t line = table.find("  brought to T = 0.73, which was asked, by the equation of state thol2016:\n");
    REQUIRE(line != std::string::npos);
    CHECK_THAT(table.substr(line), Contains("pressure") && Contains("0.520 +- 0.011"));
    CHECK(found.at("equation_of_state").is_null());
    result.equation_of_state = "thol2016";
    CHECK(results_report(deck_with(""), result).data.at("equation_of_state") == "thol2016");
    result.requested_temperature.reset();
    CHECK(results_report(deck_with(""), result).data.at("asked_temperature").is_null());
}

TEST_CASE("what is not known is null in results.json") {
    RunResult result = some_result();
    result.averages.push_back({"virial", "W", "epsilon", std::nullopt});
    result.averages.push_back(
        average("total_energy", "epsilon", std::numeric_limits<double>::infinity(), unknown, unknown));
    result.order_at_sampling.reset();
    const Data json = results_report(deck_with(argon_table), result).data;
    for (const char* key : {"mean", "standard_error", "independent_samples"}) {
        CHECK(json.at("observables").at("virial").at(key).is_null());
        CHECK(json.at("observables").at("total_energy").at(key).is_null());
    }
    CHECK(json.at("observables").at("compressibility_factor").at("mean") == 0.9);
    CHECK(json.at("observables").at("compressibility_factor").at("standard_error").is_null());
    CHECK(json.at("observables").at("virial").at("unit") == "epsilon");
    CHECK(json.at("translational_order_at_sampling").is_null());
    CHECK(results_report(deck_with(""), RunResult{}).data.at("observables").is_object());
}

TEST_CASE("a substance adds kelvin, kJ/mol, bar and g/cm3") {
    const Data json = results_report(deck_with(argon_table), some_result()).data;
    const auto si = [&](const char* name) { return json.at("observables").at(name).at("si"); };
    CHECK(si("temperature").at("unit") == "K");
    CHECK(si("temperature").at("mean").number() == Approx(0.722 * 119.8).epsilon(1e-12));
    CHECK(si("temperature").at("standard_error").number() == Approx(0.0021 * 119.8).epsilon(1e-12));
    // epsilon = 119.8 k_B N_A = 0.996072 kJ/mol; epsilon/sigma^3 = 119.8 k_B/(3.405 A)^3 = 418.98 bar
    CHECK(si("potential_energy").at("unit") == "kJ/mol");
    CHECK(si("potential_energy").at("mean").number() == Approx(-6.08712 * 0.996072).epsilon(1e-5));
    CHECK(si("pressure").at("unit") == "bar");
    CHECK(si("pressure").at("mean").number() == Approx(0.5 * 418.98).epsilon(1e-4));
    CHECK_FALSE(json.at("observables").at("compressibility_factor").contains("si"));
    // 39.948 u/(3.405 A)^3 = 1.68033 g/cm3
    CHECK(json.at("system").at("density_g_per_cm3").number() == Approx(0.8442 * 1.68033).epsilon(1e-5));
}

TEST_CASE("an error is told to two digits, its mean to as many decimals") {
    CHECK(shown_with_error(-6.08712, 0.00123) == "-6.0871 +- 0.0012");
    CHECK(shown_with_error(0.722, 0.021) == "0.722 +- 0.021");
    CHECK(shown_with_error(0.5, 0.25) == "0.50 +- 0.25");
    CHECK(shown_with_error(1234.567, 12.3) == "1235 +- 12");
    CHECK(shown_with_error(1234.567, 123.0) == "1235 +- 123");
    CHECK(shown_with_error(1.5, 0.0) == "1.5");
    CHECK(shown_with_error(1.23456789, unknown) == "1.23457");
}

TEST_CASE("the table of a run shows what people look for, in SI too for a substance") {
    RunResult result = some_result();
    result.averages.push_back({"kinetic_energy", "K", "epsilon", std::nullopt});
    result.averages.push_back(average("pressure_xy", "epsilon/sigma^3", 0.0, 0.1));
    const std::string reduced = results_report(deck_with(""), result).text;
    CHECK_THAT(reduced,
               Catch::StartsWith("A small liquid\n864 atoms, density 0.8442 sigma^-3, box 10 x 10.5 x 11 sigma^3\n"));
    CHECK_THAT(line_of_table(reduced, "temperature"),
               Contains("0.7220 +- 0.0021") && Contains("epsilon/k_B") && Catch::EndsWith(" 100"));
    CHECK_THAT(line_of_table(reduced, "compressibility_factor"), Contains(" 0.9 ") && Catch::EndsWith(" -"));
    CHECK_THAT(line_of_table(reduced, "kinetic_energy"), Contains("no value"));
    CHECK_THAT(line_of_table(reduced, "energy drift"), Contains("'production': -1.5e-07 epsilon per atom and tau"));
    CHECK_THAT(reduced, !Contains("pressure_xy") && !Contains("equilibrate"));
    const std::string argon = results_report(deck_with(argon_table), result).text;
    const std::string si = argon.substr(argon.find("\n  in SI units "));
    CHECK_THAT(line_of_table(si, "temperature"), Catch::EndsWith(" 86.50 +- 0.25  K"));
    CHECK_THAT(line_of_table(si, "potential_energy"), Catch::EndsWith(" -6.0632 +- 0.0012  kJ/mol"));
    CHECK_THAT(si, !Contains("compressibility_factor") && !Contains("kinetic_energy"));
    CHECK_THAT(reduced, !Contains("in SI units"));
    CHECK_THAT(argon, Contains("density 0.8442 sigma^-3 (1.4185 g/cm3)"));
}

TEST_CASE("a remark stands where its number stands, and is told once") {
    RunResult result = some_result();
    result.averages[0].remark = "asked for 1.0";
    result.averages[1].remark = "few samples";
    result.averages[2].remark = "few samples";
    result.averages.push_back({"viscosity", "eta", "epsilon tau/sigma^3", std::nullopt, "frames too far apart"});
    const std::string table = results_report(deck_with(""), result).text;
    CHECK_THAT(line_of_table(table, "temperature"), Contains("0.7220 +- 0.0021 [1]  epsilon/k_B"));
    CHECK_THAT(line_of_table(table, "potential_energy"), Contains("-6.0871 +- 0.0012 [2]  epsilon"));
    CHECK_THAT(line_of_table(table, "pressure"), Contains("0.50 +- 0.25 [2]  epsilon/sigma^3"));
    CHECK_THAT(line_of_table(table, "viscosity"), Catch::EndsWith("no value [3]"));
    CHECK_THAT(line_of_table(table, "compressibility_factor"), !Contains("["));
    CHECK_THAT(table, Contains("\n  [1] asked for 1.0\n  [2] few samples\n  [3] frames too far apart\n"));
    const Data observables = results_report(deck_with(""), result).data.at("observables");
    CHECK(observables.at("pressure").at("remark") == "few samples");
    CHECK(observables.at("viscosity").at("remark") == "frames too far apart");
    CHECK(observables.at("viscosity").at("mean").is_null());
    CHECK_FALSE(observables.at("compressibility_factor").contains("remark"));
}

TEST_CASE("the table fits a screen of 80 columns, whatever the names and the remarks are") {
    RunResult result = some_result();
    result.averages[3].remark =
        "a remark that is so long that it has to go on in the line below the one that it began in";
    result.averages.push_back(average("viscosity", "epsilon tau/sigma^3", 3.25, 0.1));
    result.averages.push_back(average("diffusion_infinite_system", "sigma^2/tau", 0.0313, 0.0000004));
    result.averages.push_back(
        {std::string(60, 'n'), "X", "1", Estimate{1234567.0, 0.000012, 1e6, 1000000, false}, "", true});
    result.doubts = {"sampling began with 61 % of the crystal left (translational order 0.600): equilibrate longer"};
    for (const std::string& extra : {std::string(), argon_table}) {
        const std::string text = results_report(deck_with(extra), result).text;
        std::istringstream lines(text.substr(0, text.find("files: ")));
        for (std::string line; std::getline(lines, line);) {
            INFO(line);
            CHECK(line.size() <= 80);
        }
        CHECK_THAT(text, Contains("\n  " + std::string(60, 'n') + "\n"));
        CHECK_THAT(text, Contains("\n  warning: sampling began with 61 % of the crystal left (translational order\n    "
                                  "0.600): equilibrate longer\n"));
    }
    CHECK(results_report(deck_with(""), result).data.at("doubts").size() == 1);
}

TEST_CASE("an error bar that is a guess is marked where it stands") {
    RunResult result = some_result();
    result.averages[0].estimate->converged = false;
    result.averages[1].estimate->converged = false;
    result.averages[1].remark = "asked for 1.0";
    const std::string table = results_report(deck_with(""), result).text;
    CHECK_THAT(line_of_table(table, result.averages[0].name), Contains("[1]"));
    CHECK_THAT(line_of_table(table, result.averages[1].name), Contains("[2]"));
    CHECK_THAT(table,
               Contains("  [1] its error bar is a guess") && Contains("  [2] asked for 1.0; its error bar is a guess"));
    const Data observables = results_report(deck_with(""), result).data.at("observables");
    CHECK(observables.at(result.averages[0].name).at("remark") == std::string(guessed_error));
    // Where no error is given there is none to doubt.
    result.averages[0].estimate->standard_error = unknown;
    CHECK(remark_of(result.averages[0]).empty());
}

TEST_CASE("transport, heat capacity and viscosity have the units of a substance, too") {
    RunResult result = some_result();
    result.averages = {
        average("diffusion", "sigma^2/tau", 0.0313, 0.0004), average("viscosity", "epsilon tau/sigma^3", 3.25, 0.1),
        average("heat_capacity_cv", "k_B", 2.63, 0.01), average("thermal_conductivity", "k_B/(sigma tau)", 7.0, 0.1)};
    const Data json = results_report(deck_with(argon_table), result).data;
    const auto si = [&](const char* name) { return json.at("observables").at(name).at("si"); };
    // tau = (m sigma^2/epsilon)^(1/2) = 2.1563 ps: sigma^2/tau = 53.768 nm^2/ns, epsilon tau/sigma^3 = 0.090345 mPa s
    CHECK(si("diffusion").at("unit") == "nm^2/ns");
    CHECK(si("diffusion").at("mean").number() == Approx(0.0313 * 53.768).epsilon(1e-4));
    CHECK(si("viscosity").at("unit") == "mPa s");
    CHECK(si("viscosity").at("mean").number() == Approx(3.25 * 0.090345).epsilon(1e-4));
    // k_B/(sigma tau) = 1.380649e-23 J/K/(0.3405 nm 2.1563 ps) = 18.804 mW/(m K)
    CHECK(si("thermal_conductivity").at("unit") == "mW/(m K)");
    CHECK(si("thermal_conductivity").at("mean").number() == Approx(7.0 * 18.804).epsilon(1e-4));
    CHECK(si("heat_capacity_cv").at("unit") == "J/(mol K)");
    CHECK(si("heat_capacity_cv").at("mean").number() == Approx(2.63 * 8.314462618).epsilon(1e-9));
}

TEST_CASE("lengths, times and wave numbers in tables stand in nanometres and picoseconds too for a substance") {
    const DataTable table{"rdf", {"r", "g"}, {{1.0, 0.5}, {2.0, 1.5}}};
    const SubstanceUnits argon(3.405e-10, 1.65e-21, 6.63e-26);
    const DataTable si = with_si_columns(table, argon);
    CHECK(si.columns == std::vector<std::string>{"r", "g", "r_nm"});
    REQUIRE(si.rows.size() == 2);
    CHECK(si.rows[1][1] == 1.5);
    CHECK(si.rows[1][2] == Approx(0.681).epsilon(1e-14));
    CHECK(with_si_columns(table, std::nullopt).columns == table.columns);
    const DataTable msd = with_si_columns({"msd", {"time", "msd", "msd_standard_error"}, {{2.0, 3.0, 0.1}}}, argon);
    CHECK(msd.columns == std::vector<std::string>{"time", "msd", "msd_standard_error", "time_ps", "msd_nm2"});
    CHECK(msd.rows[0][3] == Approx(2.0 * argon.picosecond()).epsilon(1e-14));
    CHECK(msd.rows[0][4] == Approx(3.0 * 0.3405 * 0.3405).epsilon(1e-14));
    const DataTable sk = with_si_columns({"sk", {"k", "S"}, {{6.8, 2.0}}}, argon);
    CHECK(sk.columns.back() == "k_per_nm");
    CHECK(sk.rows[0][2] == Approx(6.8 / 0.3405).epsilon(1e-14));
}
