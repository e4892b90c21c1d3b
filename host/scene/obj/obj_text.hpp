// The text layer of .obj and .mtl files: statements and numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace morphcl {

// Walks over the statements of a file: comments and blank lines are skipped, a line that ends in a backslash continues
// on the next, and lines end in LF, CR LF or CR. A comment starts with a '#' that begins a line or follows a blank, and
// ends with its line, whatever stands before the end. A byte order mark at the start is skipped.
class ObjStatements {
 public:
  explicit ObjStatements(std::string_view text);

  // Moves to the next statement; false at the end of the file.
  bool next();
  std::string_view keyword() const { return keyword_; }  // "v"
  std::size_t line() const { return line_; }             // of the statement's start, from 1

  // The next word of the statement, empty at its end.
  std::string_view word();
  // All of the statement that is left, without spaces at either end.
  std::string_view remainder() const;

 private:
  std::string_view take_line();  // without its comment

  std::string_view rest_, keyword_, words_;
  std::string joined_;  // a statement of several lines
  std::size_t line_ = 0, lines_taken_ = 0;
};

// A decimal number, correctly rounded to fp32 whatever the locale (std::from_chars). What is below the smallest
// subnormal is 0 with its sign. Nothing when the word is not a number, or is not finite in fp32.
std::optional<float> parse_float(std::string_view word);

// Nothing when the word is not a whole number or exceeds 64 bits.
std::optional<std::int64_t> parse_integer(std::string_view word);

}  // namespace morphcl
