#include "ljmd/report/page.hpp"

// The assembler puts the files into the program as they are: as string literals they would take a compiler seconds, and
// clang refuses such long ones. LJMD_REPORT_BUNDLE is their folder (cmake/LjmdLibrary.cmake).

// NOLINTBEGIN(cppcoreguidelines-macro-usage): names of symbols, and a path
#define LJMD_EMBEDDED(symbol, file)                                      \
    __asm__(                                                             \
        ".pushsection .rodata\n"                                         \
        ".hidden ljmd_report_" symbol                                    \
        "\n"                                                             \
        ".global ljmd_report_" symbol                                    \
        "\n"                                                             \
        ".hidden ljmd_report_" symbol                                    \
        "_end\n"                                                         \
        ".global ljmd_report_" symbol                                    \
        "_end\n"                                                         \
        "ljmd_report_" symbol ": .incbin \"" LJMD_REPORT_BUNDLE "/" file \
        "\"\n"                                                           \
        "ljmd_report_" symbol                                            \
        "_end: .byte 0\n"                                                \
        ".popsection\n")
// NOLINTEND(cppcoreguidelines-macro-usage)

LJMD_EMBEDDED("frame", "index.html");
LJMD_EMBEDDED("style", "report.css");
LJMD_EMBEDDED("script", "report.js");

// NOLINTBEGIN(*-avoid-c-arrays): of unknown length, from the assembler
extern "C" {
extern const char ljmd_report_frame[];
extern const char ljmd_report_frame_end[];
extern const char ljmd_report_style[];
extern const char ljmd_report_style_end[];
extern const char ljmd_report_script[];
extern const char ljmd_report_script_end[];
}
// NOLINTEND(*-avoid-c-arrays)

namespace ljmd {

PageBundle page_bundle() {
    return {{ljmd_report_frame, ljmd_report_frame_end},
            {ljmd_report_style, ljmd_report_style_end},
            {ljmd_report_script, ljmd_report_script_end}};
}

}  // namespace ljmd
