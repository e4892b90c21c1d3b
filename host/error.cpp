#include "morphcl/error.hpp"

namespace morphcl {

namespace {
std::string join(std::string_view place, std::string_view message) {
  std::string line = printable(place);
  if (!line.empty()) line += ": ";
  return line + printable(message);
}
}  // namespace

std::string printable(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = c == '\n' || c == '\t' ? ' ' : '?';
  return out;
}

Error::Error(ErrorKind kind, std::string_view place, std::string_view message)
    : std::runtime_error(join(place, message)), kind_(kind), place_(printable(place)), message_(printable(message)) {}

Error Error::at(std::string_view place) const { return place_.empty() ? Error(kind_, place, message_) : *this; }

}  // namespace morphcl
