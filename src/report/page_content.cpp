#include "report/page_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace ljmd {

namespace {

/// As many digits as a chart needs; the files have all.
double rounded(double number) {
    return std::isfinite(number) ? to_number(fmt::format("{:.9g}", number)).value_or(number) : number;
}

void add_if(Data& object, const char* key, const std::string& text) {
    if (!text.empty()) {
        object[key] = text;
    }
}

void add_if(Data& object, const char* key, const std::optional<double>& number) {
    if (number) {
        object[key] = *number;
    }
}

Data pairs_data(const TextPairs& pairs) {
    Data list = Data::list();
    for (const auto& [key, text] : pairs) {
        list.push_back(Data::list({key, text}));
    }
    return list;
}

Data object_data(const TextPairs& pairs) {
    Data object = Data::object();
    for (const auto& [key, text] : pairs) {
        object[key] = text;
    }
    return object;
}

Data mark_data(const Mark& mark) {
    Data data = {{"type", mark.type}, {"label", mark.label}};
    add_if(data, "table", mark.table);
    add_if(data, "x", mark.x);
    add_if(data, "y", mark.y);
    add_if(data, "error", mark.error);
    add_if(data, "group", mark.group);
    add_if(data, "flag", mark.flag);
    add_if(data, "fill", mark.fill);
    add_if(data, "tip", mark.tip);
    add_if(data, "value", mark.value);
    data["colour"] = mark.colour;
    return data;
}

Data axis_data(const Axis& axis) {
    return {{"label", axis.label}, {"scale", axis.scale}};
}

Data chart_data(const Chart& chart) {
    Data marks = Data::list();
    for (const Mark& mark : chart.marks) {
        marks.push_back(mark_data(mark));
    }
    Data data = {{"id", chart.id},     {"title", chart.title},    {"caption", chart.caption},
                 {"lead", chart.lead}, {"x", axis_data(chart.x)}, {"y", axis_data(chart.y)},
                 {"marks", marks}};
    if (chart.follows_time) {
        data["cursor"] = true;
    }
    if (chart.equal_axes) {
        data["equal"] = true;
    }
    return data;
}

Data table_data(const PageTable& table) {
    Data columns = Data::list();
    for (const PageColumn& column : table.columns) {
        static constexpr std::string_view error = "_standard_error";
        Data described = {
            {"name", column.name}, {"label", column.label.empty() ? column.name : column.label}, {"unit", column.unit}};
        const std::string of =
            column.name.ends_with(error) ? column.name.substr(0, column.name.size() - error.size()) : "";
        if (table.has_column(of)) {
            described["error_of"] = of;
        }
        columns.push_back(std::move(described));
    }
    const std::size_t shown = table.values.empty() ? 0 : table.values.front().size();
    Data data = {{"name", table.name},    {"title", table.title},
                 {"file", table.file},    {"rows", std::max<Index>(table.rows, static_cast<Index>(shown))},
                 {"shown", shown},        {"columns", columns},
                 {"values", table.values}};
    add_if(data, "flag", table.flag);
    if (table.lead) {
        data["lead"] = true;
    }
    return data;
}

Data quantity_data(const Quantity& quantity, const std::string& mark) {
    const double unknown = std::nan("");
    Data data = {{"name", quantity.name}};
    add_if(data, "symbol", quantity.symbol);
    data["value"] = quantity.value;
    data["error"] = quantity.error;
    data["unit"] = quantity.unit;
    data["text"] = std::isfinite(quantity.value) ? with_error(quantity.value, quantity.error.value_or(unknown))
                                                 : std::string("no value");
    add_if(data, "samples", quantity.samples);
    if (quantity.value_in_si) {
        data["si_value"] = *quantity.value_in_si;
        data["si_error"] = quantity.error_in_si;
        data["si_unit"] = quantity.si_unit;
        data["si_text"] = with_error(*quantity.value_in_si, quantity.error_in_si.value_or(unknown));
    }
    add_if(data, "mark", mark);
    if (quantity.reference) {
        data["reference"] = {{"value", *quantity.reference},
                             {"error", quantity.reference_error},
                             {"label", quantity.reference_label},
                             {"text", with_error(*quantity.reference, quantity.reference_error.value_or(unknown))}};
    }
    return data;
}

}  // namespace

void PageTable::add(PageColumn column, const std::vector<double>& numbers) {
    Data::List items;
    items.reserve(numbers.size());
    for (const double number : numbers) {
        items.emplace_back(rounded(number));
    }
    add(std::move(column), std::move(items));
}

void PageTable::add(PageColumn column, const std::vector<std::string>& texts) {
    add(std::move(column), Data::List(texts.begin(), texts.end()));
}

void PageTable::add(PageColumn column, Data::List items) {
    columns.push_back(std::move(column));
    values.push_back(std::move(items));
}

bool PageTable::has_column(const std::string& column) const {
    return std::ranges::find(columns, column, &PageColumn::name) != columns.end();
}

Data page_data(const PageContent& content) {
    Data verdicts = Data::list();
    for (const auto& [subject, level, words] : content.verdicts) {
        verdicts.push_back({{"subject", subject}, {"level", level}, {"words", words}});
    }
    Footnotes footnotes;
    Data quantities = Data::list();
    std::vector<std::string> notes;
    for (const Quantity& quantity : content.quantities) {
        const std::string mark = footnotes.mark(quantity.remark);
        quantities.push_back(quantity_data(quantity, mark));
        const std::string note = fmt::format("{} {}", mark, quantity.remark);
        if (!mark.empty() && std::ranges::find(notes, note) == notes.end()) {
            notes.push_back(note);
        }
    }
    Data charts = Data::list();
    for (const Chart& chart : content.charts) {
        charts.push_back(chart_data(chart));
    }
    Data tables = Data::list();
    for (const PageTable& table : content.tables) {
        tables.push_back(table_data(table));
    }
    Data data = {{"format", "ljmd-report"},
                 {"version", 1},
                 {"kind", content.kind},
                 {"title", content.title},
                 {"source", content.source},
                 {"state", content.state},
                 {"state_words", content.state_words},
                 {"program", object_data(content.program)},
                 {"provenance", pairs_data(content.provenance)},
                 {"verdict", verdicts},
                 {"warnings", content.warnings},
                 {"quantities", quantities},
                 {"footnotes", notes},
                 {"charts", charts},
                 {"tables", tables},
                 {"downloads", object_data(content.downloads)}};
    for (const auto& [key, part] :
         {std::pair{"atoms", &content.atoms}, {"tracks", &content.tracks}, {"points", &content.points}}) {
        if (!part->is_null()) {
            data[key] = *part;
        }
    }
    if (!content.members.empty()) {
        Data& members = data["members"];
        for (const auto& [label, member] : content.members) {
            members.push_back({{"label", label}, {"payload", page_data(member)}});
        }
    }
    if (content.reload) {
        data["reload"] = *content.reload;
    }
    return data;
}

}  // namespace ljmd
