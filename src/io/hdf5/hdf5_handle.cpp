#include "io/hdf5/hdf5_handle.hpp"

#include <string_view>

#include "io/hdf5/hdf5_exit.hpp"

namespace ljmd {

namespace {

/// HDF5 puts the system's message between these, within a longer line.
constexpr std::string_view before = "error message = '";
constexpr std::string_view after = "'";

herr_t keep_first_cause(unsigned, const H5E_error2_t* error, void* data) {
    auto& text = *static_cast<std::string*>(data);
    const std::string_view description = error->desc;
    const std::size_t begin = description.find(before);
    if (begin != std::string_view::npos) {
        const std::string_view message = description.substr(begin + before.size());
        text = message.substr(0, message.find(after));
        return 1;  // the most specific message: stop here
    }
    if (text.empty()) {
        text = description;
    }
    return 0;
}

}  // namespace

void leave_hdf5_files_at_exit() {
    H5dont_atexit();
}

std::string hdf5_error_text() {
    std::string text;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first_cause, &text);
    return text.empty() ? "unknown HDF5 error" : text;
}

}  // namespace ljmd
