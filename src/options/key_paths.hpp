#pragma once

#include <string>
#include <vector>

#include "ljmd/detail/options/schema.hpp"

namespace ljmd {

/// A key below a schema.
struct KeyPlace {
    std::string path;   ///< as `--set` takes it: "system.density"; in an array of tables "stage.NAME.steps" if the
                        ///< tables have names, otherwise "body.NUMBER.mass"
    std::string name;   ///< the last part
    std::string table;  ///< title of the table that holds it, "[system]"
    bool is_table;
};

/// All keys below a schema, its own first.
[[nodiscard]] std::vector<KeyPlace> key_places(const Schema& schema);

/// The keys of inner tables that have this name; empty if there are too many to be of help.
[[nodiscard]] std::vector<KeyPlace> inner_places(const Schema& schema, const std::string& name);

/// The name of a key of an inner table that is nearest to this one, see nearest_name().
[[nodiscard]] std::string nearest_inner_name(const Schema& schema, const std::string& name);

}  // namespace ljmd
