#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/detail/options/table_description.hpp"
#include "ljmd/options/choice.hpp"

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
    /// The table of a key that is there.
    template <class Member, class Owner>
    [[nodiscard]] const Section& inner(Member Owner::*member) const {
        return section_.section(key(member));
    }

    /// Whether all values in the table of a key are valid; true if it is absent.
    template <class Member, class Owner>
    [[nodiscard]] bool all_sound_in(Member Owner::*member) const {
        return absent(member) || (given(member) && inner(member).all_sound());
    }

    /// Place of the name of a plug-in that is chosen in a table of its own, see TableDescription::plugin_table().
    template <class Owner>
    [[nodiscard]] Location location_of_type(std::optional<Choice> Owner::*member) const {
        return inner(member).location(plugin_key);
    }
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

/// The table that options make.
template <class Options>
[[nodiscard]] Table table_of(const Options& options) {
    Options copy = options;
    TableDescription description;
    copy.describe(description);
    return description.written();
}

template <class Options>
Key& TableDescription::table(const std::string& name, const std::string& title, Placed<Options>& member) {
    const auto read = [name, title, &member](const Section& section) {
        Diagnostics none;  // an empty table has its defaults
        member = Placed<Options>(section.has(name) ? section.section(name)
                                                   : validate({}, section.location(name),
                                                              Placed<Options>::schema(title), std::nullopt, none));
    };
    const auto write = [name, &member](Table& table) {
        table.push_back(entry_of(name, table_of(static_cast<const Options&>(member))));
    };
    return add_other(Key::table(name, Placed<Options>::schema(title)), &member, read, write);
}

template <class Options>
Key& TableDescription::table(const std::string& name, const std::string& title,
                             std::optional<Placed<Options>>& member) {
    const auto read = [name, &member](const Section& section) {
        if (section.has(name)) {
            member.emplace(section.section(name));
        }
    };
    const auto write = [name, &member](Table& table) {
        if (member) {
            table.push_back(entry_of(name, table_of(static_cast<const Options&>(*member))));
        }
    };
    return add_other(Key::table(name, Placed<Options>::schema(title)).optional(), &member, read, write);
}

template <class Options>
Key& TableDescription::tables(const std::string& name, const std::string& title, std::vector<Placed<Options>>& member) {
    const auto read = [name, &member](const Section& section) {
        for (const Section& inner : section.sections(name)) {
            member.emplace_back(inner);
        }
    };
    const auto write = [name, &member](Table& table) {
        Array all;
        for (const Placed<Options>& one : member) {
            all.push_back({table_of(static_cast<const Options&>(one)), {}});
        }
        table.push_back(entry_of(name, std::move(all)));
    };
    return add_other(Key::tables(name, Placed<Options>::schema(title)), &member, read, write);
}

template <class Options>
Key& TableDescription::table_for(const std::string& name, const void* member,
                                 const std::function<void(const Options&)>& take,
                                 const std::function<std::optional<Options>()>& give) {
    const auto read = [name, take](const Section& section) {
        if (section.has(name) && section.sound(name)) {
            take(Placed<Options>(section.section(name)));
        }
    };
    const auto write = [name, give](Table& table) {
        if (const std::optional<Options> options = give()) {
            table.push_back(entry_of(name, table_of(*options)));
        }
    };
    return add_other(Key::table(name, Placed<Options>::schema(name)).optional(), member, read, write);
}

template <class Plugin>
Key& TableDescription::plugin(const std::string& name, const std::vector<Plugin>& plugins, Choice& member) {
    Key key = Key::choice(name, plugin_names(plugins));
    if (!member.name.empty()) {
        key.defaults_to(member.name);
    }
    for (const Plugin& plugin : plugins) {
        selection(name).cases[plugin.name] = keys_of(plugin);
    }
    const auto read = [name, plugins, &member](const Section& section) {
        member = choice_of(choose(find_plugin(plugins, std::get<std::string>(section.plain(name)), name), section));
    };
    const auto write = [name, &member](Table& table) {
        table.push_back(entry_of(name, member.name));
        append(member.settings, table);
    };
    return add_other(key, &member, read, write);
}

template <class Plugin>
Key& TableDescription::plugin_table(const std::string& name, const std::vector<Plugin>& plugins,
                                    std::optional<Choice>& member) {
    Choice none;
    TableDescription inner;
    inner.plugin(plugin_key, plugins, none).meaning(meanings_of(plugins));
    const auto read = [name, plugins, &member](const Section& section) {
        if (section.has(name) && section.sound(name) && section.section(name).sound(plugin_key)) {
            TableDescription own;
            own.plugin(plugin_key, plugins, member.emplace());
            own.read(section.section(name));
        }
    };
    const auto write = [name, &member](Table& table) {
        if (member) {
            Table own{entry_of(plugin_key, member->name)};
            append(member->settings, own);
            table.push_back(entry_of(name, std::move(own)));
        }
    };
    return add_other(Key::table(name, inner.schema(name)).optional(), &member, read, write);
}

template <class Plugin>
void TableDescription::choices(const std::vector<Plugin>& plugins, const std::string& absent,
                               std::vector<Choice>& member) {
    for (const Plugin& plugin : plugins) {
        const auto read = [plugin, &member](const Section& section) {
            if (section.has(plugin.name)) {
                member.push_back(choice_of(choose(plugin, section.section(plugin.name))));
            }
        };
        const auto write = [name = plugin.name, &member](Table& table) {
            for (const Choice& choice : member) {
                if (choice.name == name) {
                    Table own;
                    append(choice.settings, own);
                    table.push_back(entry_of(name, std::move(own)));
                }
            }
        };
        add_other(
            Key::table(plugin.name, Schema(plugin.name, keys_of(plugin))).optional(absent).meaning(plugin.meaning),
            nullptr, read, write);
    }
}

}  // namespace ljmd
