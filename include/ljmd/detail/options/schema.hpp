#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/options/units.hpp"
#include "ljmd/detail/options/value.hpp"

namespace ljmd {

class Schema;

/// Kind of value that a key takes.
enum class Kind {
    flag,      ///< true or false
    integer,   ///< 64-bit integer
    number,    ///< float or integer; with a dimension and [argon] also a string with a unit, "119.8 K"
    text,      ///< any string
    choice,    ///< one of the strings in `choices`
    quantity,  ///< always a string with a unit: the keys of [argon]
    interval,  ///< an integer (steps) or a string (wall time), "5 min"
    vector,    ///< an array of numbers; the range applies to each of them
    table,     ///< a table with its own schema
    tables,    ///< an array of tables, [[stage]]
};

/// How often something happens, in steps or in wall time; one of the two is set.
struct Interval {
    std::optional<std::int64_t> steps = {};
    std::optional<double> seconds = {};  ///< wall time
};

/// Value of a non-table key, as a default or after validation.
using PlainValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

/// A key of a deck: what its validation and its line on the reference page need.
/// Built fluently: `Key::number("density").unit("sigma^-3").above(0.0).at_most(1.5).meaning("N/V")`.
class Key {
  public:
    static Key flag(std::string name);
    static Key integer(std::string name);
    static Key number(std::string name);
    static Key text(std::string name);
    static Key choice(std::string name, std::vector<std::string> choices);
    static Key quantity(std::string name, Dimension dimension);
    static Key interval(std::string name);
    static Key vector(std::string name);
    static Key table(std::string name, Schema schema);
    static Key tables(std::string name, Schema schema);

    Key& meaning(std::string text);
    Key& unit(std::string reduced_unit);          ///< shown on the reference page, e.g. "sigma"
    Key& dimension(Dimension dimension);          ///< accepts unit strings of this dimension
    Key& at_least(double low);                    ///< value >= low
    Key& above(double low);                       ///< value > low
    Key& at_most(double high);                    ///< value <= high
    Key& below(double high);                      ///< value < high
    Key& components(Index least, Index most);     ///< allowed number of components of a Kind::vector
    Key& optional(std::string when_absent = {});  ///< may be absent; the text says what happens then
    Key& defaults_to(PlainValue value);           ///< implies optional
    Key& step_interval();                         ///< an integer: something happens every so many steps of a run

    std::string name;
    Kind kind = Kind::text;
    std::string meaning_text;
    std::string reduced_unit;
    Dimension physical_dimension = Dimension::none;
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false;   ///< `low` itself is not allowed
    bool high_open = false;  ///< `high` itself is not allowed
    Index min_components = 1;
    Index max_components = 3;
    std::vector<std::string> choices;
    bool is_step_interval = false;
    bool required = true;
    std::string absent_text;  ///< for optional keys without a default
    std::optional<PlainValue> default_value;
    std::vector<Schema> inner;  ///< one element for Kind::table and Kind::tables, otherwise empty

    /// The type in words, without an article: "integer", "array of tables", "array of 1 to 3 numbers".
    [[nodiscard]] std::string type() const;

    /// Allowed number of components of a vector in words: "1 to 3"; "2" if only one number is allowed.
    [[nodiscard]] std::string allowed_components() const;

    /// Allowed range in words: "> 0, <= 1.5"; "each > 0"; "one of 'cut', 'shifted'"; empty if everything is allowed.
    [[nodiscard]] std::string allowed() const;

  private:
    Key(std::string name, Kind kind);
};

/// The keys of one table of a deck.
class Schema {
  public:
    /// @param title  name of the table in messages: "[system]", "[[stage]]", "lattice"
    explicit Schema(std::string title, const std::vector<Key>& keys = {});

    /// This schema extended by more keys. @throws ContractViolation if a name occurs twice
    [[nodiscard]] Schema with(const std::vector<Key>& more) const;

    /// Add keys that exist only for one choice of another key, such as the options of a plug-in that is selected by
    /// name.
    /// @param key    a Kind::choice of this schema
    /// @param cases  the additional keys for each choice
    Schema& select(const std::string& key, std::map<std::string, std::vector<Key>> cases);

    /// The additional keys for each choice of a key.
    struct Selection {
        std::string key;
        std::map<std::string, std::vector<Key>> cases;
    };
    [[nodiscard]] const std::vector<Selection>& selections() const { return selections_; }

    /// This schema extended by the keys for the choices made in `table`. An unknown choice adds none.
    [[nodiscard]] Schema resolved_for(const Table& table) const;

    [[nodiscard]] const Key* find(const std::string& name) const;
    [[nodiscard]] const std::vector<Key>& keys() const { return keys_; }
    [[nodiscard]] const std::string& title() const { return title_; }

  private:
    std::string title_;
    std::vector<Key> keys_;
    std::vector<Selection> selections_;
};

}  // namespace ljmd
