#include "report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// A part of the page and its place in the frame.
struct Part {
    std::string_view place;
    std::string_view text;
    std::size_t at = 0;
};

}  // namespace

std::string json_for_html(const Data& data) {
    std::string text;
    for (const char letter : to_json_line(data)) {
        if (letter == '<') {
            text += "\\u003c";  // "</script>" would end the element, "<!--" would hide its end
        } else {
            text += letter;
        }
    }
    return text;
}

std::string page_html(const PageContent& content, const PageBundle& bundle) {
    const std::string data = json_for_html(page_data(content));
    std::array<Part, 3> parts{
        {{"/*ljmd:css*/", bundle.style}, {"/*ljmd:data*/", data}, {"/*ljmd:js*/", bundle.script}}};
    // All places are found before anything is put in: a title may look like one.
    for (Part& part : parts) {
        part.at = bundle.frame.find(part.place);
        if (part.at == std::string_view::npos) {
            throw ContractViolation(fmt::format("the frame of the report has no {}", part.place));
        }
    }
    std::ranges::sort(parts, {}, &Part::at);
    std::string page;
    std::size_t from = 0;
    for (const Part& part : parts) {
        page.append(bundle.frame.substr(from, part.at - from)).append(part.text);
        from = part.at + part.place.size();
    }
    return page.append(bundle.frame.substr(from));
}

}  // namespace ljmd
