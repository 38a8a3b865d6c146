#include "judge/answer_reader.hpp"

#include <fmt/format.h>
#include "catch.hpp"

#include "io/output_fixtures.hpp"
#include "judge/small_problem.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A problem of two atoms, and the directory of its answer.
struct Place {
    TemporaryFolder folder;
    Problem problem = [] {
        Problem two = small_problem();
        two.fluid.edges = Vec3(5, 6, 7);
        two.fluid.masses.resize(2);
        two.fluid.positions.resize(2);
        two.fluid.velocities.resize(2);
        return two;
    }();

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
    [[nodiscard]] Answer read() const { return read_answer(folder / "", problem); }
    [[nodiscard]] std::string complaint() const {
        try {
            static_cast<void>(read());
        } catch (const DataError& error) {
            return error.what();
        }
        return "";
    }
};

std::string frame(const std::string& more, const std::string& edges = "5 0 0 0 6 0 0 0 7") {
    return fmt::format("2\nLattice=\"{}\" Properties=species:S:1:pos:R:3:forces:R:3 {}\nX 1 1 1 1 2 3\nX 2 2 2 4 5 6\n",
                       edges, more);
}

}  // namespace

TEST_CASE("all files of an answer are read, and none need be there") {
    const Place place;
    CHECK_FALSE(has_answer(place.folder / ""));
    CHECK(place.read().point.is_empty());
    place.write(
        "point.json",
        R"({"engine": "mine", "potential_energy": -1.5, "virial": [[1, 9, 9], [9, 2, 9], [9, 9, 3]], "pressure": 2,
                    "forces": [[1, 2, 3], [4, 5, 6]], "degrees_of_freedom": 6})");
    place.write("frames.xyz", frame("step=0") + frame("step=10"));
    place.write("thermo.csv", "step,volume,kinetic_energy\n0,210,1.5\n5,211,2.5\n");
    CHECK(has_answer(place.folder / ""));
    const Answer answer = place.read();
    CHECK(answer.engine == "mine");
    CHECK(answer.degrees_of_freedom == 6);
    CHECK(answer.point.potential_energy == -1.5);
    CHECK(answer.point.virial == 6.0);
    CHECK(answer.point.pressure == 2.0);
    CHECK_FALSE(answer.point.temperature);
    CHECK(answer.point.forces == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
    REQUIRE(answer.frames.size() == 2);
    CHECK(answer.frames[1].configuration.step == 10);
    CHECK(answer.frames[1].forces[1] == Vec3(4, 5, 6));
    CHECK(answer.thermo->steps == std::vector<Index>{0, 5});
    CHECK(answer.thermo->volume == std::vector<double>{210, 211});
    CHECK(answer.thermo->kinetic_energy == std::vector<double>{1.5, 2.5});
    CHECK(answer.thermo->pressure.empty());
    CHECK(answer.warnings.empty());
}

TEST_CASE("forces may stand in a frame of their own, and times in the place of steps") {
    const Place place;
    place.write("point.xyz", frame(""));
    place.write("frames.extxyz", frame("Time=0") + frame("Time=0.04"));
    const Answer answer = place.read();
    CHECK(answer.point.forces[0] == Vec3(1, 2, 3));
    CHECK(answer.frames.at(1).configuration.step == 10);
}

TEST_CASE("of however many frames only the judged ones are kept, once each, and one that shows that there are some") {
    Place place;
    place.problem.frames = {10, 20};
    std::string many;
    for (int step = 1; step <= 1000; ++step) {
        many += frame(fmt::format("step={}", step % 50));
    }
    place.write("frames.xyz", many);
    std::vector<Index> steps;
    for (const Frame& each : place.read().frames) {
        steps.push_back(each.configuration.step.value());
    }
    CHECK(steps == std::vector<Index>{1, 10, 20});
    place.write("thermo.csv", "step,kinetic_energy\n0,1\n");
    std::filesystem::resize_file(place.folder / "thermo.csv", std::uintmax_t{257} << 20U);  // of zeros, without blocks
    CHECK_THAT(place.complaint(), Contains("thermo.csv is larger than 256 MiB: write fewer rows"));
}

TEST_CASE("an answer that cannot be used is refused with the file and what is expected") {
    struct Wrong {
        std::string name;
        std::string text;
        std::string words;
    };
    for (const Wrong& wrong : std::vector<Wrong>{
             {"point.json", "[1]", "it holds no object"},
             {"point.json", R"({"virial": "1"})", "'virial' is no finite number"},
             {"point.json", R"({"virial": [1, 2, 3]})", "neither a number nor a tensor"},
             {"point.json", R"({"forces": [[1, 2, 3]]})", "'forces' holds 1 vectors, the problem has 2 atoms"},
             {"point.json", R"({"forces": [[1, 2, 3], [1, 2]]})", "force 2 has 2 components"},
             {"point.json", R"({"degrees_of_freedom": 7})", "degrees_of_freedom"},
             {"point.json", R"({"virial": )", "point.json is not a point"},
             {"point.xyz", "2\nLattice=\"5 0 0 0 6 0 0 0 7\"\nX 1 1 1\nX 2 2 2\n",
              "must hold one frame with forces, it has none"},
             {"point.xyz", frame("step=0") + frame("step=1"), "it has 2 frames"},
             {"point.xyz",
              "2\nLattice=\"5 0 0 0 6 0 0 0 7\" Properties=species:S:1:pos:R:3:forces:R:3\nX 1 1 1 0 0 0\nX 2 2 2 0 "
              "nan 0\n",
              "frame 1: atom 2 has a force that is not finite"},
             {"frames.xyz", frame("step=0", "5 0 0 0 6 0 0 0 7.1"), "the edges of the box are 5, 6, 7.1"},
             {"frames.xyz", "1\nLattice=\"5 0 0 0 6 0 0 0 7\" step=0\nX 1 1 1\n",
              "frame 1 has 1 atoms, the problem has 2"},
             {"frames.xyz", frame(""), "frame 1 has no step and no time"},
             {"frames.xyz", frame("Time=0.0051"), "not a multiple of the time step"},
             {"frames.xyz", frame("step=0") + frame("step=1").substr(0, 100), "the file is cut off"},
             {"thermo.csv", "step,kinetic_energy\n", "has no row"},
             {"thermo.csv", "kinetic_energy\n1\n", "no column 'step'"},
             {"thermo.csv", "step,kinetic_energy\n0,\n", "kinetic_energy"},
             {"thermo.csv", "step,kinetic_energy\n5,1\n5,1\n", "grow from row to row"}}) {
        const Place place;
        place.write(wrong.name, wrong.text);
        INFO(wrong.name << ": " << wrong.text);
        CHECK_THAT(place.complaint(), Contains(wrong.words) && Contains(wrong.name.substr(0, wrong.name.find('.'))));
    }
}

TEST_CASE("of an engine that blows up all is read that comes before, and it is said where that ends") {
    const std::string with_velocities =
        "2\nLattice=\"5 0 0 0 6 0 0 0 7\" Properties=species:S:1:pos:R:3:velo:R:3 step=10\nX 1 1 1 0 0 0\n";
    const auto with_number = [](const std::string& step, const std::string& number) {
        std::string text = frame(step);
        return text.replace(text.find("X 2 2"), 5, "X 2 " + number);
    };
    for (const auto& [bad, words] :
         {std::pair(with_number("step=10", "nan"), "found 'nan'"),
          std::pair(with_number("step=10", "9e7"), "atom 2 is more than 1000000 edges away from the box"),
          std::pair(frame("step=10").replace(frame("step=10").find("4 5 6"), 5, "4 inf 6"),
                    "atom 2 has a force that is not finite"),
          std::pair(with_velocities + "X 2 2 2 0 -inf 0\n", "found '-inf'")}) {
        const Place place;
        place.write("frames.xyz", frame("step=0") + frame("step=1") + bad + frame("step=50"));
        const Answer answer = place.read();
        CHECK(answer.frames.size() == 2);
        REQUIRE(answer.losses.size() == 1);
        CHECK(answer.losses[0].check == "frames.xyz: frame 3 (step 10): finite, and near the box");
        CHECK_THAT(answer.losses[0].words, Contains("the engine blew up: frame 3 (step 10): ") && Contains(words) &&
                                               Contains("; the frames before it are judged"));
        place.write("frames.xyz", bad);  // nothing comes before
        CHECK_THAT(place.complaint(), Contains("frames.xyz"));
    }
    const Place place;
    place.write("frames.xyz", frame("step=0") + frame("step=3") + with_number("step=7", "nan"));
    CHECK_THAT(place.read().losses.at(0).words, Contains("frame 3, after step 3: "));
    place.write("thermo.csv", "step,kinetic_energy\n0,1\n5,2\n10,inf\n15,nan\n");
    const Answer answer = place.read();
    CHECK(answer.thermo->steps == std::vector<Index>{0, 5});
    CHECK_THAT(answer.losses.at(1).words,
               Contains("in line 4: ") && Contains("'inf'") && Contains("the rows before it are judged"));
    place.write("frames.xyz", frame("step=0") + with_number("step=1", "abc"));
    CHECK_THAT(place.complaint(), Contains("found 'abc'"));  // no number at all
}

TEST_CASE("a table is read as NumPy writes it, and its columns are named where they are not known") {
    const Place place;
    for (const char* text : {"# step, kinetic_energy\n0, 1.5\n5, 2.5\n", "\"step\",\"kinetic_energy\"\n0,1.5\n5,2.5\n",
                             "#step,kinetic_energy\n0.000e+00,1.5\n5.0e+00,2.5\n"}) {
        place.write("thermo.csv", text);
        CHECK(place.read().thermo->steps == std::vector<Index>{0, 5});
        CHECK(place.read().thermo->kinetic_energy == std::vector<double>{1.5, 2.5});
    }
    place.write("thermo.csv", "step kinetic_energy\n0 1.5\n5 2.5\n");
    CHECK_THAT(place.complaint(), Contains("the columns found are 'step kinetic_energy'; separate them with commas"));
}

TEST_CASE("frames without a box are refused without advice for other commands") {
    const Place place;
    place.write("frames.xyz", "2\nstep=0\nX 1 1 1\nX 2 2 2\n");
    CHECK_THAT(place.complaint(), Contains("the periodic box is missing") && !Contains("xyz_comment"));
}

TEST_CASE("of an answer only the files are read whose parts are judged") {
    Place place;
    place.write("point.json", R"({"engine": "mine", "degrees_of_freedom": 6, "potential_energy": "none"})");
    place.write("point.xyz", "2\n");
    place.write("frames.xyz", "damaged");
    place.write("frames.dump", "damaged");
    place.write("thermo.csv", "damaged");
    CHECK(has_answer(place.folder / ""));
    for (const auto& [part, file] :
         {std::pair{"point", "point.json"}, std::pair{"trajectory", "frames"}, std::pair{"averages", "thermo.csv"}}) {
        place.problem.parts = {part};
        CHECK_THAT(place.complaint(), Contains(file));
    }
    place.problem.parts = {"speed"};
    const Answer answer = place.read();
    CHECK(answer.point.is_empty());
    CHECK(answer.engine == "mine");
    CHECK(answer.degrees_of_freedom == 6);
}

TEST_CASE("two files of one kind, and keys that nobody knows") {
    const Place place;
    place.write("point.json", R"({"forces": [[1, 2, 3], [4, 5, 6]], "potential": 1})");
    CHECK_THAT(place.read().warnings.at(0), Contains("'potential' is not known"));
    place.write("point.xyz", frame(""));
    CHECK_THAT(place.complaint(), Contains("one of them is enough"));
    place.write("point.dump", "");
    CHECK_THAT(place.complaint(), Contains("it is not known which one counts"));
}
