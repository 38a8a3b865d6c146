#include "report/body_tracks.hpp"

#include "catch.hpp"

using namespace ljmd;

namespace {

const DataTable trajectory{
    "trajectory",
    {"step", "time", "x1", "y1", "vx1", "vy1", "x2", "y2", "vx2", "vy2"},
    {{0, 0.0, 1, 2, 0, 0, 3, 4, 0, 0}, {2, 0.2, 5, 6, 0, 0, 7, 8, 0, 0}, {4, 0.4, 9, 9, 0, 0, 9, 9, 0, 0}}};
const DataTable thermo{"thermo", {"step", "time", "total_energy"}, {{0, 0.0, -2.0}, {3, 0.3, -2.1}, {4, 0.4, -1.9}}};

}  // namespace

TEST_CASE("columns tell how many bodies there are, and in how many dimensions") {
    CHECK(track_shape(trajectory).bodies == 2);
    CHECK(track_shape(trajectory).dimensions == 2);
    CHECK(track_shape(thermo).bodies == 0);
}

TEST_CASE("errors of the energy are relative to the first, absolute where that is zero") {
    CHECK(energy_errors(thermo)[1] == Approx(-0.05));
    CHECK(energy_errors({"t", {"total_energy"}, {{0.0}, {0.5}}})[1] == 0.5);
    CHECK(energy_errors({"t", {"total_energy"}, {}}).empty());
}

TEST_CASE("a frame has the energy of the last row before it") {
    const Data tracks = body_tracks(trajectory, thermo, {1.0, 0.5});
    CHECK(tracks["bodies"] == Data::list({{{"name", "body 1"}, {"mass", 1.0}}, {{"name", "body 2"}, {"mass", 0.5}}}));
    CHECK(tracks["times"] == Data::list({0.0, 0.2, 0.4}));
    CHECK(tracks["energy_error"][1] == 0.0);
    CHECK(tracks["energy_error"][2].number() == Approx(0.05));
    CHECK(tracks["positions"].text().size() == (3 * 2 * 3 * 4 + 2) / 3 * 4);
    CHECK(body_tracks(trajectory, thermo, {}, 2)["words"] == "2 of 3 frames are shown, to keep the page small.");
    CHECK(body_tracks(thermo, thermo, {}).is_null());
}
