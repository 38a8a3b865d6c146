#include "io/formats/extended_xyz_header.hpp"

#include "catch.hpp"

#include "io/written_file.hpp"

using namespace ljmd;
using ljmd::test::data_error;
using ljmd::test::WrittenFile;

namespace {

ExtendedXyzHeader parse(const std::string& comment, const std::string& beside = {}) {
    const WrittenFile written(comment + "\n");
    TextFile file(written.path());
    file.next_line();
    return parse_extended_xyz_header(file, beside);
}

const std::string lattice = "Lattice=\"4 0 0 0 5 0 0 0 6\" ";

}  // namespace

TEST_CASE("keys of an extended XYZ comment line: quoted and bare, in any case, unknown ones skipped") {
    const ExtendedXyzHeader header = parse(
        "made by=ljmd title=\"a \\\"step=7\\\" = b\" LATTICE=\"4.0 0 -0.0  0 5 0 0 0 6\" energy=-1.5 pbc=\"T T T\" "
        "time=\"2.5\" "
        "Step=40 units=si");
    CHECK(header.edges == Vec3(4, 5, 6));
    CHECK(header.time == 2.5);
    CHECK(header.step == Index{40});
    CHECK(header.si == true);
    CHECK_FALSE(header.tells_unwrapped);
    CHECK(parse(lattice + "positions=unwrapped").tells_unwrapped);
    CHECK_FALSE(parse(lattice + "positions=wrapped").tells_unwrapped);
    CHECK_FALSE(parse(lattice).time.has_value());
    CHECK_FALSE(parse(lattice).step.has_value());
    CHECK(parse(lattice + "units=reduced").si == false);
    CHECK_FALSE(parse(lattice).si.has_value());
    CHECK(parse(lattice + "pbc=\"True true T\"").edges == Vec3(4, 5, 6));
}

TEST_CASE("a lattice may stand in double or single quotes, in braces or in brackets, nested or not, with commas") {
    for (const std::string value :
         {"\"4 0 0 0 5 0 0 0 6\"", "'4 0 0 0 5 0 0 0 6'", "{4 0 0 0 5 0 0 0 6}", "[4, 0, 0, 0, 5, 0, 0, 0, 6]",
          "[[4, 0, 0], [0, 5, 0], [0, 0, 6]]", "{{4 0 0} {0 5 0} {0 0 6}}", "\"4.0D0 0 0 0 5 0 2e-16 0 6\""}) {
        CAPTURE(value);
        const ExtendedXyzHeader header = parse("Lattice=" + value + " step=7");
        CHECK(header.edges == Vec3(4, 5, 6));
        CHECK(header.step == Index{7});
    }
}

TEST_CASE("a box is periodic by T, True, TRUE, true or 1 in each direction") {
    for (const std::string value :
         {"\"T T T\"", "\"1 1 1\"", "\"TRUE True true\"", "[T, T, T]", "{1 1 1}", "'t t t'", "[True, True, True]"}) {
        CAPTURE(value);
        CHECK(parse(lattice + "pbc=" + value).edges == Vec3(4, 5, 6));
    }
}

TEST_CASE("words that are no key=value are skipped, whatever they are") {
    const std::string box = " Lattice=\"4 0 0 0 5 0 0 0 6\" ";
    for (const std::string words : {"i = 1, time = 0.500, E = -12.5", "864", "1 2 3", "= = =", "a == b",
                                    "Verlet's argon", "step= 5", "\"a title\"", "energy=-1 Energy=-2 ENERGY=-3"}) {
        CAPTURE(words);
        CHECK(parse(words + box).edges == Vec3(4, 5, 6));
        CHECK_FALSE(parse(box + words).time.has_value());
        CHECK_FALSE(parse(box + words).step.has_value());
    }
}

TEST_CASE("what comment lines lack can be told beside them, and nothing else") {
    const std::string cp2k = " i = 1, time = 0.500, E = -12.5";
    const ExtendedXyzHeader header = parse(cp2k, "Lattice=\"4 0 0 0 5 0 0 0 6\" units=si");
    CHECK(header.edges == Vec3(4, 5, 6));
    CHECK(header.si == true);
    CHECK_FALSE(header.time.has_value());
    CHECK(header.columns.position == 1);
    CHECK(parse(lattice, "Properties=pos:R:3").columns.position == 0);
    CHECK_THAT(data_error([&] { (void)parse(lattice, "lattice={5 0 0 0 5 0 0 0 6}"); }),
               Catch::Contains("Lattice= is given in the comment line and beside the file (xyz_comment)"));
    CHECK_THAT(data_error([&] { (void)parse(cp2k); }),
               Catch::Contains("no Lattice=") && Catch::Contains("--xyz-comment"));
}

TEST_CASE("columns are found by the names of their properties") {
    const ExtendedXyzColumns given =
        parse(lattice + "Properties=id:I:1:forces:R:3:pos:R:3:tag:L:2:species:S:1:velo:R:3:mass:R:1").columns;
    CHECK(given.id == std::size_t{0});
    CHECK(given.position == 4);
    CHECK(given.kinds == std::map<std::string, std::size_t>{{"species", 9}, {"mass", 13}});
    CHECK(given.velocity == std::size_t{10});
    CHECK(given.mass == std::size_t{13});
    CHECK(given.count == 14);

    const ExtendedXyzColumns absent = parse(lattice).columns;
    CHECK(absent.kinds == std::map<std::string, std::size_t>{{"species", 0}});
    CHECK(absent.position == 1);
    CHECK_FALSE(absent.velocity.has_value());
    CHECK(absent.count == 4);

    const ExtendedXyzColumns other_names = parse(lattice + "Properties=pos:R:3:vel:R:3:masses:R:1").columns;
    CHECK(other_names.kinds == std::map<std::string, std::size_t>{{"masses", 6}});
    CHECK(other_names.velocity == std::size_t{3});
    CHECK(parse(lattice + "Properties=pos:R:3:velocities:R:3").columns.velocity == std::size_t{3});
    CHECK(parse(lattice + "Properties=pos:R:3:momenta:R:3").columns.momentum == std::size_t{3});
    CHECK(other_names.mass == std::size_t{6});
}

TEST_CASE("comment lines that cannot be used are refused with the reason") {
    struct Case {
        std::string comment;
        std::string fragment;
    };
    const std::vector<Case> cases{
        {"", "no Lattice="},
        {"argon at 94.4 K", "no Lattice="},
        {"Lattice=\"4 0 0 0 5 0 0 0\"", "Lattice needs 9 numbers, found 8"},
        {"Lattice=4", "Lattice needs 9 numbers, found 1"},
        {"Lattice=\"4 0 0 0 5 0 0 0 six\"", "Lattice must be a finite number, found 'six'"},
        {"Lattice=\"4 0 0 0 5 0 0 0 nan\"", "Lattice must be a finite number, found 'nan'"},
        {"Lattice=\"4 0 0 0.1 5 0 0 0 6\"", "only orthorhombic boxes can be read"},
        {"Lattice=\"4 0 0 0 5 0 0 -1e-9 6\"", "only orthorhombic boxes can be read"},
        {"Lattice=\"-4 0 0 0 5 0 0 0 6\"", "with positive ax, by, cz"},
        {"Lattice=\"4 0 0 0 0 0 0 0 6\"", "with positive ax, by, cz"},
        {"Lattice=\"4 0 0 0 5 0 0 0 6", "no closing quote after 'Lattice'="},
        {"Lattice={4 0 0 0 5 0 0 0 6", "no closing brace after 'Lattice'="},
        {"Lattice=[[4 0 0 0 5 0 0 0 6]", "no closing bracket after 'Lattice'="},
        {"Lattice='4 0 0 0 5 0 0 0 6", "no closing quote after 'Lattice'="},
        {lattice + "LATTICE=\"5 0 0 0 5 0 0 0 5\"",
         "key 'lattice' is given twice, Lattice='4 0 0 0 5 0 0 0 6' and LATTICE='5 0 0 0 5 0 0 0 5'"},
        {lattice + "Time=1 time=2", "key 'time' is given twice, Time='1' and time='2'"},
        {lattice + "pbc=\"1 1 0\"", "the box must be periodic"},
        {lattice + "pbc=\"T T F\"", "the box must be periodic, pbc=\"T T T\", found 'T T F'"},
        {lattice + "pbc=T", "the box must be periodic"},
        {lattice + "units=metal", "units must be 'reduced' or 'si', found 'metal'"},
        {lattice + "Time=inf", "Time must be a finite number"},
        {lattice + "step=1.5", "step must be an integer, found '1.5'"},
        {lattice + "step=-1", "step must not be negative"},
        {lattice + "Properties=", "Properties must be a list of name:type:columns"},
        {lattice + "Properties=species:S:1:pos:R", "Properties must be a list of name:type:columns"},
        {lattice + "Properties=species:S:1:pos:R:three", "the columns of property 'pos' must be an integer"},
        {lattice + "Properties=pos:R:3:x:R:0", "property 'x' cannot have 0 columns"},
        {lattice + "Properties=pos:R:3:x:R:9000000000000000000",
         "property 'x' cannot have 9000000000000000000 columns"},
        {lattice + "Properties=species:S:1", "Properties has no pos:R:3"},
        {lattice + "Properties=pos:R:2", "property 'pos' must be R:3, found 'R':2"},
        {lattice + "Properties=pos:S:3", "property 'pos' must be R:3, found 'S':3"},
        {lattice + "Properties=pos:R:3:id:R:1", "property 'id' must be I:1, found 'R':1"},
        {lattice + "Properties=pos:R:3:velo:R:3:vel:R:3", "Properties gives 'vel' twice"}};
    for (const Case& wrong : cases) {
        CAPTURE(wrong.comment);
        CHECK_THAT(data_error([&] { (void)parse(wrong.comment); }),
                   Catch::Contains("start.txt:1: ") && Catch::Contains(wrong.fragment));
    }
}
