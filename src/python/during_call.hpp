#pragma once

#include <memory>

#include "ljmd/core/errors.hpp"

namespace ljmd::python {

/// A reference to a value of the engine, valid during one call of a user's function. Python may keep it after the call;
/// then every access raises an error.
template <class Value>
class Passing {
  public:
    explicit Passing(const Value& value) : value_(&value) {}

    void end() { value_ = nullptr; }

    /// @throws InputError after the call
    [[nodiscard]] const Value& now() const {
        if (value_ == nullptr) {
            throw InputError("the call that this belonged to has ended: keep copies of its arrays and numbers");
        }
        return *value_;
    }

  private:
    const Value* value_;
};

/// Guard for one call: ends the reference when the call returns or throws.
template <class Value>
class DuringCall {
  public:
    explicit DuringCall(const Value& value) : seen_(std::make_shared<Passing<Value>>(value)) {}
    ~DuringCall() { seen_->end(); }
    DuringCall(const DuringCall&) = delete;
    DuringCall& operator=(const DuringCall&) = delete;

    [[nodiscard]] const std::shared_ptr<Passing<Value>>& seen() const { return seen_; }

  private:
    std::shared_ptr<Passing<Value>> seen_;
};

}  // namespace ljmd::python
