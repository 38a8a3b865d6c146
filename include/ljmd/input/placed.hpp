#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/input/table_description.hpp"

namespace ljmd {

/// Options at their defaults with their description, from which schemas and the names of keys come. One for each type.
template <class Options>
struct Described {
    Options options;
    TableDescription description;

    Described() { options.describe(description); }
    Described(const Described&) = delete;
    Described& operator=(const Described&) = delete;
    ~Described() = default;

    static const Described& get() {
        static const Described described;
        return described;
    }
};

/// The options that a table of a deck holds, and where they are written. Places are asked by member:
///
///     Placed<SystemTable> system = ...;
///     if (system.seed < 0) diagnostics.error(system.location(&SystemTable::seed), "...");
///
/// Every member whose key is in the table or has a default has its value, in range and in reduced units; a value that
/// was found wrong has a stand-in.
template <class Options>
class Placed : public Options {
  public:
    Placed() = default;

    /// @param section  validated by schema()
    explicit Placed(Section section) : section_(std::move(section)) {
        TableDescription description;
        this->describe(description);
        description.read(section_);
    }

    [[nodiscard]] static Schema schema(const std::string& title) {
        return Described<Options>::get().description.schema(title);
    }

    /// The key of a member, as decks write it.
    template <class Member, class Owner>
    [[nodiscard]] static const std::string& key(Member Owner::*member) {
        const auto& described = Described<Options>::get();
        return described.description.key_of(&(described.options.*member));
    }

    /// See the functions of Section with these names.
    template <class Member, class Owner>
    [[nodiscard]] bool has(Member Owner::*member) const {
        return section_.has(key(member));
    }
    template <class Member, class Owner>
    [[nodiscard]] bool sound(Member Owner::*member) const {
        return section_.sound(key(member));
    }
    template <class Member, class Owner>
    [[nodiscard]] bool written(Member Owner::*member) const {
        return section_.written(key(member));
    }
    template <class Member, class Owner>
    [[nodiscard]] Location location(Member Owner::*member) const {
        return section_.location(key(member));
    }
    [[nodiscard]] const Location& location() const { return section_.location(); }
    [[nodiscard]] const std::string& heading() const { return section_.title(); }
    /// The table with its keys, for those that only others name: options of plug-ins, mistakes of the engine.
    [[nodiscard]] const Section& section() const { return section_; }

    /// Whether the key has a valid value.
    template <class Member, class Owner>
    [[nodiscard]] bool given(Member Owner::*member) const {
        return has(member) && sound(member);
    }
    /// Whether the key was left out, not merely misspelt.
    template <class Member, class Owner>
    [[nodiscard]] bool absent(Member Owner::*member) const {
        return !has(member) && sound(member);
    }

  private:
    Section section_;
};

template <class Options>
Key& TableDescription::table(const std::string& name, const std::string& title, Placed<Options>& member) {
    const auto read = [name, title, &member](const Section& section) {
        Diagnostics none;  // an empty table has its defaults
        member = Placed<Options>(section.has(name) ? section.section(name)
                                                   : validate({}, section.location(name),
                                                              Placed<Options>::schema(title), std::nullopt, none));
    };
    return add_other(Key::table(name, Placed<Options>::schema(title)), &member, read);
}

template <class Options>
Key& TableDescription::table(const std::string& name, const std::string& title,
                             std::optional<Placed<Options>>& member) {
    const auto read = [name, &member](const Section& section) {
        if (section.has(name)) {
            member.emplace(section.section(name));
        }
    };
    return add_other(Key::table(name, Placed<Options>::schema(title)).optional(), &member, read);
}

template <class Options>
Key& TableDescription::tables(const std::string& name, const std::string& title, std::vector<Placed<Options>>& member) {
    const auto read = [name, &member](const Section& section) {
        for (const Section& inner : section.sections(name)) {
            member.emplace_back(inner);
        }
    };
    return add_other(Key::tables(name, Placed<Options>::schema(title)), &member, read);
}

template <class Plugin, class Options>
Key& TableDescription::plugin(const std::string& name, const std::vector<Plugin>& plugins,
                              Chosen<Plugin, Options>& member) {
    Key key = Key::choice(name, plugin_names(plugins));
    if (!member.plugin.name.empty()) {
        key.defaults_to(member.plugin.name);
    }
    for (const Plugin& plugin : plugins) {
        selection(name).cases[plugin.name] = keys_of(plugin);
    }
    return add_other(key, &member, [name, plugins, &member](const Section& section) {
        member = choose(find_plugin(plugins, std::get<std::string>(section.plain(name)), name), section);
    });
}

template <class Plugin, class Options>
void TableDescription::choices(const std::vector<Plugin>& plugins, const std::string& absent,
                               std::vector<PlacedChoice<Plugin, Options>>& member) {
    for (const Plugin& plugin : plugins) {
        const auto read = [plugin, &member](const Section& section) {
            if (section.has(plugin.name)) {
                const Section& own = section.section(plugin.name);
                member.push_back({choose(plugin, own), own});
            }
        };
        add_other(
            Key::table(plugin.name, Schema(plugin.name, keys_of(plugin))).optional(absent).meaning(plugin.meaning),
            nullptr, read);
    }
}

}  // namespace ljmd
