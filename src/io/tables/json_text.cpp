#include "io/tables/json_text.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/number_text.hpp"
#include "io/tables/exact_json.hpp"

namespace ljmd {

namespace {

using Json = nlohmann::ordered_json;

Json library_value(const Data& data, bool signs_of_zeros) {
    struct Convert {
        bool signs_of_zeros;
        Json operator()(std::monostate) const { return nullptr; }
        Json operator()(bool flag) const { return flag; }
        Json operator()(std::int64_t integer) const { return integer; }
        Json operator()(std::uint64_t integer) const { return integer; }
        Json operator()(double number) const { return signs_of_zeros ? number : without_negative_zero(number); }
        Json operator()(const std::string& text) const { return text; }
        Json operator()(const Data::List& items) const {
            Json json = Json::array();
            for (const Data& item : items) {
                json.push_back(library_value(item, signs_of_zeros));
            }
            return json;
        }
        Json operator()(const Data::Object& members) const {
            Json json = Json::object();
            for (const auto& [key, value] : members) {
                json[key] = library_value(value, signs_of_zeros);
            }
            return json;
        }
    };
    return std::visit(Convert{signs_of_zeros}, data.value());
}

/// The message of a library error, without its error number.
std::string complaint_of(const nlohmann::json::exception& error) {
    const std::string_view text = error.what();
    const std::size_t end = text.find("] ");  // "[json.exception.parse_error.101] parse error at line 1, ..."
    return std::string(end == std::string_view::npos ? text : text.substr(end + 2));
}

/// Makes a value of what the library's parser reports, and checks its limits as it grows.
class DataBuilder : public nlohmann::json_sax<Json> {
  public:
    bool null() override { return add(nullptr); }
    bool boolean(bool flag) override { return add(flag); }
    bool number_integer(number_integer_t integer) override { return add(integer); }
    bool number_unsigned(number_unsigned_t integer) override { return add(integer); }
    bool number_float(number_float_t number, const string_t&) override { return add(number); }
    bool string(string_t& text) override { return add(std::move(text)); }
    bool binary(binary_t&) override { return false; }  // there is none in a text

    bool start_object(std::size_t) override { return open(Data::object()); }
    bool start_array(std::size_t) override { return open(Data::list()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& key) override {
        count();
        if (++keys_.at(open_.size()) > max_json_keys) {
            throw WrongData(fmt::format("an object has more than {} keys", max_json_keys));
        }
        key_ = std::move(key);
        return true;
    }

    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
        throw WrongData(complaint_of(error));
    }

    [[nodiscard]] Data result() && { return std::move(root_); }

  private:
    void count() {
        if (++values_ > max_json_values) {
            throw WrongData(fmt::format("it has more than {} values", max_json_values));
        }
    }

    bool add(Data value) {
        count();
        static_cast<void>(place(std::move(value)));
        return true;
    }

    bool open(Data value) {
        if (open_.size() >= deepest_json) {
            throw WrongData(fmt::format("it is nested deeper than {} levels", deepest_json));
        }
        count();
        open_.push_back(place(std::move(value)));
        keys_.at(open_.size()) = 0;
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    /// Put a value where it belongs. An open object or array does not move before it is closed.
    Data* place(Data value) {
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        Data& parent = *open_.back();
        if (parent.is_object()) {
            Data& member = parent[key_];
            member = std::move(value);
            return &member;
        }
        return &parent.push_back(std::move(value));
    }

    Data root_;
    std::vector<Data*> open_;                           ///< objects and arrays that are open, from the outermost one
    std::array<std::size_t, deepest_json + 1> keys_{};  ///< number of keys of the open object at each depth
    std::string key_;                                   ///< of the member that comes next
    std::size_t values_ = 0;
};

}  // namespace

std::string to_json(const Data& data) {
    return library_value(data, false).dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_exact_json(const Data& data) {
    return library_value(data, true).dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string to_json_line(const Data& data) {
    return library_value(data, false).dump(-1, ' ', true, Json::error_handler_t::replace);
}

Data parse_json(std::string_view text) {
    DataBuilder builder;
    Json::sax_parse(text, &builder);
    return std::move(builder).result();
}

}  // namespace ljmd
