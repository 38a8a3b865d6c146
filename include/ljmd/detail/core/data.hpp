#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "ljmd/core/errors.hpp"

namespace ljmd {

/// A value read from a file is not what it should be. The reader of the file adds its path.
class WrongData : public DataError {
  public:
    using DataError::DataError;
};

struct Member;

/// A value of a result or a record: null, flag, integer, number, text, list of values, or object, whose members keep
/// the order in which they were added. io/tables/json_text.hpp writes it as JSON and reads it.
///
/// A number that is not finite, and an empty optional, are null: JSON cannot represent them.
///
/// Braces hold the members of an object, each with its key; a list needs Data::list():
///
///     const Data json = {{"atoms", 864}, {"box", {{"edges", Data::list({lx, ly, lz})}}}, {"warnings", warnings}};
class Data {
  public:
    using List = std::vector<Data>;
    using Object = std::vector<Member>;
    /// An integer is unsigned only if it does not fit otherwise.
    using Value = std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, List, Object>;

    // NOLINTBEGIN(*-explicit-*): members of an object are written as plain values
    Data();  ///< null
    Data(std::nullptr_t);
    Data(double number);
    Data(const char* text);
    Data(std::string text);
    Data(std::string_view text);
    Data(List items);
    Data(std::initializer_list<Member> members);  ///< an object, as object()

    template <class Flag, std::enable_if_t<std::is_same_v<Flag, bool>, int> = 0>  // a pointer is no flag
    Data(Flag value) : Data(of_flag(value)) {}

    template <class Integer, std::enable_if_t<std::is_integral_v<Integer> && !std::is_same_v<Integer, bool>, int> = 0>
    Data(Integer value) : Data(of_integer(value)) {}

    template <class T>
    Data(const std::optional<T>& value) : Data(value ? Data(*value) : Data()) {}

    template <class T>
    Data(const std::vector<T>& items) : Data(List(items.begin(), items.end())) {}
    // NOLINTEND(*-explicit-*)

    Data(const Data&);
    Data(Data&&) noexcept;
    Data& operator=(const Data&);
    Data& operator=(Data&&) noexcept;
    ~Data();

    /// An object. @throws ContractViolation  two members have the same key
    [[nodiscard]] static Data object(std::initializer_list<Member> members = {});
    [[nodiscard]] static Data list(std::initializer_list<Data> items = {});

    [[nodiscard]] bool is_null() const { return std::holds_alternative<std::monostate>(value_); }
    [[nodiscard]] bool is_integer() const;  ///< also of more than 63 bits
    [[nodiscard]] bool is_number() const;   ///< also an integer
    [[nodiscard]] bool is_text() const { return std::holds_alternative<std::string>(value_); }
    [[nodiscard]] bool is_list() const { return std::holds_alternative<List>(value_); }
    [[nodiscard]] bool is_object() const { return std::holds_alternative<Object>(value_); }

    // The value, if it is of the right kind. @throws WrongData otherwise, with both kinds

    [[nodiscard]] bool flag() const;
    [[nodiscard]] std::int64_t integer() const;  ///< @throws WrongData also if it has more than 63 bits
    [[nodiscard]] double number() const;         ///< also of an integer
    [[nodiscard]] const std::string& text() const;
    [[nodiscard]] const List& items() const;
    [[nodiscard]] const Object& members() const;

    /// Number of items or members; 0 of a null, 1 of any other value.
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] bool empty() const { return size() == 0; }

    /// The member with this key; nullptr if there is none, or if this is no object. Takes a time linear in the members.
    [[nodiscard]] const Data* find(std::string_view key) const;
    [[nodiscard]] bool contains(std::string_view key) const { return find(key) != nullptr; }

    /// @throws WrongData  there is no such member or item, or this is no object or list
    [[nodiscard]] const Data& at(std::string_view key) const;
    [[nodiscard]] const Data& at(std::size_t index) const;
    [[nodiscard]] const Data& operator[](std::string_view key) const { return at(key); }
    [[nodiscard]] const Data& operator[](std::size_t index) const { return at(index); }

    /// The member with this key, which is added as null where there is none. A null becomes an object.
    /// @throws WrongData  this is neither
    Data& operator[](std::string_view key);

    /// Add an item, and return it. A null becomes a list. @throws WrongData  this is neither
    Data& push_back(Data item);

    /// Set the members of another object in this one, each as by operator[]. @throws WrongData  one of them is no
    /// object
    void update(const Data& other);

    /// What this is, for code that has a case for each kind.
    [[nodiscard]] const Value& value() const { return value_; }

    /// "number", "string": its kind in the words of JSON.
    [[nodiscard]] const char* kind_name() const;

    /// Integers are compared with numbers by value, members in any order.
    friend bool operator==(const Data& a, const Data& b);

  private:
    // The variant is made where Member is complete.
    [[nodiscard]] static Data of_flag(bool flag);
    [[nodiscard]] static Data of_signed(std::int64_t integer);
    [[nodiscard]] static Data of_unsigned(std::uint64_t integer);

    template <class Integer>
    [[nodiscard]] static Data of_integer(Integer integer) {
        if constexpr (std::is_unsigned_v<Integer>) {
            return of_unsigned(integer);
        } else {
            return of_signed(integer);
        }
    }

    [[nodiscard]] WrongData wrong_kind(const char* wanted) const;

    Value value_;
};

/// A member of an object.
struct Member {
    std::string key;
    Data value;

    friend bool operator==(const Member& a, const Member& b) { return a.key == b.key && a.value == b.value; }
};

}  // namespace ljmd
