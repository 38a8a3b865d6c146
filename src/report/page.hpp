#pragma once

#include <string>
#include <string_view>

#include "report/page_content.hpp"

namespace ljmd {

// The page: one HTML file with style, script and data in it, which asks for nothing from anywhere.

/// What every page has in its head, and tells it from the files of others.
inline constexpr std::string_view page_mark = "<meta name=\"generator\" content=\"ljmd\">";

/// The files of src/report/web/dist that are built into the program.
struct PageBundle {
    std::string_view frame;   ///< index.html, with places for the other parts
    std::string_view style;   ///< report.css
    std::string_view script;  ///< report.js, shortened where the build was told to
};
[[nodiscard]] PageBundle page_bundle();

/// Data as JSON that can stand in a script element of HTML: ASCII, without "<".
[[nodiscard]] std::string json_for_html(const Data& data);

/// The whole page. @throws ContractViolation  the frame lacks a place for one of the parts
[[nodiscard]] std::string page_html(const PageContent& content, const PageBundle& bundle = page_bundle());

}  // namespace ljmd
