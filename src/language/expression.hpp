// Numbers written as `{expression}`: arithmetic with the variables `frame` and `t`, evaluated by muParser.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "language/scene_file.hpp"

namespace penumbra {

// What is wrong with an expression, and at which part of its text.
struct ExpressionError {
  std::string_view part;
  std::string sentence;
  std::string hint;  // may be empty
};

class Expressions {
 public:
  // The variables have the values of this moment.
  explicit Expressions(const Moment& moment) : moment_(moment) {}

  // Evaluates the text between the braces. The value may be infinite or not a number.
  std::optional<ExpressionError> evaluate(std::string_view text, double& value);

 private:
  Moment moment_;
  std::shared_ptr<void> parser_;  // muParser's handle, made for the first expression
};

// "`sin`, `cos`, ...": the functions that expressions know, for the reference page.
std::string functions_of_expressions();

}  // namespace penumbra
