#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace ljmd::test {

/// A variable of the environment as given until the end of the scope.
class EnvironmentGuard {
  public:
    EnvironmentGuard(std::string variable, const std::string& value) : variable_(std::move(variable)) {
        if (const char* before = std::getenv(variable_.c_str())) {
            before_ = before;
        }
        setenv(variable_.c_str(), value.c_str(), 1);
    }
    ~EnvironmentGuard() {
        if (before_) {
            setenv(variable_.c_str(), before_->c_str(), 1);
        } else {
            unsetenv(variable_.c_str());
        }
    }
    EnvironmentGuard(const EnvironmentGuard&) = delete;
    EnvironmentGuard& operator=(const EnvironmentGuard&) = delete;

  private:
    std::string variable_;
    std::optional<std::string> before_;
};

}  // namespace ljmd::test
