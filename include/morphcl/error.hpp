// What goes wrong is thrown as an Error: its kind, which decides the exit code of the command line tool, and one line
// "PLACE: what is wrong; what would be right". PLACE is "file", "file:line:column" or
// "file: accessors[3]"; it is empty where there is no file. The line holds no newline, whatever the input held.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace morphcl {

// The numbers are the exit codes of the command line tool.
enum class ErrorKind : int {
  usage = 2,           // the caller asked for something that makes no sense
  bad_input = 65,      // a shot, a model, or data of a scene made in code (a mesh, keys, a size) is wrong
  cannot_read = 66,    // an input is missing or unreadable
  no_device = 69,      // no usable OpenCL device, or not the memory, threads or scratch space that the work takes
  internal = 70,       // a defect of morphcl or of the OpenCL driver
  cannot_create = 73,  // an output cannot be created
  write_failed = 74,   // an output was created but not all of it could be written
  interrupted = 75,    // whoever asked for it has asked to stop
};

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::string_view place, std::string_view message);

  // The same failure, with `place` put in front of a line that has no place yet.
  Error at(std::string_view place) const;

  ErrorKind kind() const { return kind_; }
  int exit_code() const { return static_cast<int>(kind_); }
  const std::string& place() const { return place_; }
  const std::string& message() const { return message_; }  // the line without its place

 private:
  ErrorKind kind_;
  std::string place_, message_;
};

// `text` with control characters replaced, so that hostile names stay on one line of a terminal.
std::string printable(std::string_view text);

}  // namespace morphcl
#pragma GCC visibility pop
