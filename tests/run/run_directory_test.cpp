#include "run/run_directory.hpp"

#include <map>
#include <set>

#include "deck/deck_fixtures.hpp"
#include "engine/few_body_system.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "run/run.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> own_names() {
    std::vector<std::string> names{"run.json",  "results.json",    "results.txt",    "thermo.csv", "rdf.csv",
                                   "orbit.csv", "oscillation.csv", "trajectory.csv", "final.xyz",  "failed.xyz"};
    for (const TrajectoryFormat& format : all_trajectory_formats()) {
        names.push_back("trajectory." + format.name);
    }
    return names;
}

void write_text(const fs::path& path, const std::string& text) {
    std::ofstream(path) << text;
}

/// Every file and what is in it.
std::map<std::string, std::string> contents(const fs::path& directory) {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::directory_iterator(directory)) {
        all[entry.path().filename().string()] = entry.is_regular_file() ? content_of(entry.path()) : "";
    }
    return all;
}

const FewBodyRow no_totals{0, 0.0, {0.0, 0.0, 0.0, Vec3::Zero(), Vec3::Zero()}};

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
    FewBodySystem system = make_few_body_system(deck.few_bodies());
    system.force_field->evaluate(system.state, Request::forces);
    RunDirectory files(deck, system);
    files.write(no_totals);
    files.write_frame(system.state, std::nullopt);
    files.finish(system.state, {.tables = tables});
    return files_in(deck.directory);
}

}  // namespace

TEST_CASE("a directory is good when it is not there, empty, or holds the files of others") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    CHECK_NOTHROW(check_directory(deck, false));
    CHECK_FALSE(fs::exists(deck.directory));
    fs::create_directory(deck.directory);
    CHECK_NOTHROW(check_directory(deck, false));
    write_text(deck.directory / "notes.txt", "mine");
    write_text(deck.directory / "thermo.csv.bak", "mine");
    CHECK_NOTHROW(check_directory(deck, false));
    prepare_directory(deck.directory);
    CHECK(contents(deck.directory).size() == 2);
}

TEST_CASE("any file of an earlier run is a reason to refuse, and stays as it is") {
    for (const std::string& name : own_names()) {
        const DeckFolder folder;
        const Deck deck = folder.load();
        fs::create_directory(deck.directory);
        write_text(deck.directory / name, "old");
        CHECK_THROWS_AS(check_directory(deck, false), InputError);
        CHECK_THROWS_WITH(check_directory(deck, false),
                          Contains("already holds a run (" + name + ")") && Contains("or replace it"));
        CHECK_NOTHROW(check_directory(deck, true));
        CHECK(content_of(deck.directory / name) == "old");
    }
}

TEST_CASE("with force a run replaces its own files and no others") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    fs::create_directory(deck.directory);
    for (const std::string& name : own_names()) {
        write_text(deck.directory / name, "old");
    }
    write_text(deck.directory / "notes.txt", "mine");
    fs::create_directory(deck.directory / "figures");
    prepare_directory(deck.directory);
    CHECK(contents(deck.directory) == std::map<std::string, std::string>{{"notes.txt", "mine"}, {"figures", ""}});
}

TEST_CASE("a link in the place of an output is removed, and what it leads to is not") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    fs::create_directory(deck.directory);
    write_text(folder / "precious", "mine");
    fs::create_symlink(folder / "precious", deck.directory / "thermo.csv");
    fs::create_symlink(folder / "gone", deck.directory / "final.xyz");  // leads nowhere, but would be written through
    CHECK_THROWS_AS(check_directory(deck, false), InputError);
    prepare_directory(deck.directory);
    CHECK(contents(deck.directory).empty());
    CHECK(content_of(folder / "precious") == "mine");
}

TEST_CASE("what is no directory is refused, what cannot be made is an error") {
    const DeckFolder folder;
    Deck deck = folder.load();
    write_text(folder / "file", "mine");
    deck.directory = folder / "file";
    CHECK_THROWS_AS(check_directory(deck, true), InputError);
    CHECK_THROWS_WITH(check_directory(deck, true), Contains("is not a directory"));
    CHECK_THROWS_AS(prepare_directory(folder / "file" / "out"), FileError);
    CHECK(content_of(folder / "file") == "mine");
    prepare_directory(folder / "some" / "where" / "deep");
    CHECK(fs::is_directory(folder / "some" / "where" / "deep"));
    fs::create_directories(folder / "some" / "thermo.csv" / "full");
    CHECK_THROWS_WITH(prepare_directory(folder / "some"), Contains("thermo.csv is in the way"));
}

TEST_CASE("a run does not replace the file that it starts from, by whatever name") {
    const DeckFolder folder(changed(small_deck, {{"lattice = { type = \"fcc\", cells = 3 }", ""}}));
    const fs::path out = folder / "out";
    fs::create_directory(out);
    write_text(out / "final.xyz", "the start");
    fs::create_symlink(out, folder / "link");
    fs::create_hard_link(out / "final.xyz", folder / "start.xyz");
    for (const fs::path& start :
         {out, out / "final.xyz", folder / "link", folder / "link" / "final.xyz", folder / "start.xyz"}) {
        INFO(start);
        const Deck deck = folder.load({"system.file=" + start.string()});
        CHECK_THROWS_AS(check_directory(deck, true), InputError);
        CHECK_THROWS_WITH(check_directory(deck, true),
                          Contains("is read, and would be replaced by what is written. Nothing was run."));
    }
    write_text(folder / "other.xyz", "the start");
    CHECK_NOTHROW(check_directory(folder.load({"system.file=" + (folder / "other.xyz").string()}), true));
    CHECK(content_of(out / "final.xyz") == "the start");
}

TEST_CASE("the frames and files that a deck asks for are written, and no others") {
    const DeckFolder folder;
    std::vector<std::string> formats = plugin_names(all_trajectory_formats());
    formats.emplace_back();
    for (const std::string& format : formats) {
        Deck deck = folder.load();
        deck.directory = folder / ("out" + format);
        if (!format.empty()) {
            deck.trajectory = TrajectoryOutput{format, 4};
        }
        FluidSystem simulation = simulation_of(deck);
        prepare_directory(deck.directory);
        RunDirectory files(deck, simulation);
        files.write_frame(simulation.state);
        for (Index step = 1; step <= 10; ++step) {
            simulation.state.step = step;
            if (files.frame_is_due(simulation.state)) {
                files.write_frame(simulation.state);
            }
        }
        files.finish(simulation.state, {});
        std::string all;
        for (const auto& [file, content] : contents(deck.directory)) {
            all += file + " ";
        }
        const std::string trajectory = format.empty() ? "" : "trajectory." + format + " ";
        CHECK(all == "final.xyz results.json results.txt run.json thermo.csv " + trajectory);
        if (format == "xyz") {
            const std::string text = content_of(deck.directory / "trajectory.xyz");
            CHECK_THAT(text, Contains("step=0") && Contains("step=4") && Contains("step=8") && !Contains("step=10"));
        }
    }
}

TEST_CASE("a few-body run writes the trajectory that its deck asks for, and no other") {
    CHECK(files_of(stars_deck, {}) == always);
    CHECK(files_of(stars_deck, {"output.trajectory.every=1"}) == together(always, "trajectory.csv"));
    std::vector<std::string> formats = plugin_names(all_trajectory_formats());
    formats.emplace_back("csv");
    for (const std::string& format : formats) {
        CHECK(files_of(stars_deck, {"output.trajectory.every=1", "output.trajectory.format=" + format}) ==
              together(always, "trajectory." + format));
    }
    CHECK(files_of(stars_deck, {}, {{"orbit", {"time"}, {{1.0}}}}) == together(always, "orbit.csv"));
}

TEST_CASE("rows of a few-body run are on the disk before it ends, every hundredth at the latest") {
    const DeckFolder folder(stars_deck);
    const Deck deck = folder.load({"output.trajectory.every=1"});
    prepare_directory(deck.directory);
    const FewBodySystem system = make_few_body_system(deck.few_bodies());
    RunDirectory files(deck, system);
    CHECK(std::filesystem::exists(deck.directory / "run.json"));
    for (int n = 0; n < 100; ++n) {
        files.write_frame(system.state, std::nullopt);
        files.write(no_totals);
    }
    CHECK(rows(content_of(deck.directory / "thermo.csv")).size() == 100);
    CHECK(rows(content_of(deck.directory / "trajectory.csv")).size() == 100);
}

TEST_CASE("the last configuration of few bodies is kept with velocities and all digits") {
    const DeckFolder folder(stars_deck);
    const Deck deck = folder.load();
    prepare_directory(deck.directory);
    FewBodySystem system = make_few_body_system(deck.few_bodies());
    system.state.write_positions()(1, 0) = 1.0 / 3.0;
    RunDirectory files(deck, system);
    files.finish(system.state, {});
    const std::string last = content_of(deck.directory / "final.xyz");
    CHECK_THAT(last,
               Catch::Contains("velo:R:3") && Catch::Contains("0.3333333333333333") && !Catch::Contains("Lattice"));
}
