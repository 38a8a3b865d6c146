#include "ljmd/io/extended_xyz_header.hpp"

#include <catch2/catch.hpp>

#include "io/written_file.hpp"

using namespace ljmd;
using ljmd::test::data_error;
using ljmd::test::WrittenFile;

namespace {

ExtendedXyzHeader parse(const std::string& comment) {
    const WrittenFile written(comment + "\n");
    TextFile file(written.path());
    file.next_line();
    return parse_extended_xyz_header(file);
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

TEST_CASE("columns are found by the names of their properties") {
    const ExtendedXyzColumns given =
        parse(lattice + "Properties=id:I:1:forces:R:3:pos:R:3:tag:L:2:species:S:1:velo:R:3:mass:R:1").columns;
    CHECK(given.id == std::size_t{0});
    CHECK(given.position == 4);
    CHECK(given.species == std::size_t{9});
    CHECK(given.kinds == std::map<std::string, std::size_t>{{"species", 9}, {"mass", 13}});
    CHECK(given.velocity == std::size_t{10});
    CHECK(given.mass == std::size_t{13});
    CHECK(given.count == 14);

    const ExtendedXyzColumns absent = parse(lattice).columns;
    CHECK(absent.species == std::size_t{0});
    CHECK(absent.kinds == std::map<std::string, std::size_t>{{"species", 0}});
    CHECK(absent.position == 1);
    CHECK_FALSE(absent.velocity.has_value());
    CHECK(absent.count == 4);

    const ExtendedXyzColumns other_names = parse(lattice + "Properties=pos:R:3:vel:R:3:masses:R:1").columns;
    CHECK_FALSE(other_names.species.has_value());
    CHECK(other_names.kinds == std::map<std::string, std::size_t>{{"masses", 6}});
    CHECK(other_names.velocity == std::size_t{3});
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
        {"Lattice=\"4 0 0 0 5 0 0 0 6", "no closing quote after 'lattice'="},
        {lattice + lattice, "key 'lattice' is given twice"},
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
