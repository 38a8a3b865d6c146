#include "analyze/thermo_report.hpp"

#include "io/tables/data_table_csv.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
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
        run_until(*deck_, std::min(steps, total_steps(deck_->stages())));
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

/// What the report gives is what results.json has.
void check_reported(const ObservableAverage& average, const Data& reported) {
    REQUIRE(average.estimate.has_value());
    CHECK(average.estimate->mean == Approx(reported.at("mean").number()).epsilon(1e-12));
    CHECK(average.estimate->standard_error == Approx(reported.at("standard_error").number()).epsilon(1e-9));
    CHECK(average.estimate->converged == (reported.at("error_is_converged") == true));
}

}  // namespace

TEST_CASE("the report looks at the rows of sampled stages, as the averages of a run do") {
    const SmallRun run;
    const ThermoReport report = run.report();
    CHECK(report.rows == 40);
    CHECK(report.first_step == 21);
    CHECK(report.last_step == 60);
    CHECK(report.interval == Approx(0.004));
    REQUIRE(report.columns.size() == 4);
    const Data results = parse_json(content_of(run.directory() / "results.json"));
    std::vector<EquilibratingColumn> relaxing;
    for (const char* name : {"temperature", "potential_energy", "pressure"}) {
        const std::vector<double> all = run.column_of(name);
        relaxing.push_back({{all.end() - 40, all.end()}});
    }
    relaxing.front().largest_relative_deviation = std::sqrt(2.0 / (3.0 * 107.0));
    const std::vector<Equilibration> expected = detect_equilibration(relaxing);
    std::size_t k = 0;
    for (const ThermoReport::Column& column : report.columns) {
        CAPTURE(column.average.name);
        CHECK(column.conserved == (column.average.name == "total_energy"));
        if (!column.conserved) {
            CHECK(column.found.start == expected[k].start);
            CHECK(column.found.inefficiency == expected[k].inefficiency);
            CHECK(column.whole_inefficiency == statistical_inefficiency(relaxing[k++].series));
        }
        const Data& reported = results.at("observables").at(column.average.name);
        check_reported(column.of_all, reported);
        if (column.found.start.value_or(0) == 0) {
            check_reported(column.average, reported);
        }
    }
}

TEST_CASE("errors of a run that has reached those it was to reach are those of its results") {
    std::string text = small_deck;
    const std::string steps = "steps = 40\n";
    text.replace(text.find(steps), steps.size(), "until = { temperature = 10.0, max_steps = 20000 }\n");
    const DeckFolder folder(text);
    const Deck deck = folder.load({"output.thermo.every=2"});
    run_until(deck, total_steps(deck.stages()));
    const Data results = parse_json(content_of(deck.directory / "results.json"));
    REQUIRE(results.at("observables").at("temperature").at("independent_samples").number() >= 150.0);
    const ThermoReport report = thermo_report(recorded_run(deck.directory));
    for (const ThermoReport::Column& column : report.columns) {
        check_reported(column.of_all, results.at("observables").at(column.average.name));
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
    const Data& pressure = json.at("observables").at("pressure");
    const ThermoReport::Column& column = report.columns.back();
    const Estimate& estimate = *column.average.estimate;
    CHECK(pressure.at("equilibrium") == state_of(column));
    CHECK(pressure.at("equilibrated_at_row").is_null() == !column.found.start);
    CHECK(pressure.at("mean") == estimate.mean);
    CHECK(pressure.at("standard_error") == estimate.standard_error);
    CHECK(pressure.at("independent_samples") == estimate.independent_samples);
    const double inefficiency = static_cast<double>(estimate.samples) / estimate.independent_samples;
    CHECK(pressure.at("statistical_inefficiency").number() == Approx(inefficiency));
    CHECK(pressure.at("correlation_time").number() == Approx(0.5 * (inefficiency - 1.0) * 0.004));
    CHECK(json.at("observables").at("total_energy").at("equilibrium") == "conserved");
    CHECK(json.at("observables").at("total_energy").at("correlation_time").is_null());
    const std::string table = thermo_document(report).text;
    CHECK_THAT(table, Contains("40 rows of thermo.csv, steps 21 to 60, 0.004 tau apart"));
    for (const char* name : {"temperature", "potential_energy", "total_energy", "pressure"}) {
        CHECK_THAT(table, Contains(name));
    }
}

TEST_CASE("a column without numbers is not defined") {
    ThermoReport report{5, 1, 5, 0.1, {}};
    const ObservableAverage unknown{"temperature", "T", "", std::nullopt};
    report.columns.push_back(
        {unknown, unknown, detect_equilibration({{std::vector<double>(5, std::nan(""))}})[0], false, std::nan("")});
    CHECK_THAT(thermo_document(report).text, Contains("temperature                not defined"));
    CHECK(thermo_document(report).data.at("observables").at("temperature").at("mean").is_null());
}

TEST_CASE("the report says where equilibrium begins, or why that is not known, and marks what is doubtful") {
    ThermoReport report{400, 1, 400, 0.1, {}};
    const auto add = [&](const char* name, const Equilibration& found, bool converged, bool conserved = false) {
        const ObservableAverage average{name, "", "", Estimate{1.5, 0.1, 50.0, 400, converged}};
        report.columns.push_back({average, average, found, conserved, 8.0});
    };
    add("temperature", {120, false, 8.0}, true);
    add("potential_energy", {std::nullopt, false, 50.0}, false);
    add("total_energy", {std::nullopt, false, std::nan("")}, true, true);
    add("pressure", {std::nullopt, true, 8.0}, true);
    const std::string text = thermo_document(report).text;
    CHECK_THAT(text, Contains("temperature                        121") && Contains("1.50 +- 0.10\n"));
    CHECK_THAT(text, Contains("potential_energy     too short to tell") && Contains("1.50 +- 0.10  [1]\n"));
    CHECK_THAT(text, Contains("total_energy                 conserved"));
    CHECK_THAT(text, Contains("pressure                still changing") && Contains("1.50 +- 0.10  [2]\n"));
    CHECK_THAT(text, Contains("\n  [1] its error bar is a guess") && Contains("\n  [2] it still changes"));
    const Data observables = thermo_document(report).data.at("observables");
    CHECK(observables.at("temperature").at("equilibrated_at_row") == 120);
    CHECK(observables.at("temperature").at("equilibrated_at_step") == 121);
    CHECK_FALSE(observables.at("temperature").contains("remark"));
    CHECK(observables.at("potential_energy").at("equilibrium") == "too short to tell");
    CHECK(observables.at("potential_energy").at("equilibrated_at_step").is_null());
    CHECK(observables.at("potential_energy").at("error_is_converged") == false);
    CHECK(observables.at("pressure").at("equilibrium") == "still changing");
    CHECK(observables.at("pressure").contains("remark"));
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
