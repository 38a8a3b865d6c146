#include "fuzz_target.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "study/reproduction.hpp"
#include "study/sweep_report.hpp"

using namespace ljmd;

namespace {

/// A row of Verlet's table, with what its run leaves beside results.json.
class RowOfTable {
  public:
    RowOfTable() {
        std::ofstream(file_.directory() / "thermo.csv")
            << "step,temperature,potential_energy,pressure\n5,0.8,-6.1,0.1\n10,0.7,-6.0,0.2\n15,0.8,-6.1,0.3\n";
        std::ofstream(file_.directory() / "rdf.csv") << "r,g\n2.45,0.9\n2.55,1.1\n";
    }
    void evaluate(std::string_view results) const {
        file_.rewrite(results);
        const VerletRow& row = verlet1967_table().front();
        fuzz::require(evaluate_row(row, file_.directory()).steps >= 0, "a row has fewer steps than none");
    }
    [[nodiscard]] const std::filesystem::path& results() const { return file_.path(); }

  private:
    test::WrittenFile file_{"", "results.json"};
};

}  // namespace

// results.json, as a sweep and a reproduced table read it.
LJMD_FUZZ_TARGET(run_results) {
    static const RowOfTable row;
    try {
        row.evaluate(fuzz::text_of(data, size));
        ++fuzz::inputs_accepted;
    } catch (const DataError&) {
    }
    try {
        const SweptPoint point{"T=1", {"1"}, "points", read_results(row.results()).means, ""};
        const SweptPoints swept{{"system.temperature"}, {point}};
        static_cast<void>(to_json(sweep_report(swept).data) + sweep_csv(swept) + point_line(point));
        ++fuzz::inputs_accepted;
    } catch (const DataError&) {
    }
    return 0;
}
