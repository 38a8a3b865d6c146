#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/files/open_directory.hpp"
#include "study/reproduction.hpp"
#include "study/run_lines.hpp"

namespace ljmd {

/// The folder with the rows of a reproduced table, in its directory.
inline constexpr const char* rows_folder = "rows";

/// A row of the table being computed: a deck, a directory, and runs that follow one another until its errors are small
/// enough.
class RowRun : public RunLine {
  public:
    /// @param folder  of all rows
    RowRun(const VerletRow& row, const std::filesystem::path& folder, const ReproductionLength& length);

    [[nodiscard]] static std::string deck_name(const VerletRow& row) { return row_name(row) + ".toml"; }

    [[nodiscard]] const ChildRun& run() const override { return run_; }

    /// What was found, as far as the run has come; nothing before it has come to the end of its first part.
    [[nodiscard]] const std::optional<ReproducedRow>& result() const { return result_; }

    /// Refuse a directory with a run of another deck. @throws InputError
    void check(bool force) const;

    /// Write the deck. @param folder  of all rows
    void prepare(const OpenDirectory& folder) const;

  private:
    [[nodiscard]] std::optional<Job> first_job() override;
    [[nodiscard]] std::optional<Job> next_job() override;

    VerletRow row_;
    ReproductionLength length_;
    ChildRun run_;
    std::optional<ReproducedRow> result_;
};

/// The rows that are asked for, and how long their runs are.
struct ReproductionPlan {
    std::vector<VerletRow> rows;
    bool quick;

    [[nodiscard]] ReproductionLength length() const {
        return quick ? ReproductionLength::quick() : ReproductionLength::full();
    }
};

/// The rows of a plan in the directory of the table.
[[nodiscard]] std::vector<RowRun> row_runs(const ReproductionPlan& plan, const std::filesystem::path& directory);

/// Prepare a directory: write reproduction.json, which says what workers do, and the decks of the rows.
/// @pre the directory is locked  @throws InUseError  workers run rows of another plan  @throws FileError
void prepare_reproduction(const ReproductionPlan& plan, const OpenDirectory& directory);

/// What reproduction.json says; nothing if there is none.
/// @throws DataError  it is damaged, or `ljmd reproduce` cannot have written it
[[nodiscard]] std::optional<ReproductionPlan> recorded_reproduction(const std::filesystem::path& directory);

}  // namespace ljmd
