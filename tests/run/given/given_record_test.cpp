#include "run/given/given_record.hpp"

#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "io/tables/pair_table_file.hpp"
#include "ljmd/core/errors.hpp"
#include "potentials/pair_table.hpp"
#include "potentials/twelve_six.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

TabulatedPair soft_table() {
    TabulatedPair pair{
        .name = "soft", .truncation = "cut", .cutoff = {2.0, 0.0}, .first = 0.5, .error = 1e-9, .force_error = 1e-7};
    for (const double r : PairTable::distances(0.5, 2.0, 4)) {
        pair.energies.push_back(1.0 / r);
    }
    return pair;
}

PairPotential formula(const std::string& name = "twelve-six") {
    return PairPotential::custom(name, TwelveSix{}, "cut", {2.0, 0.0});
}

struct Watcher : Observer {
    explicit Watcher(ObserverRecord what) : told(std::move(what)) {}
    [[nodiscard]] bool needs(Index /*step*/) const override { return false; }
    void sample(const Snapshot& /*snapshot*/) override {}
    [[nodiscard]] ObserverRecord record() const override { return told; }
    ObserverRecord told;
};

const ObserverRecord fastest{.name = "fastest", .unit = "sigma/tau", .every = 5, .energy = true};

GivenParts parts_of_python() {
    return {.by = "Python", .potential = given_potential(soft_table()), .observers = {fastest, {.name = "other"}}};
}

/// What a record with these parts says, read again beside its table.
GivenParts read_again(const GivenParts& parts, const std::filesystem::path& directory) {
    if (parts.potential && parts.potential->table) {
        write_pair_table(directory / pair_table_name, *parts.potential->table);
    }
    return given_parts(given_data(parts), directory);
}

}  // namespace

TEST_CASE("a record says what a program gave, and nothing for the command line") {
    const TemporaryFolder folder;
    CHECK(given_data({}).is_null());
    CHECK(given_parts(nullptr, folder / "").empty());
    const GivenParts parts = read_again(parts_of_python(), folder / "");
    CHECK(parts.by == "Python");
    CHECK(parts.observers == parts_of_python().observers);
    REQUIRE(parts.potential->table);
    CHECK(parts.potential->table->energies == soft_table().energies);
    CHECK(parts.potential->known()(1.3).u == soft_table().potential()(1.3).u);
    CHECK(parts.external.empty());
    CHECK(read_again({.by = "C++", .external = "wave"}, folder / "").external == "wave");
    CHECK(in_words(parts) ==
          "the pair potential 'soft' and the observables 'fastest' (every 5 steps, with energy, sigma/tau), 'other'");
}

TEST_CASE("a potential whose table is lost, damaged or another one is missing, and the rest of the record is there") {
    const TemporaryFolder folder;
    const Data record = given_data(parts_of_python());
    const GivenParts lost = given_parts(record, folder / "");
    CHECK(lost.potential->bad_table);
    CHECK(lost.observers.size() == 2);
    CHECK_THROWS_AS(lost.potential->known(), DataError);
    CHECK_THROWS_WITH(lost.potential->known(), Contains("the pair potential 'soft' of this run is not known") &&
                                                   Contains("given-potential.json: no such file"));
    TabulatedPair other = soft_table();
    other.energies.front() += 1.0;
    write_pair_table(folder / pair_table_name, other);
    CHECK_THROWS_WITH(given_parts(record, folder / "").potential->known(), Contains("it is another one"));
    CHECK_THROWS_WITH(resumed_parts(given_parts(record, folder / ""), {.by = "Python", .observers = {}}, "run"),
                      Contains("was begun with"));

    TabulatedPair wrong = soft_table();  // whose checksum is right, and which no potential can have
    wrong.truncation = "switched";
    wrong.cutoff.switch_start = 3.0;
    CHECK_THROWS_AS(given_potential(wrong), InputError);
    Data of_wrong = record;
    of_wrong["potential"]["checksum"] = checksum_of(wrong);
    write_pair_table(folder / pair_table_name, wrong);
    CHECK_THROWS_WITH(given_parts(of_wrong, folder / "").potential->known(), Contains("switch_start"));
}

TEST_CASE("a record that ljmd does not write is refused") {
    const TemporaryFolder folder;
    Data record = given_data(parts_of_python());
    record["potential"]["table"]["file"] = "../elsewhere.json";
    CHECK_THROWS_AS(given_parts(record, folder / ""), WrongData);
    record = given_data(parts_of_python());
    record["observables"] = Data::list({{{"name", "x"}, {"unit", ""}, {"every", -1}, {"energy", false}}});
    CHECK_THROWS_WITH(given_parts(record, folder / ""), Contains("'every' is -1"));
    CHECK_THROWS_AS(given_parts("Python", folder / ""), WrongData);
}

TEST_CASE("the command line refuses a run of a program, and says how it is resumed") {
    const GivenParts parts = parts_of_python();
    CHECK_THROWS_AS(resumed_parts(parts, {}, "runs/mine"), CheckpointError);
    CHECK_THROWS_WITH(resumed_parts(parts, {}, "runs/mine"),
                      Contains("runs/mine was run with the pair potential 'soft' and the observables 'fastest'") &&
                          Contains("of a program in Python, which the command line does not have\n  to go on: "
                                   "ljmd.resume(\"runs/mine\", observables=[fastest, other]) in Python"));
    CHECK(how_to_resume({}, "runs/mine") == "ljmd resume runs/mine");
    CHECK(how_to_resume({}, "my runs") == "ljmd resume 'my runs'");
    CHECK(how_to_resume({.by = "Python", .external = "wave"}, "a \"b\"") ==
          R"(ljmd.resume("a \"b\"", external=wave) in Python)");
    CHECK(how_to_resume({.by = "Python", .potential = parts.potential}, "runs/mine") ==
          "ljmd.resume(\"runs/mine\") in Python");
    CHECK_NOTHROW(resumed_parts({}, {}, "runs/mine"));
    const GivenParts all{.by = "Python", .potential = parts.potential, .observers = {fastest}, .external = "wave"};
    CHECK(in_words(all) ==
          "the pair potential 'soft' and the external force 'wave' and the observable 'fastest' (every 5 steps, with "
          "energy, sigma/tau)");
    CHECK(how_to_resume(all, "runs/mine") ==
          "ljmd.resume(\"runs/mine\", observables=[fastest], external=wave) in Python");
    CHECK_THROWS_WITH(resumed_parts({.by = "C++", .external = "wave"}, {}, "run"),
                      Contains("run was run with the external force 'wave' of a program in C++"));
}

TEST_CASE("a program resumes with its observers, and with the potential of the table or the formula given again") {
    GivenParts parts{.by = "Python", .potential = given_potential(soft_table()), .observers = {fastest}};
    Watcher same(fastest);
    Watcher other({.name = "fastest", .unit = "sigma/tau", .every = 6, .energy = true});
    CHECK(resumed_parts(parts, {.by = "Python", .observers = {&same}}, "run").potential->potential);
    CHECK_THROWS_WITH(resumed_parts(parts, {.by = "Python", .observers = {&other}}, "run"),
                      Contains("given: the observable 'fastest' (every 6 steps, with energy, sigma/tau)") &&
                          Contains("ljmd.resume(\"run\", observables=[fastest])"));
    CHECK_THROWS_AS(resumed_parts(parts, {.by = "Python", .observers = {&same, &same}}, "run"), CheckpointError);
    CHECK_THROWS_WITH(resumed_parts({}, {.by = "Python", .observers = {&same}}, "run"),
                      Contains("was begun with no observables; given: the observable 'fastest'"));

    const GivenParts of_formula =
        given_parts(given_data({.by = "C++", .potential = given_potential(formula())}), "run");
    CHECK_THROWS_WITH(resumed_parts(of_formula, {.by = "Python"}, "run"),
                      Contains("a formula of the C++ program that made it\n  to go on: resume_in_directory(\"run\""));
    CHECK(resumed_parts(of_formula, {.by = "C++", .potential = formula()}, "run").potential->potential);
    CHECK_THROWS_WITH(resumed_parts(of_formula, {.by = "C++", .potential = formula("other")}, "run"),
                      Contains("another one is given: 'other'"));
    parts.observers.clear();
    CHECK(resumed_parts(parts, {.by = "C++", .potential = soft_table().potential()}, "run").potential->potential);
    CHECK_THROWS_AS(resumed_parts(parts, {.by = "C++", .potential = formula("soft")}, "run"), CheckpointError);
}
