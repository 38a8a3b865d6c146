#include "ljmd/analyze/thermo_report.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/io/tables/data_table_csv.hpp"
#include "ljmd/io/tables/json_text.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A run of the small deck with a row for every step.
class SmallRun {
  public:
    explicit SmallRun(std::vector<std::string> settings = {}, Index steps = 1000000) {
        settings.emplace_back("output.thermo.every=1");
        deck_ = folder_.load(settings);
        run_until(*deck_, std::min(steps, total_steps(deck_->stages)));
    }
    [[nodiscard]] ThermoReport report() const { return thermo_report(recorded_run(deck_->directory)); }
    [[nodiscard]] std::vector<double> column_of(const std::string& name) const {
        return column(read_csv(deck_->directory / "thermo.csv"), name);
    }
    [[nodiscard]] std::filesystem::path directory() const { return deck_->directory; }

  private:
    DeckFolder folder_;
    std::optional<Deck> deck_;
};

}  // namespace

TEST_CASE("the report looks at the rows of sampled stages, as the averages of a run do") {
    const SmallRun run;
    const ThermoReport report = run.report();
    CHECK(report.rows == 40);
    CHECK(report.first_step == 21);
    CHECK(report.last_step == 60);
    CHECK(report.interval == Approx(0.004));
    CHECK(report.stride == 1);
    REQUIRE(report.columns.size() == 4);
    const Data results = parse_json(content_of(run.directory() / "results.json"));
    for (const ThermoReport::Column& column : report.columns) {
        CAPTURE(column.name);
        const std::vector<double> all = run.column_of(column.name);
        const std::vector<double> sampled(all.end() - 40, all.end());
        const Equilibration expected = detect_equilibration(sampled, 1);
        CHECK(column.found.start == expected.start);
        CHECK(column.found.mean == expected.mean);
        CHECK(column.found.standard_error == expected.standard_error);
        CHECK(column.whole_inefficiency == statistical_inefficiency(sampled));
        const Data& reported = results.at("observables").at(column.name);
        CHECK(column.by_blocking.mean == Approx(reported.at("mean").number()).epsilon(1e-12));
        CHECK(column.by_blocking.standard_error == Approx(reported.at("standard_error").number()).epsilon(1e-9));
    }
}

TEST_CASE("where no stage is sampled all rows but the start's are looked at") {
    const ThermoReport report = SmallRun({"stage.production.sample=false"}).report();
    CHECK(report.rows == 60);
    CHECK(report.first_step == 1);
}

TEST_CASE("rows before a time are left out") {
    const SmallRun run;
    const ThermoReport late = thermo_report(recorded_run(run.directory()), 0.12);  // step 30
    CHECK(late.first_step == 30);
    CHECK(late.rows == 31);
}

TEST_CASE("the report of a run that was stopped is that of its rows") {
    const ThermoReport report = SmallRun({"output.checkpoint.every=10"}, 35).report();
    CHECK(report.rows <= 16);
    CHECK(report.rows >= 2);
    CHECK(report.first_step == 21);
}

TEST_CASE("the report says the same to people and to programs") {
    const ThermoReport report = SmallRun().report();
    const Data json = thermo_document(report).data;
    CHECK(json.at("rows") == 40);
    CHECK(json.at("stride") == 1);
    const Data& pressure = json.at("observables").at("pressure");
    const Equilibration& found = report.columns.back().found;
    CHECK(pressure.at("equilibrated_at_row") == found.start);
    CHECK(pressure.at("equilibrated_at_step") == 21 + found.start);
    CHECK(pressure.at("statistical_inefficiency") == found.inefficiency);
    CHECK(pressure.at("correlation_time").number() == Approx(0.5 * (found.inefficiency - 1.0) * 0.004));
    CHECK(pressure.at("mean") == found.mean);
    const std::string table = thermo_document(report).text;
    CHECK_THAT(table, Contains("40 rows of thermo.csv, steps 21 to 60, 0.004 tau apart"));
    for (const char* name : {"temperature", "potential_energy", "total_energy", "pressure"}) {
        CHECK_THAT(table, Contains(name));
    }
}

TEST_CASE("a column without numbers is not defined") {
    ThermoReport report{5, 1, 5, 0.1, 1, {}};
    const std::vector<double> unknown(5, std::nan(""));
    report.columns.push_back({"temperature", detect_equilibration(unknown, 1), std::nan(""), {}});
    CHECK_THAT(thermo_document(report).text, Contains("temperature                not defined"));
    CHECK(thermo_document(report).data.at("observables").at("temperature").at("mean").is_null());
}

TEST_CASE("an error bar of few independent rows is marked as a guess") {
    ThermoReport report{400, 1, 400, 0.1, 1, {}};
    Equilibration found{};
    found.inefficiency = 20.0;
    found.independent_samples = 15.0;
    found.mean = 1.5;
    found.standard_error = 0.1;
    report.columns.push_back({"temperature", found, 20.0, {}});
    found.independent_samples = 17.0;
    report.columns.push_back({"pressure", found, 20.0, {}});
    CHECK_THAT(thermo_document(report).text, Contains("1.50 +- 0.10  [1]\n") && Contains("1.50 +- 0.10\n") &&
                                                 Contains("\n  [1] its error bar is a guess"));
    const Data observables = thermo_document(report).data.at("observables");
    CHECK(observables.at("temperature").contains("remark"));
    CHECK_FALSE(observables.at("pressure").contains("remark"));
}

TEST_CASE("what has hardly begun, or has no equilibrium, is refused") {
    const SmallRun begun({"stage.production.steps=1"});
    const std::string file = (begun.directory() / "thermo.csv").string();
    CHECK_THROWS_WITH(begun.report(),
                      file + " has 1 of the rows that are looked at: the sampled stages have hardly begun");
    const DeckFolder folder(stars_deck);
    const Deck deck = folder.load();
    CHECK_THROWS_AS(thermo_report(RecordedRun{deck, {}, "", 1, true}), InputError);
}

TEST_CASE("the heat capacity is that of the run, from all rows, and there is none where no fluctuation tells it") {
    const SmallRun run;
    const Data observables = parse_json(content_of(run.directory() / "results.json")).at("observables");
    const ThermoReport report = run.report();
    const bool found = observables.contains("heat_capacity_cv");
    REQUIRE(found);
    REQUIRE(report.of_fluctuations.size() == 1);
    const ObservableAverage& capacity = report.of_fluctuations.front();
    // Forty rows are too few to tell; what is said of it is the same everywhere.
    CHECK_FALSE(capacity.estimate.has_value());
    CHECK(observables["heat_capacity_cv"]["mean"].is_null());
    CHECK(observables["heat_capacity_cv"]["remark"] == capacity.remark);
    CHECK_THAT(thermo_document(report).text,
               Contains("heat capacity c_v of all rows, from their fluctuations: no value [") &&
                   Contains("] " + capacity.remark + "\n"));
    CHECK(thermo_document(report).data["heat_capacity_cv"] == observables["heat_capacity_cv"]);

    ThermoReport known = report;
    known.of_fluctuations = {{"heat_capacity_cv", "c_v", "k_B", Estimate{2.5, 0.1, 100.0, 1000, true}}};
    CHECK_THAT(thermo_document(known).text, Contains("from their fluctuations: 2.50 +- 0.10 k_B\n"));

    const SmallRun several({"stage.equilibrate.sample=true"});
    CHECK(several.report().of_fluctuations.empty());
    CHECK_THAT(thermo_document(several.report()).text, !Contains("heat capacity"));
}

TEST_CASE("rows of a canonical run have a pressure coefficient, those under a barostat all response functions") {
    const auto names_of = [](const ThermoReport& report) {
        std::vector<std::string> names;
        for (const ObservableAverage& each : report.of_fluctuations) {
            names.push_back(each.name);
            CHECK((each.estimate.has_value() || !each.remark.empty()));
        }
        return names;
    };
    const SmallRun canonical({"stage.production.thermostat={ type = \"andersen\" }"});
    CHECK(names_of(canonical.report()) == std::vector<std::string>{"heat_capacity_cv", "thermal_pressure_coefficient"});
    const std::vector<std::string> isobaric{
        "stage.production.thermostat={ type = \"andersen\" }",
        "stage.production.barostat={ type = \"stochastic-cell-rescaling\", pressure = 1.0 }", "system.density=0.7"};
    CHECK(names_of(SmallRun(isobaric).report()).size() == 8);
    std::vector<std::string> cut = isobaric;
    cut.emplace_back("potential.truncation=\"cut\"");
    cut.emplace_back("potential.tail=true");
    CHECK(names_of(SmallRun(cut).report()).empty());
}

TEST_CASE("rows without a step or a time, or with one that is none, are refused with their line") {
    const SmallRun run;
    const std::filesystem::path file = run.directory() / "thermo.csv";
    const std::string whole = content_of(file);
    const std::size_t row = whole.find("\n25,") + 1;
    const auto refused = [&](const std::string& beginning, const std::string& why) {
        const std::size_t end = whole.find(',', whole.find(',', row) + 1);
        std::ofstream(file) << whole.substr(0, row) << beginning << whole.substr(end);
        CHECK_THROWS_WITH(run.report(), Contains("thermo.csv:27: ") && Contains(why));
    };
    refused(",0.1", "'step' is empty");
    refused("nan,0.1", "step must be a finite number");
    refused("1e300,0.1", "'step' is 1e+300, allowed: whole numbers that grow");
    refused("24,0.1", "'step' is 24, allowed: whole numbers that grow");
    refused("25,", "'time' is empty");
}
