#include "reference/verlet1967.hpp"
#include "report/pages/study_pages.hpp"
#include "report/report_fixtures.hpp"
#include "study/reproduction.hpp"
#include "study/reproduction_report.hpp"

using namespace ljmd;
using namespace ljmd::test;
namespace fs = std::filesystem;

TEST_CASE("rows that are finished are evaluated, drawn by their z-scores, and beside isotherms where there are any") {
    const TemporaryFolder folder;
    const std::vector<VerletRow>& table = verlet1967_table();
    for (const VerletRow& row : {table[1], table[0]}) {
        const fs::path deck = folder / ("rows/" + row_name(row) + ".toml");
        fs::create_directories(deck.parent_path());
        overwrite(deck, row_deck(row, {2, 2, 60, 1, 0.0, 0.0}));
        Diagnostics diagnostics;
        auto loaded = load_deck(deck, {}, true, diagnostics);
        REQUIRE(loaded.has_value());
        loaded->directory = folder / ("rows/" + row_name(row));
        run_whole(*loaded);
    }
    PageContent page = reproduction_page(folder / "");
    check_marks(page);
    CHECK(page.state == "finished");
    CHECK(page.charts.size() == 4);
    const PageTable& rows = table_called(page, "rows");
    CHECK(rows.flag == "suspect");
    const ReproducedRow first = evaluate_row(table[0], folder / ("rows/" + row_name(table[0])));
    CHECK(values_of(rows, "Z")[0].number() == Approx(first.z.mean));
    CHECK(values_of(rows, "z_score_U")[0].number() == Approx(first.z_scores().u));
    CHECK(chart_called(page, "scores-Z").marks[0].x == "z_score_Z");

    overwrite(folder / "isotherms.csv", isotherms_csv());
    page = reproduction_page(folder / "");
    check_marks(page);
    CHECK(chart_called(page, "isotherms").marks[0].group == "T");
}

TEST_CASE("a row that is damaged is told, and a table without rows has no charts") {
    const TemporaryFolder folder;
    const fs::path row = folder / ("rows/" + row_name(verlet1967_table()[0]));
    fs::create_directories(row);
    CHECK(reproduction_page(folder / "").charts.empty());
    overwrite(row / "results.json", "{}");
    CHECK(reproduction_page(folder / "").warnings.size() == 1);
}
