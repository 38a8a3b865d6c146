#include "deck/deck_system.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("the deck of a fluid makes a fluid, and the one of few bodies makes these") {
    const DeckFolder fluid_folder;
    const Deck fluid = fluid_folder.load();
    const AnySystem atoms = make_system(fluid, find_start(fluid), Execution(), no_warnings);
    CHECK(std::get<FluidSystem>(atoms).state.count() == 108);
    CHECK(std::get<FluidSystem>(empty_system(fluid, 32, Vec3::Constant(6.0), Execution())).state.count() == 32);

    const DeckFolder stars_folder(stars_deck);
    const Deck stars = stars_folder.load();
    const AnySystem bodies = make_system(stars, std::nullopt, Execution(), no_warnings);
    CHECK(std::get<FewBodySystem>(bodies).state.count() == 2);
    CHECK(std::get<FewBodySystem>(empty_system(stars, 2, Vec3::Zero(), Execution())).state.count() == 2);
}

TEST_CASE("who wants a deck of one kind refuses the other in words of its own") {
    const DeckFolder fluid_folder;
    const DeckFolder stars_folder(stars_deck);
    const Deck fluid = fluid_folder.load();
    const Deck stars = stars_folder.load();
    CHECK(kind_name(fluid) == "fluid");
    CHECK(kind_name(stars) == "few-body");
    CHECK_NOTHROW(require_fluid(fluid, ""));
    CHECK_NOTHROW(require_few_bodies(stars, ""));
    CHECK_THROWS_AS(require_fluid(stars, "no box"), InputError);
    CHECK_THROWS_WITH(require_fluid(stars, "no box"), "no box");
    CHECK_THROWS_WITH(require_few_bodies(fluid, "too many"), "too many");
}

TEST_CASE("the box of a fluid holds its cutoff, and few bodies have none") {
    const DeckFolder fluid_folder;
    const Deck fluid = fluid_folder.load();  // its cutoff is 2
    CHECK(is_possible_box(fluid, 108, Vec3(4.0, 5.0, 6.0)));
    CHECK_FALSE(is_possible_box(fluid, 108, Vec3(3.9, 5.0, 6.0)));
    CHECK_FALSE(is_possible_box(fluid, 108, Vec3(-1.0, 5.0, 6.0)));
    const DeckFolder stars_folder(stars_deck);
    CHECK(is_possible_box(stars_folder.load(), 2, Vec3::Zero()));
}

TEST_CASE("only a fluid can start from a file: itself, or the last configuration of a run") {
    const std::string lattice = "lattice = { type = \"fcc\", cells = 3 }";
    const DeckFolder lattice_folder;
    CHECK_FALSE(lattice_folder.load().start_file.has_value());
    const DeckFolder stars_folder(stars_deck);
    CHECK_FALSE(stars_folder.load().start_file.has_value());
    const DeckFolder from_file(changed(small_deck, {{lattice, "file = \"start.xyz\""}}));
    CHECK(from_file.load().start_file == std::filesystem::path("start.xyz"));
    const DeckFolder other;
    const DeckFolder from_run(changed(small_deck, {{lattice, "file = \"" + (other / "").string() + "\""}}));
    CHECK(from_run.load().start_file == other / "final.xyz");
}
