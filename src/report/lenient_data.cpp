#include "report/lenient_data.hpp"

#include "io/tables/json_file.hpp"

namespace ljmd {

const Data* value_in(const Data& data, DataPath path) {
    const Data* found = &data;
    for (const std::string_view key : path) {
        found = found->find(key);
        if (found == nullptr) {
            return nullptr;
        }
    }
    return found;
}

std::optional<double> number_in(const Data& data, DataPath path) {
    const Data* found = value_in(data, path);
    return found != nullptr && found->is_number() ? std::optional(found->number()) : std::nullopt;
}

std::string text_in(const Data& data, DataPath path) {
    const Data* found = value_in(data, path);
    if (found == nullptr || found->is_null()) {
        return "";
    }
    return found->is_text() ? found->text() : to_json_line(*found);
}

std::optional<bool> flag_in(const Data& data, DataPath path) {
    const Data* found = value_in(data, path);
    const bool* flag = found == nullptr ? nullptr : std::get_if<bool>(&found->value());
    return flag == nullptr ? std::nullopt : std::optional(*flag);
}

Data read_any_json(const std::filesystem::path& path) {
    return read_json(path, "a JSON file of ljmd", [](const Data& data) { return data; });
}

}  // namespace ljmd
