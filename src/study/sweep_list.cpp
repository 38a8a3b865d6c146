#include <fmt/format.h>

#include <map>

#include "core/text.hpp"
#include "io/files/text_file.hpp"
#include "io/tables/csv_text.hpp"
#include "study/sweep_points.hpp"

namespace ljmd {

namespace {

constexpr Index max_bytes = Index{1} << 24;

/// Reads the whole text, so that messages can show its lines.
std::shared_ptr<const Source> read_source(const std::filesystem::path& path) {
    TextFile file(path);
    if (file.bytes_left() > max_bytes) {
        file.fail_at(0, fmt::format("larger than {} MiB, which no list of points is", max_bytes >> 20U));
    }
    Source source{path.string(), ""};
    while (file.next_line()) {
        source.text.append(file.line()).push_back('\n');
    }
    return std::make_shared<const Source>(std::move(source));
}

/// Parses a list line by line.
class ListReader {
  public:
    ListReader(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
        : source_(std::move(source)), diagnostics_(diagnostics) {}

    SweepPoints read(const std::vector<std::string>& settings) {
        std::string_view rest = source_->text;
        for (int line = 1; !rest.empty() && !header_is_wrong_; ++line) {
            const std::size_t end = rest.find('\n');
            if (!is_blank(rest.substr(0, end))) {
                take(rest.substr(0, end), {source_, line, 1}, settings);
            }
            rest.remove_prefix(end + 1);
        }
        if (points_.values.empty() && !diagnostics_.has_errors()) {
            diagnostics_.error({source_}, "no points", "the first line holds keys, every other one their values");
        }
        if (points_.values.size() > max_points) {
            diagnostics_.error({source_},
                               fmt::format("{} points, at most {} are allowed", points_.values.size(), max_points));
        }
        return diagnostics_.has_errors() ? SweepPoints{} : std::move(points_);
    }

  private:
    void take(std::string_view line, const Location& where, const std::vector<std::string>& settings) {
        const bool is_header = points_.keys.empty();
        auto fields = csv_fields(line);
        if (!fields) {
            diagnostics_.error(where, "a quote is left open, or closed in the middle of a field");
        } else if (is_header) {
            points_.keys = std::move(*fields);
            check_keys(points_.keys, settings, where, diagnostics_);
        } else {
            take_point(std::move(*fields), where);
        }
        header_is_wrong_ = is_header && diagnostics_.has_errors();
    }

    void take_point(std::vector<std::string> fields, const Location& where) {
        if (fields.size() != points_.keys.size()) {
            diagnostics_.error(where,
                               fmt::format("{} fields, but {} keys in the header", fields.size(), points_.keys.size()));
            return;
        }
        for (std::size_t k = 0; k < fields.size(); ++k) {
            if (fields[k].empty()) {
                diagnostics_.error(where, fmt::format("no value of {}", in_quotes(points_.keys[k])));
                return;
            }
        }
        const auto [earlier, is_new] = lines_.emplace(fields, where.line);
        if (!is_new) {
            diagnostics_.error(where, fmt::format("the same point as in line {}", earlier->second));
            return;
        }
        points_.values.push_back(std::move(fields));
    }

    std::shared_ptr<const Source> source_;
    Diagnostics& diagnostics_;
    SweepPoints points_;
    std::map<std::vector<std::string>, int> lines_;  ///< line numbers of the points
    bool header_is_wrong_ = false;                   ///< the lines below it are then meaningless
};

}  // namespace

SweepPoints list_points(const std::filesystem::path& file, const std::vector<std::string>& settings,
                        Diagnostics& diagnostics) {
    return ListReader(read_source(file), diagnostics).read(settings);
}

}  // namespace ljmd
