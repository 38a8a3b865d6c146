#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/detail/options/registry.hpp"
#include "ljmd/detail/options/section.hpp"
#include "ljmd/options/choice.hpp"

namespace ljmd {

template <class Options>
class Placed;

/// The key that names the plug-in in a table of its own: thermostat = { type = "langevin" }.
inline constexpr const char* plugin_key = "type";

/// The keys of a table of a deck: beside what options have (see Description) also inner tables, plug-ins chosen by
/// name, and keys that exist for one choice only.
class TableDescription : public Description {
  public:
    /// An inner table. One whose key is made optional has all its defaults when it is absent.
    /// @param title  for messages: "[system]", "lattice"
    template <class Options>
    Key& table(const std::string& name, const std::string& title, Placed<Options>& member);

    /// An inner table that may be absent.
    template <class Options>
    Key& table(const std::string& name, const std::string& title, std::optional<Placed<Options>>& member);

    /// An array of tables, which must be given.
    template <class Options>
    Key& tables(const std::string& name, const std::string& title, std::vector<Placed<Options>>& member);

    /// An inner table that may be absent, for members that hold what it says in another form.
    /// @param member  whose key this is
    /// @param take    gives the members their values
    /// @param give    the table that they make, or nothing
    template <class Options>
    Key& table_for(const std::string& name, const void* member, const std::function<void(const Options&)>& take,
                   const std::function<std::optional<Options>()>& give);

    /// The choice of a plug-in by its name. Its options are keys of the same table. The plug-in that the member holds
    /// is the default; if it holds none, the key must be given.
    template <class Plugin>
    Key& plugin(const std::string& name, const std::vector<Plugin>& plugins, Choice& member);

    /// The choice of a plug-in by `type` in a table of its own, which may be absent. An unknown one is left out.
    template <class Plugin>
    Key& plugin_table(const std::string& name, const std::vector<Plugin>& plugins, std::optional<Choice>& member);

    /// A table for each plug-in, with its options; those that are present are chosen, in the order of the plug-ins.
    /// @param absent  what it means that a plug-in has no table
    template <class Plugin>
    void choices(const std::vector<Plugin>& plugins, const std::string& absent, std::vector<Choice>& member);

    /// Keys that exist for one choice of another key only.
    void when(const std::string& selector, const std::string& choice, const Description& keys);

    [[nodiscard]] Schema schema(const std::string& title) const;

    /// The name of the key that is bound to a member. @throws ContractViolation if there is none
    [[nodiscard]] const std::string& key_of(const void* member) const;

    /// Give all members their values. A value that was found wrong has a stand-in, see validate().
    /// @param section  validated by schema()
    void read(const Section& section);

    /// What read() would give all members their present values from. Of values that are left out for their defaults
    /// only those are missing that no value stands for, such as an optional member that is empty.
    [[nodiscard]] Table written() const;

  private:
    using Reader = std::function<void(const Section&)>;
    using Writer = std::function<void(Table&)>;  ///< appends what the member makes
    Key& add_other(const Key& key, const void* member, Reader reader, Writer writer);
    Schema::Selection& selection(const std::string& selector);

    struct Case {
        std::string selector;
        std::string choice;
        Description keys;
    };

    struct Other {
        std::string key;
        Reader read;
        Writer write;
    };

    std::vector<Other> others_;
    std::vector<Case> cases_;
    std::vector<Schema::Selection> selections_;
};

/// "rescale: scale all velocities; langevin: friction and noise": the names of plug-ins with their meanings.
/// @param what  the member that is told of each
template <class Plugin>
[[nodiscard]] std::string meanings_of(const std::vector<Plugin>& plugins,
                                      std::string Plugin::*what = &Plugin::meaning) {
    std::string text;
    for (const Plugin& plugin : plugins) {
        text += (text.empty() ? "" : "; ") + plugin.name + ": " + plugin.*what;
    }
    return text;
}

}  // namespace ljmd
