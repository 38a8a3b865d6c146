#include "report/atom_frames.hpp"

#include <algorithm>
#include "catch.hpp"

using namespace ljmd;

namespace {

Frame frame_of(Index atoms, Index step, bool velocities = true) {
    Frame frame;
    frame.configuration.edges = Vec3(10.0, 10.0, 10.0);
    for (Index k = 0; k < atoms; ++k) {
        frame.configuration.positions.emplace_back(0.5 * static_cast<double>(k % 20), 15.0, -2.5);
        if (velocities) {
            frame.configuration.velocities.emplace_back(1.0, 0.0, 0.0);
        }
    }
    frame.configuration.step = step;
    return frame;
}

Data atoms_after(Index atoms, Index frames, Index expected) {
    AtomFrames collected(expected);
    Frame frame = frame_of(atoms, 0);
    for (Index k = 0; k < frames; ++k) {
        frame.configuration.step = 10 * k;
        collected.add(frame);
    }
    return collected.data("");
}

std::size_t bytes(const Data& atoms) {
    std::size_t sum = atoms["positions"].text().size();
    for (const Data& colour : atoms["colours"].items()) {
        sum += colour["values"].text().size();
    }
    return sum;
}

}  // namespace

TEST_CASE("positions are fractions of the box in 16 bits, wrapped") {
    const Data atoms = atoms_after(1, 1, 1);
    CHECK(atoms["positions"] == "AAAAgADA");  // 0, 0.5, 0.75 times 65536: 00 00, 00 80, 00 C0
    CHECK(atoms["box"] == Data::list({Data::list({10, 10, 10})}));
    CHECK(atoms["words"] == "1 frame.");
    CHECK(atoms["colours"][0]["name"] == "speed");
    CHECK(atoms["colours"][0]["high"].number() == Approx(1.0));
    CHECK(atoms["colours"][0]["values"] == "/w==");
}

TEST_CASE("a page of 864 atoms stays small, one of 32000 below eleven megabytes, with some 35 frames of a thousand") {
    CHECK(bytes(atoms_after(864, 500, 500)) <= 600'000);
    CHECK(atoms_after(864, 500, 500)["shown_frames"].integer() >= 40);
    const Data large = atoms_after(32'000, 1000, 1000);
    CHECK(bytes(large) <= 10'600'000);
    CHECK(large["shown_frames"].integer() >= 32);
    CHECK(large["frames"] == 1000);
    CHECK(large["steps"][1] == 290);
    CHECK(large["words"] ==
          "35 of 1000 frames are shown, one in 29, to keep the page small; no colours by coordination: neighbours are "
          "counted for at most 20000 atoms.");
}

TEST_CASE("more frames than were expected are thinned as they come, at even distances") {
    const Data atoms = atoms_after(32'000, 200, 1);
    CHECK(bytes(atoms) <= 10'600'000);
    const Data::List& steps = atoms["steps"].items();
    REQUIRE(steps.size() > 15);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        CHECK(steps[k].integer() == static_cast<std::int64_t>(k) * steps[1].integer());
    }
}

TEST_CASE("without velocities there are no speeds, without frames nothing") {
    AtomFrames frames(1);
    CHECK(frames.data("").is_null());
    frames.add(frame_of(8, 0, false));
    CHECK(frames.data("It is the last.")["colours"].size() == 1);
    CHECK(frames.data("It is the last.")["words"] == "1 frame. It is the last.");
}

TEST_CASE("neighbours are counted through the walls of the box, in large boxes as in small ones") {
    const std::vector<Vec3> three{Vec3(0.2, 5.0, 5.0), Vec3(9.8, 5.0, 5.0), Vec3(5.0, 5.0, 5.0)};
    CHECK(neighbour_counts(three, Vec3(10.0, 10.0, 10.0), 1.5) == std::vector<std::uint8_t>{1, 1, 0});
    CHECK(neighbour_counts(three, Vec3(10.0, 10.0, 10.0), 4.9) == std::vector<std::uint8_t>{2, 2, 2});
    CHECK(neighbour_counts(three, Vec3(10.0, 10.0, 10.0), 0.3) == std::vector<std::uint8_t>{0, 0, 0});
}

TEST_CASE("a million atoms in one place, and in two a little apart, are not looked at in pairs") {
    constexpr std::size_t atoms = 1'000'000;
    std::vector<Vec3> places(atoms, Vec3(0.1, 0.1, 0.1));
    CHECK(neighbour_counts(places, Vec3(10.0, 10.0, 10.0), 1.5) == std::vector<std::uint8_t>(atoms, 255));
    CHECK(neighbour_counts(places, Vec3(1e9, 1e9, 1e9), 1.5) == std::vector<std::uint8_t>(atoms, 255));
    std::fill(places.begin() + atoms / 2, places.end(),
              Vec3(1.4, 1.4, 1.4));  // of the same cell, too far for the first
    CHECK(neighbour_counts(places, Vec3(10.0, 10.0, 10.0), 1.5).front() == 255);
}
