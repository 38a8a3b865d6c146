#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/options/schema.hpp"
#include "ljmd/options/settings.hpp"

namespace ljmd {

/// The keys of an options object, each with the member that holds its value. An object describes itself once:
///
///     struct Options {
///         double time = 1.0;
///         void describe(Description& d) {
///             d.number("time", time).dimension(Dimension::time).unit("tau").above(0.0).meaning("relaxation time");
///         }
///     };
///
/// The value that a member holds then is the default of its key. A member of type std::optional is a key that may be
/// missing; a member described by required_...() is a key that must be given. Schemas, the reference page and the JSON
/// Schema come from keys(); take() sets values.
///
/// Each function returns the key, so that range, unit and meaning can be added (see Key); it is valid until the next
/// call. The members must live as long as the description.
class Description {
  public:
    /// A member that take() does not set.
    struct Other {
        const void* address;
        const Other& operator*() const { return *this; }
    };

    Key& flag(const std::string& name, bool& member);
    Key& flag(const std::string& name, std::optional<bool>& member);
    Key& integer(const std::string& name, Index& member);
    Key& integer(const std::string& name, std::optional<Index>& member);
    Key& number(const std::string& name, double& member);
    Key& number(const std::string& name, std::optional<double>& member);
    Key& text(const std::string& name, std::string& member);
    Key& text(const std::string& name, std::optional<std::string>& member);
    Key& choice(const std::string& name, const std::vector<std::string>& choices, std::string& member);
    Key& choice(const std::string& name, const std::vector<std::string>& choices, std::optional<std::string>& member);
    Key& interval(const std::string& name, Interval& member);

    Key& required_integer(const std::string& name, Index& member);
    Key& required_number(const std::string& name, double& member);
    Key& required_text(const std::string& name, std::string& member);
    Key& required_choice(const std::string& name, const std::vector<std::string>& choices, std::string& member);
    Key& required_vector(const std::string& name, std::vector<double>& member);
    Key& required_quantity(const std::string& name, Dimension dimension, double& member);  ///< in SI

    /// A key that was described elsewhere.
    Key& bind(const Key& key, double& member);

    [[nodiscard]] std::vector<Key> keys() const;

    /// The name of the key that is bound to a member, or nullptr.
    [[nodiscard]] const std::string* key_of(const void* member) const;

    /// Give the member of a key a value. @throws ContractViolation when there is no such key, or it holds another type
    void take(const std::string& key, const PlainValue& value);

    /// The values of the members by their keys, without absent ones, as a deck writes them: quantities with their
    /// units.
    [[nodiscard]] Settings values() const;

  protected:
    using Member =
        std::variant<bool*, Index*, double*, std::string*, std::vector<double>*, Interval*, std::optional<bool>*,
                     std::optional<Index>*, std::optional<double>*, std::optional<std::string>*, Other>;
    Key& add(const Key& key, Member member);

  private:
    struct Item {
        Key key;
        Member member;
    };

    std::vector<Item> items_;
};

/// The keys of a plug-in: of the options that its `options()` makes.
template <class Plugin>
[[nodiscard]] std::vector<Key> keys_of(const Plugin& plugin) {
    const auto options = plugin.options();
    Description description;
    options->describe(description);
    return description.keys();
}

/// A plug-in with its options: what a Choice stands for.
template <class Plugin, class Options>
struct Chosen {
    Plugin plugin;
    std::shared_ptr<const Options> options;
    Settings values;  ///< of the options
};

/// @param set_values  called with the description, to give options their values
template <class Plugin, class SetValues>
[[nodiscard]] auto choose(const Plugin& plugin, const SetValues& set_values) {
    auto options = plugin.options();
    using Options = typename decltype(options)::element_type;
    Description description;
    options->describe(description);
    set_values(description);
    Settings values = description.values();
    return Chosen<Plugin, Options>{plugin, std::shared_ptr<const Options>(std::move(options)), std::move(values)};
}

/// With all options at their defaults. See section.hpp for options from a deck.
template <class Plugin>
[[nodiscard]] auto choose(const Plugin& plugin) {
    return choose(plugin, [](Description&) {});
}

}  // namespace ljmd
