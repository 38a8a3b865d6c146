#include "io/tables/thermo_csv.hpp"

#include <charconv>
#include <map>
#include <string>
#include <vector>
#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

using Row = std::vector<std::string>;

/// Lines of a file, cut at commas.
std::vector<Row> rows_of(const std::string& text) {
    std::vector<Row> rows;
    std::size_t start = 0;
    while (start < text.size()) {
        const std::size_t end = text.find('\n', start);
        REQUIRE(end != std::string::npos);  // the last line is complete
        Row row(1);
        for (const char c : text.substr(start, end - start)) {
            if (c == ',') {
                row.emplace_back();
            } else {
                row.back() += c;
            }
        }
        rows.push_back(row);
        start = end + 1;
    }
    return rows;
}

double number(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    REQUIRE(error == std::errc());
    REQUIRE(end == text.data() + text.size());
    return value;
}

/// One row as column -> field.
std::map<std::string, std::string> fields(const std::vector<Row>& rows, std::size_t row) {
    REQUIRE(rows.size() > row);
    REQUIRE(rows[row].size() == rows[0].size());
    std::map<std::string, std::string> result;
    for (std::size_t k = 0; k < rows[0].size(); ++k) {
        result[rows[0][k]] = rows[row][k];
    }
    return result;
}

/// Numbers with all their digits, one in each place.
Thermodynamics sample() {
    Thermodynamics s;
    s.temperature = 1.0 / 3.0;
    s.potential_energy = -6.1234567890123456;
    s.kinetic_energy = 0.1;
    s.total_energy = -6.0234567890123457e-7;
    s.pressure = 1e-300;
    Mat3 tensor;
    tensor << 0.1, 0.4, 0.5, 0.4, 0.2, 0.7, 0.5, 0.7, 0.3;
    s.pressure_tensor = tensor / 7.0;
    s.virial = 99.0;
    return s;
}

const SubstanceUnits& argon() {
    static const SubstanceUnits units(3.405e-10, 119.8 * 1.380649e-23, 39.948 * 1.66053906660e-27);
    return units;
}

std::vector<Row> written(const ThermoColumns::Extra& extra, std::optional<SubstanceUnits> units,
                         const Thermodynamics& row, const ThermoColumns::Values& values) {
    const test::TemporaryFolder folder;
    ThermoCsv csv(folder / "thermo.csv", {extra, units});
    csv.write(1234567890123, 0.1 + 0.2, row, values);
    csv.close();
    return rows_of(test::content_of(folder / "thermo.csv"));
}

constexpr ThermoColumns::Extra with_order{.order_parameter = true};

}  // namespace

TEST_CASE("thermo.csv begins with its header, and its numbers are read back to the last bit") {
    const Thermodynamics s = sample();
    const auto rows = written({}, std::nullopt, s, {});
    REQUIRE(rows.size() == 2);
    CHECK(rows[0] == Row{"step", "time", "temperature", "potential_energy", "kinetic_energy", "total_energy",
                         "pressure", "pressure_xx", "pressure_yy", "pressure_zz", "pressure_xy", "pressure_xz",
                         "pressure_yz"});
    auto row = fields(rows, 1);
    CHECK(row["step"] == "1234567890123");
    CHECK(number(row["time"]) == 0.1 + 0.2);
    CHECK(number(row["temperature"]) == *s.temperature);
    CHECK(number(row["potential_energy"]) == s.potential_energy);
    CHECK(number(row["kinetic_energy"]) == s.kinetic_energy);
    CHECK(number(row["total_energy"]) == s.total_energy);
    CHECK(number(row["pressure"]) == *s.pressure);
    CHECK(number(row["pressure_xx"]) == (*s.pressure_tensor)(0, 0));
    CHECK(number(row["pressure_yy"]) == (*s.pressure_tensor)(1, 1));
    CHECK(number(row["pressure_zz"]) == (*s.pressure_tensor)(2, 2));
    CHECK(number(row["pressure_xy"]) == (*s.pressure_tensor)(0, 1));
    CHECK(number(row["pressure_xz"]) == (*s.pressure_tensor)(0, 2));
    CHECK(number(row["pressure_yz"]) == (*s.pressure_tensor)(1, 2));
}

TEST_CASE("a run from a lattice has a column for the order parameter") {
    const auto rows = written(with_order, std::nullopt, sample(), {std::nullopt, 0.987});
    CHECK(rows[0].size() == 14);
    CHECK(rows[0].back() == "order_parameter");
    CHECK(number(fields(rows, 1)["order_parameter"]) == 0.987);
    CHECK(fields(written(with_order, std::nullopt, sample(), {}), 1)["order_parameter"].empty());
}

TEST_CASE("runs with a barostat have a column for the density, those with a thermostat one for the conserved energy") {
    Thermodynamics s = sample();
    s.density = 0.1 + 0.7;
    ThermoColumns::Extra extra{.density = true, .conserved_energy = true, .order_parameter = true};
    const auto rows = written(extra, std::nullopt, s, {-2.0 / 3.0, 0.5});
    CHECK(Row(rows[0].end() - 3, rows[0].end()) == Row{"density", "conserved_energy", "order_parameter"});
    CHECK(number(fields(rows, 1)["density"]) == 0.1 + 0.7);
    CHECK(number(fields(rows, 1)["conserved_energy"]) == -2.0 / 3.0);
    extra.order_parameter = false;
    CHECK(fields(written(extra, std::nullopt, s, {}), 1)["conserved_energy"].empty());
}

TEST_CASE("a substance adds its columns in SI") {
    const Thermodynamics s = sample();
    const bool order = GENERATE(false, true);
    const auto rows = written({.order_parameter = order}, argon(), s, {std::nullopt, 0.5});
    CHECK(Row(rows[0].end() - 6, rows[0].end()) == Row{"time_ps", "temperature_K", "potential_energy_kJ_per_mol",
                                                       "kinetic_energy_kJ_per_mol", "total_energy_kJ_per_mol",
                                                       "pressure_bar"});
    auto row = fields(rows, 1);
    CHECK(number(row["temperature"]) == *s.temperature);
    // By hand: tau = 2.1562 ps, epsilon/k_B = 119.8 K, N_A epsilon = 0.99607 kJ/mol, epsilon/sigma^3 = 419.0 bar.
    CHECK(number(row["time_ps"]) == Approx(0.3 * 2.1562).epsilon(1e-4));
    CHECK(number(row["temperature_K"]) == Approx(119.8 / 3.0).epsilon(1e-12));
    CHECK(number(row["potential_energy_kJ_per_mol"]) == Approx(s.potential_energy * 0.99607).epsilon(1e-4));
    CHECK(number(row["kinetic_energy_kJ_per_mol"]) == Approx(s.kinetic_energy * 0.99607).epsilon(1e-4));
    CHECK(number(row["total_energy_kJ_per_mol"]) == Approx(s.total_energy * 0.99607).epsilon(1e-4));
    CHECK(number(row["pressure_bar"]) == Approx(1e-300 * 419.0).epsilon(1e-3));
    CHECK(number(row["pressure_bar"]) == *s.pressure * argon().bar());
}

TEST_CASE("temperature and pressure that are not defined are empty fields, in SI as well") {
    Thermodynamics s = sample();
    s.temperature.reset();
    s.pressure.reset();
    s.pressure_tensor.reset();
    const auto rows = written(with_order, argon(), s, {std::nullopt, 0.5});
    auto row = fields(rows, 1);
    CHECK(row["temperature"].empty());
    CHECK(row["temperature_K"].empty());
    for (const char* name : {"pressure", "pressure_xx", "pressure_yz", "pressure_bar"}) {
        CHECK(row.at(name).empty());
    }
    CHECK(number(row["kinetic_energy"]) == s.kinetic_energy);
    CHECK(number(row["total_energy_kJ_per_mol"]) == Approx(s.total_energy * 0.99607).epsilon(1e-4));
}

TEST_CASE("rows follow each other, and flushed ones are in the file before it is closed") {
    const test::TemporaryFolder folder;
    ThermoCsv csv(folder / "thermo.csv", {{}, std::nullopt});
    for (Index step = 0; step < 5; ++step) {
        csv.write(10 * step, 0.5 * static_cast<double>(step), sample(), {});
    }
    csv.flush();
    const auto rows = rows_of(test::content_of(folder / "thermo.csv"));
    REQUIRE(rows.size() == 6);
    CHECK(rows[1][0] == "0");
    CHECK(rows[1][1] == "0");
    CHECK(rows[5][0] == "40");
    CHECK(rows[5][1] == "2");
    csv.close();
}

TEST_CASE("a file that cannot be created or written is an error") {
    const test::TemporaryFolder folder;
    CHECK_THROWS_AS(ThermoCsv(folder / "nowhere/thermo.csv", {{}, std::nullopt}), FileError);
    ThermoCsv csv(folder / "thermo.csv", {{}, std::nullopt});
    csv.flush();
    const std::string header = test::content_of(folder / "thermo.csv");
    const test::FileSizeLimit full(header.size() + 10);
    csv.write(0, 0.0, sample(), {});
    CHECK_THROWS_AS(csv.flush(), FileError);
    CHECK(test::content_of(folder / "thermo.csv") == header);
}
