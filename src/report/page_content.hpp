#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/data.hpp"
#include "run/footnotes.hpp"

namespace ljmd {

// The content of a report's page, made in C++ and drawn by the page (src/report/web). src/report/web/README.md
// describes it.

/// One statement about a run.
struct Verdict {
    std::string subject;  ///< "equilibrium", "energy", ...
    std::string level;    ///< "good", "doubt", "bad" or "unknown"
    std::string words;
};

/// A column of a table on the page.
struct PageColumn {
    std::string name;
    std::string label = {};  ///< symbol, "T"; empty: the name
    std::string unit = {};
};

/// A table whose columns the charts draw, and which the page offers as CSV.
struct PageTable {
    std::string name;
    std::string title;
    std::string file = {};  ///< of the directory, that has all rows and digits; empty if there is none
    Index rows = 0;         ///< in that file
    bool lead = false;      ///< open from the start
    std::string flag = {};  ///< column of flags: these rows are marked
    std::vector<PageColumn> columns = {};
    std::vector<Data::List> values = {};  ///< of each column

    /// Numbers are rounded to 9 digits; what is not finite becomes null.
    void add(PageColumn column, const std::vector<double>& numbers);
    void add(PageColumn column, const std::vector<std::string>& texts);
    void add(PageColumn column, Data::List items);

    [[nodiscard]] bool has_column(const std::string& column) const;
};

/// What a chart draws: columns of a table, or a line at a fixed value.
struct Mark {
    std::string type;  ///< line, dots, band, steps, bars, cells, rule-x, rule-y, diverging-dots
    std::string label;
    std::string table = {};
    std::string x = {};
    std::string y = {};
    std::string error = {};            ///< column of standard errors
    std::string group = {};            ///< column that splits rows into series
    std::string flag = {};             ///< column of flags: these rows are marked
    std::string tip = {};              ///< column of texts for hints
    std::string fill = {};             ///< column that colours cells
    std::optional<double> value = {};  ///< of a rule
    int colour = 0;                    ///< a role, 0 to 7
};

struct Axis {
    std::string label;
    std::string scale = "linear";  ///< linear, log or category
};

struct Chart {
    std::string id;
    std::string title;
    std::string caption;
    bool lead = false;  ///< shown at the top
    Axis x;
    Axis y;
    std::vector<Mark> marks = {};
    bool follows_time = false;  ///< x is the time of the atoms or tracks: a line follows their playback
    bool equal_axes = false;    ///< one unit is as long along x as along y: a path in space
};

/// A quantity with its error.
struct Quantity {
    std::string name;
    std::string symbol = {};
    double value;
    std::optional<double> error = {};
    std::string unit = {};
    std::optional<double> samples = {};
    std::string remark = {};  ///< becomes a footnote
    std::optional<double> value_in_si = {};
    std::optional<double> error_in_si = {};
    std::string si_unit = {};
    std::optional<double> reference = {};        ///< of an equation of state at the same state
    std::optional<double> reference_error = {};  ///< from the error of the measured temperature
    std::string reference_label = {};
};

using TextPairs = std::vector<std::pair<std::string, std::string>>;

struct PageContent {
    std::string kind;                ///< run, few-body, sweep, reference, reproduction, comparison or set
    std::string title;               ///< the user's
    std::string source;              ///< the directory as it was given
    std::string state = "finished";  ///< finished, stopped, running, failed or damaged
    std::string state_words = {};
    std::optional<double> reload = {};  ///< seconds after which the page reads itself anew, see `ljmd report --follow`
    TextPairs program = {};
    TextPairs provenance = {};
    std::vector<Verdict> verdicts = {};
    std::vector<std::string> warnings = {};
    std::vector<Quantity> quantities = {};
    std::vector<Chart> charts = {};
    std::vector<PageTable> tables = {};
    Data atoms = {};   ///< see report/atom_frames.hpp; null if there are none
    Data tracks = {};  ///< see report/body_tracks.hpp; null if there are none
    TextPairs downloads = {};
    std::vector<std::pair<std::string, PageContent>> members = {};  ///< of a set, with their labels
    Data points = {};  ///< of a study: label, directory, state, words of each run; null if there are none
};

/// The content as the page reads it, and as `ljmd report --json` prints it.
[[nodiscard]] Data page_data(const PageContent& content);

/// Run `make`, which adds to a page; if its input cannot be used, the page goes without and `warnings` says why.
template <class Make>
void add_if_readable(std::vector<std::string>& warnings, const Make& make) {
    try {
        make();
    } catch (const Error& error) {
        warnings.emplace_back(error.what());
    }
}

}  // namespace ljmd
