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
  for (std::size_t i = 0; i < out.size(); ++i) {
    char& c = out[i];
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = c == '\n' || c == '\t' ? ' ' : '?';
    // U+0080 to U+009F, among which are the one-character forms of escape sequences.
    if (c == '\xc2' && i + 1 < out.size() && static_cast<unsigned char>(out[i + 1]) >= 0x80 &&
        static_cast<unsigned char>(out[i + 1]) < 0xa0)
      c = out[i + 1] = '?';
  }
  return out;
}

Error::Error(ErrorKind kind, std::string_view place, std::string_view message)
    : std::runtime_error(join(place, message)), kind_(kind), place_(printable(place)), message_(printable(message)) {}

Error Error::at(std::string_view place) const { return place_.empty() ? Error(kind_, place, message_) : *this; }

}  // namespace morphcl
