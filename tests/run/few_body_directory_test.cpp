#include "ljmd/run/few_body_directory.hpp"

#include <set>

#include "ljmd/run/few_body_run.hpp"
#include "ljmd/run/run_directory.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

const FewBodyTotals no_totals{0.0, 0.0, 0.0, Vec3::Zero(), Vec3::Zero()};

using Names = std::set<std::string>;

const Names always{"final.xyz", "results.json", "results.txt", "run.json", "thermo.csv"};

Names files_in(const std::filesystem::path& directory) {
    Names names;
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

Names together(Names names, const std::string& more) {
    names.insert(more);
    return names;
}

/// The files of a run that writes one row and one frame.
Names files_of(const std::string& text, const std::vector<std::string>& settings,
               const std::vector<DataTable>& tables = {}) {
    const DeckFolder folder(text);
    const Deck deck = folder.load(settings);
    prepare_directory(deck.directory);
    FewBodySystem system = make_few_body_system(deck);
    system.force_field->evaluate(system.state, Request::forces);
    FewBodyDirectory files(deck, system);
    files.write_thermo(system.state, no_totals);
    files.write_frame(system.state, std::nullopt);
    files.finish(system.state, {}, tables);
    return files_in(deck.directory);
}

}  // namespace

TEST_CASE("a few-body run writes the trajectory that its deck asks for, and no other") {
    CHECK(files_of(stars_deck, {}) == always);
    CHECK(files_of(stars_deck, {"output.trajectory.every=1"}) == together(always, "trajectory.csv"));
    for (const std::string format : {"csv", "xyz", "h5md"}) {
        CHECK(files_of(stars_deck, {"output.trajectory.every=1", "output.trajectory.format=" + format}) ==
              together(always, "trajectory." + format));
    }
    CHECK(files_of(stars_deck, {}, {{"orbit", {"time"}, {{1.0}}}}) == together(always, "orbit.csv"));
}

TEST_CASE("rows of a few-body run are on the disk before it ends, every hundredth at the latest") {
    const DeckFolder folder(stars_deck);
    const Deck deck = folder.load({"output.trajectory.every=1"});
    prepare_directory(deck.directory);
    const FewBodySystem system = make_few_body_system(deck);
    FewBodyDirectory files(deck, system);
    CHECK(std::filesystem::exists(deck.directory / "run.json"));
    for (int n = 0; n < 100; ++n) {
        files.write_frame(system.state, std::nullopt);
        files.write_thermo(system.state, no_totals);
    }
    CHECK(rows(content_of(deck.directory / "thermo.csv")).size() == 100);
    CHECK(rows(content_of(deck.directory / "trajectory.csv")).size() == 100);
}

TEST_CASE("the last configuration of few bodies is kept with velocities and all digits") {
    const DeckFolder folder(stars_deck);
    const Deck deck = folder.load();
    prepare_directory(deck.directory);
    FewBodySystem system = make_few_body_system(deck);
    system.state.write_positions()(1, 0) = 1.0 / 3.0;
    FewBodyDirectory files(deck, system);
    files.finish(system.state, {}, {});
    const std::string last = content_of(deck.directory / "final.xyz");
    CHECK_THAT(last,
               Catch::Contains("velo:R:3") && Catch::Contains("0.3333333333333333") && !Catch::Contains("Lattice"));
}
