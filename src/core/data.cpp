#include "ljmd/detail/core/data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ljmd {

namespace {

/// For each alternative of Data::Value, in their order.
constexpr std::array<const char*, std::variant_size_v<Data::Value>> kinds{"null",   "boolean", "number", "number",
                                                                          "number", "string",  "array",  "object"};

}  // namespace

Data::Data() = default;
Data::Data(const Data&) = default;
Data::Data(Data&&) noexcept = default;
Data& Data::operator=(const Data&) = default;
Data& Data::operator=(Data&&) noexcept = default;
Data::~Data() = default;

Data::Data(std::nullptr_t) {}

Data::Data(double number) {
    if (std::isfinite(number)) {
        value_ = number;
    }
}

Data::Data(const char* text) : value_(std::in_place_type<std::string>, text) {}
Data::Data(std::string text) : value_(std::in_place_type<std::string>, std::move(text)) {}
Data::Data(std::string_view text) : value_(std::in_place_type<std::string>, text) {}
Data::Data(List items) : value_(std::in_place_type<List>, std::move(items)) {}

Data::Data(std::initializer_list<Member> members) : value_(std::in_place_type<Object>, members) {
    for (auto member = members.begin(); member != members.end(); ++member) {
        if (std::any_of(members.begin(), member, [&](const Member& other) { return other.key == member->key; })) {
            throw ContractViolation("an object has two members named '" + member->key + "'");
        }
    }
}

Data Data::object(std::initializer_list<Member> members) {
    return Data(members);
}

Data Data::of_flag(bool flag) {
    Data data;
    data.value_ = flag;
    return data;
}

Data Data::of_signed(std::int64_t integer) {
    Data data;
    data.value_ = integer;
    return data;
}

Data Data::of_unsigned(std::uint64_t integer) {
    if (integer <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
        return of_signed(static_cast<std::int64_t>(integer));
    }
    Data data;
    data.value_ = integer;
    return data;
}

Data Data::list(std::initializer_list<Data> items) {
    return Data(List(items));
}

bool Data::is_integer() const {
    return std::holds_alternative<std::int64_t>(value_) || std::holds_alternative<std::uint64_t>(value_);
}

bool Data::is_number() const {
    return is_integer() || std::holds_alternative<double>(value_);
}

bool Data::flag() const {
    if (const bool* flag = std::get_if<bool>(&value_)) {
        return *flag;
    }
    throw wrong_kind("boolean");
}

std::int64_t Data::integer() const {
    if (const auto* integer = std::get_if<std::int64_t>(&value_)) {
        return *integer;
    }
    throw is_integer() ? WrongData("it is too large an integer") : wrong_kind("integer");
}

double Data::number() const {
    if (const auto* integer = std::get_if<std::int64_t>(&value_)) {
        return static_cast<double>(*integer);
    }
    if (const auto* integer = std::get_if<std::uint64_t>(&value_)) {
        return static_cast<double>(*integer);
    }
    if (const auto* number = std::get_if<double>(&value_)) {
        return *number;
    }
    throw wrong_kind("number");
}

const std::string& Data::text() const {
    if (const auto* text = std::get_if<std::string>(&value_)) {
        return *text;
    }
    throw wrong_kind("string");
}

const Data::List& Data::items() const {
    if (const List* items = std::get_if<List>(&value_)) {
        return *items;
    }
    throw wrong_kind("array");
}

const Data::Object& Data::members() const {
    if (const Object* members = std::get_if<Object>(&value_)) {
        return *members;
    }
    throw wrong_kind("object");
}

std::size_t Data::size() const {
    return is_list() ? items().size() : is_object() ? members().size() : is_null() ? 0 : 1;
}

const Data* Data::find(std::string_view key) const {
    if (const Object* members = std::get_if<Object>(&value_)) {
        const auto found = std::find_if(members->begin(), members->end(), [&](const auto& m) { return m.key == key; });
        return found == members->end() ? nullptr : &found->value;
    }
    return nullptr;
}

const Data& Data::at(std::string_view key) const {
    static_cast<void>(members());
    if (const Data* found = find(key)) {
        return *found;
    }
    throw WrongData("key '" + std::string(key) + "' not found");
}

const Data& Data::at(std::size_t index) const {
    if (index >= items().size()) {
        throw WrongData("array index " + std::to_string(index) + " is out of range");
    }
    return items()[index];
}

Data& Data::operator[](std::string_view key) {
    if (is_null()) {
        value_.emplace<Object>();
    }
    auto* object = std::get_if<Object>(&value_);
    if (object == nullptr) {
        throw wrong_kind("object");
    }
    const auto found = std::find_if(object->begin(), object->end(), [&](const auto& m) { return m.key == key; });
    return found == object->end() ? object->emplace_back(Member{std::string(key), nullptr}).value : found->value;
}

Data& Data::push_back(Data item) {
    if (is_null()) {
        value_.emplace<List>();
    }
    auto* items = std::get_if<List>(&value_);
    if (items == nullptr) {
        throw wrong_kind("array");
    }
    return items->emplace_back(std::move(item));
}

void Data::update(const Data& other) {
    for (const auto& [key, value] : other.members()) {
        (*this)[key] = value;
    }
}

const char* Data::kind_name() const {
    return kinds.at(value_.index());
}

WrongData Data::wrong_kind(const char* wanted) const {
    return WrongData(std::string("type must be ") + wanted + ", but is " + kind_name());
}

bool operator==(const Data& a, const Data& b) {
    if (a.is_number() && b.is_number() && a.value_.index() != b.value_.index()) {
        return !(a.is_integer() && b.is_integer()) && a.number() == b.number();
    }
    if (a.is_object() && b.is_object()) {
        const Data::Object& members = a.members();
        return members.size() == b.members().size() &&
               std::all_of(members.begin(), members.end(), [&](const Member& member) {
                   const Data* other = b.find(member.key);
                   return other != nullptr && member.value == *other;
               });
    }
    return a.value_ == b.value_;
}

}  // namespace ljmd
