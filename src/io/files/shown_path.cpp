#include "io/files/shown_path.hpp"

namespace ljmd {

std::string shown_as(std::string message, const std::filesystem::path& path, const std::string& name) {
    const std::string& found = path.native();
    for (std::size_t at = message.find(found); at != std::string::npos; at = message.find(found, at + name.size())) {
        message.replace(at, found.size(), name);
    }
    return message;
}

}  // namespace ljmd
