#include "io/formats/body_trajectory.hpp"

#include "catch.hpp"

#include "io/tables/data_table_csv.hpp"
#include "io/written_file.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

const std::string head = "Properties=species:S:1:pos:R:3:velo:R:3:id:I:1 pbc=\"F F F\" Time=";

std::string frame(const std::string& time, const std::string& first, const std::string& second) {
    return "2\n" + head + time + ".5 step=" + time + " units=reduced\nX " + first + " 1\nX " + second + " 2\n";
}

DataTable read(const std::string& text) {
    return read_body_trajectory(test::WrittenFile(text).path());
}

}  // namespace

TEST_CASE("bodies become columns, without coordinates that nobody uses") {
    const DataTable table = read(frame("0", "1 2 0 3 4 0", "5 6 0 7 8 0") + frame("1", "9 2 0 3 4 0", "5 6 0 7 8 0"));
    CHECK(table.columns ==
          std::vector<std::string>{"step", "time", "x1", "y1", "vx1", "vy1", "x2", "y2", "vx2", "vy2"});
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0] == std::vector<double>{0, 0.5, 1, 2, 3, 4, 5, 6, 7, 8});
    CHECK(column(table, "x1") == std::vector<double>{1, 9});
}

TEST_CASE("a coordinate that is used once is a column") {
    const DataTable table =
        read(frame("0", "0 0 0 0 0 0", "0 0 0 0 0 0") + frame("1", "0 0 0 0 0 0", "0 0 0 0 0 1e-9"));
    CHECK(column(table, "vz2") == std::vector<double>{0, 1e-9});
    CHECK(column(table, "z1") == std::vector<double>{0, 0});
}

TEST_CASE("a frame that is being written is ignored, wherever it ends") {
    const std::string whole = frame("0", "1 2 0 3 4 0", "5 6 0 7 8 0");
    const std::string next = frame("1", "9 2 0 3 4 0", "5 6 0 7 8 0");
    for (std::size_t length = 0; length < next.size(); ++length) {
        INFO(next.substr(0, length));
        CHECK(read(whole + next.substr(0, length)).rows.size() == 1);
    }
    CHECK(read(whole + next).rows.size() == 2);
}

TEST_CASE("what is damaged is told with its line") {
    const std::string whole = frame("0", "1 2 0 3 4 0", "5 6 0 7 8 0");
    CHECK_THROWS_WITH(read(whole + "3\n" + head + "1\n"), Contains(":5: 3 bodies, but the first frame has 2"));
    CHECK_THROWS_WITH(read(whole + frame("1", "a 2 0 3 4 0", "5 6 0 7 8 0")), Contains(":7: ") && Contains("'a'"));
    CHECK_THROWS_WITH(read(whole + frame("1", "1 2", "5 6")), Contains(":7: "));
    CHECK_THROWS_AS(read("2\nno properties\n"), DataError);
}
