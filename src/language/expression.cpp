// The text is first cut into its parts here: only known numbers, names and operators reach muParser, and an error in
// one of them is reported at its place.
#include "language/expression.hpp"

#include <fmt/format.h>
#include <muParserDef.h>
#include <muParserError.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "language/diagnostic_list.hpp"
#include "language/mu_parser_library.hpp"
#include "language/near_word.hpp"
#include "language/number.hpp"
#include "language/text_lines.hpp"

namespace penumbra {
namespace {

constexpr std::size_t longest_expression = 1000;  // bytes

double sign_of(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
double smallest(const double* values, int count) { return *std::min_element(values, values + count); }
double largest(const double* values, int count) { return *std::max_element(values, values + count); }

struct Function {
  const char* name;
  double (*value)(double);
};

constexpr std::array functions{
    Function{"sin", [](double x) { return std::sin(x); }},     Function{"cos", [](double x) { return std::cos(x); }},
    Function{"tan", [](double x) { return std::tan(x); }},     Function{"asin", [](double x) { return std::asin(x); }},
    Function{"acos", [](double x) { return std::acos(x); }},   Function{"atan", [](double x) { return std::atan(x); }},
    Function{"exp", [](double x) { return std::exp(x); }},     Function{"log", [](double x) { return std::log(x); }},
    Function{"sqrt", [](double x) { return std::sqrt(x); }},   Function{"abs", [](double x) { return std::abs(x); }},
    Function{"floor", [](double x) { return std::floor(x); }}, Function{"ceil", [](double x) { return std::ceil(x); }},
    Function{"round", [](double x) { return std::round(x); }}, Function{"sign", sign_of},
};
constexpr std::array<std::string_view, 3> functions_of_several{"atan2", "min", "max"};
constexpr std::array<std::string_view, 3> variables{"frame", "t", "pi"};
// Longer ones first, so that `<=` is not taken for `<`.
constexpr std::array<std::string_view, 18> signs{"<=", ">=", "==", "!=", "&&", "||", "+", "-", "*",
                                                 "/",  "^",  "(",  ")",  ",",  "?",  ":", "<", ">"};

std::vector<std::string_view> all_names() {
  std::vector<std::string_view> names(variables.begin(), variables.end());
  for (const Function& function : functions) names.emplace_back(function.name);
  names.insert(names.end(), functions_of_several.begin(), functions_of_several.end());
  return names;
}

std::shared_ptr<void> make_parser(const Moment& moment) {
  const MuParserLibrary& library = mu_parser_library();
  std::shared_ptr<void> handle(library.mupCreate(muBASETYPE_FLOAT), library.mupRelease);
  void* const parser = handle.get();
  library.mupClearFun(parser);
  library.mupClearConst(parser);
  constexpr muBool_t may_be_folded = 1;
  for (const Function& function : functions) {
    library.mupDefineFun1(parser, function.name, function.value, may_be_folded);
  }
  library.mupDefineFun2(
      parser, "atan2", [](double y, double x) { return std::atan2(y, x); }, may_be_folded);
  library.mupDefineMultFun(parser, "min", smallest, may_be_folded);
  library.mupDefineMultFun(parser, "max", largest, may_be_folded);
  library.mupDefineConst(parser, "pi", std::numbers::pi);
  library.mupDefineConst(parser, "frame", moment.frame);
  library.mupDefineConst(parser, "t", moment.t);
  return handle;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

// Each of these checks the first part of an expression, which does not begin with a blank: returns the error in it, or
// sets `length` to its length.
std::optional<ExpressionError> check_number(std::string_view text, std::size_t& length) {
  double ignored = 0;
  const ParsedNumber number = parse_number(text.data(), text.data() + text.size(), ignored);
  if (number.error == NumberError::not_a_number) {
    return ExpressionError{text.substr(0, 1), "a number in this expression is incomplete", {}};
  }
  length = static_cast<std::size_t>(number.end - text.data());
  if (number.error == NumberError::none) return std::nullopt;
  const std::string_view part = text.substr(0, length);
  return ExpressionError{part, fmt::format("the number {} is too large", in_quotes(part)), {}};
}

std::optional<ExpressionError> check_name(std::string_view text, std::size_t& length) {
  const auto* const end =
      std::find_if_not(text.begin(), text.end(), [](char c) { return is_letter(c) || detail::is_digit(c); });
  length = static_cast<std::size_t>(end - text.begin());
  const std::string_view part = text.substr(0, length);
  static const std::vector<std::string_view> names = all_names();
  if (std::find(names.begin(), names.end(), part) != names.end()) return std::nullopt;
  return ExpressionError{part, fmt::format("unknown name {} in this expression", in_quotes(part)),
                         did_you_mean(nearest_word(part, names))};
}

std::optional<ExpressionError> check_first_part(std::string_view text, std::size_t& length) {
  if (detail::is_digit(text[0]) || text[0] == '.') return check_number(text, length);
  if (is_letter(text[0])) return check_name(text, length);
  for (const std::string_view sign : signs) {
    length = sign.size();
    if (text.starts_with(sign)) return std::nullopt;
  }
  const std::string_view part = text.substr(0, 1);
  return ExpressionError{part, fmt::format("{} is not allowed in an expression", in_quotes(part)), {}};
}

// The first error in a single part of an expression.
std::optional<ExpressionError> error_in_parts(std::string_view rest) {
  while (!rest.empty()) {
    std::size_t length = 1;
    if (!is_blank(rest[0])) {
      if (auto error = check_first_part(rest, length)) return error;
    }
    rest.remove_prefix(length);
  }
  return std::nullopt;
}

std::string sentence_for(int code, std::string_view token) {
  switch (code) {
    case mu::ecUNEXPECTED_EOF:
      return "this expression ends too early";
    case mu::ecMISSING_PARENS:
      return "a `)` is missing in this expression";
    case mu::ecMISSING_ELSE_CLAUSE:
      return "a `?` needs a `:` and another value in this expression";
    case mu::ecTOO_MANY_PARAMS:
      return "a function in this expression has too many arguments";
    case mu::ecTOO_FEW_PARAMS:
      return "a function in this expression has too few arguments";
    default:
      return token.empty() ? "this expression makes no sense"
                           : fmt::format("{} makes no sense at this place in the expression", in_quotes(token));
  }
}

// The part that an error of muParser refers to: `position` is where the part begins, or where it ends.
std::string_view part_of(int position, std::string_view token, std::string_view text) {
  const auto at = static_cast<std::size_t>(std::max(position, 0));
  for (const std::size_t begin : {at, at - std::min(at, token.size())}) {
    if (!token.empty() && begin < text.size() && text.substr(begin).starts_with(token)) {
      return text.substr(begin, token.size());
    }
  }
  return text;
}

}  // namespace

std::optional<ExpressionError> Expressions::evaluate(std::string_view text, double& value) {
  if (text.size() > longest_expression) {
    return ExpressionError{
        text.substr(0, 1), fmt::format("an expression may not have more than {} bytes", longest_expression), {}};
  }
  if (std::all_of(text.begin(), text.end(), is_blank)) return ExpressionError{text, "this expression is empty", {}};
  if (auto error = error_in_parts(text)) return error;
  if (!parser_) parser_ = make_parser(moment_);
  const MuParserLibrary& library = mu_parser_library();
  void* const parser = parser_.get();
  std::string in_blanks(text);
  std::replace_if(in_blanks.begin(), in_blanks.end(), is_blank, ' ');
  int results = 0;
  const double* result = nullptr;
  library.mupSetExpr(parser, in_blanks.c_str());
  bool failed = library.mupError(parser) != 0;
  if (!failed) {
    result = library.mupEvalMulti(parser, &results);
    failed = library.mupError(parser) != 0;
  }
  if (failed || result == nullptr) {
    const std::string token = library.mupGetErrorToken(parser);
    return ExpressionError{
        part_of(library.mupGetErrorPos(parser), token, text), sentence_for(library.mupGetErrorCode(parser), token), {}};
  }
  if (results != 1) return ExpressionError{text, "this expression has more than one value", {}};
  value = result[0];
  return std::nullopt;
}

std::string functions_of_expressions() {
  std::string names;
  for (const Function& function : functions) names += fmt::format("`{}`, ", function.name);
  return names + "`atan2(y, x)`, `min(...)` and `max(...)`";
}

}  // namespace penumbra
