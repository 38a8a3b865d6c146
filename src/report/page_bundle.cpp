#include <string>

#include "report/page.hpp"
#include "report/page_arrays.hpp"

namespace ljmd {

namespace {

/// The text in words of eight bytes, the first byte lowest.
template <class Words>
std::string text_of(const Words& words, std::size_t size) {
    constexpr std::size_t bytes = 8;
    std::string text(size, '\0');
    for (std::size_t k = 0; k < size; ++k) {
        text[k] = static_cast<char>(words[k / bytes] >> (8 * (k % bytes)) & 0xffU);
    }
    return text;
}

}  // namespace

PageBundle page_bundle() {
    static const std::string frame = text_of(page_frame, page_frame_size);
    static const std::string style = text_of(page_style, page_style_size);
    static const std::string script = text_of(page_script, page_script_size);
    return {frame, style, script};
}

}  // namespace ljmd
