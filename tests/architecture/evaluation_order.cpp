#include "tests/architecture/evaluation_order.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>

#include "tests/support/temporary_folder.hpp"

namespace morphcl::architecture {

namespace {

namespace fs = std::filesystem;

// The text with comments and the insides of texts and characters blanked; lines stay where they are.
std::string code_of(const std::string& text) {
  std::string code = text;
  const auto blank = [&code](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, code.size()); ++i)
      if (code[i] != '\n') code[i] = ' ';
  };
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    std::size_t end = at;
    if (text.compare(at, 2, "//") == 0) {
      end = text.find('\n', at);
      blank(at, end);
    } else if (text.compare(at, 2, "/*") == 0) {
      end = text.find("*/", at);
      blank(at, end);
    } else if (text.compare(at, 3, "R\"(") == 0) {
      end = text.find(")\"", at);
      blank(at, end);
      if (end != std::string::npos) ++end;
    } else if (c == '"' || (c == '\'' && (at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0))) {
      for (end = at + 1; end < text.size() && text[end] != c; ++end)
        if (text[end] == '\\') ++end;
      blank(at + 1, end);
    }
    if (end == std::string::npos) break;
    at = end;
  }
  return code;
}

// Behind the bracket that closes the one at `open`.
std::size_t past_closing(const std::string& code, std::size_t open, char opening, char closing) {
  int depth = 0;
  for (std::size_t at = open; at < code.size(); ++at) {
    if (code[at] == opening) ++depth;
    if (code[at] == closing && --depth == 0) return at + 1;
  }
  return code.size();
}

const std::string random_engine = "*";  // an object's name that no code has

struct Call {
  std::string object, function;
  std::size_t start, end;  // of the whole call, its arguments included
};

bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Where the name begins that ends before `end`.
std::size_t name_before(const std::string& code, std::size_t end) {
  while (end > 0 && in_name(code[end - 1])) --end;
  return end;
}

// What draws random numbers in this code: engines and distributions of the standard library, by name.
std::set<std::string> drawing_names(const std::string& code) {
  static const std::regex declaration(
      R"((?:mt19937(?:_64)?|_distribution<[\w ]+>)&? ((?:[^;(){}]|\([^()]*\)|\{[^{}]*\})*))");
  static const std::regex declarator(R"((\w+)(?:\([^()]*\)|\{[^{}]*\})?(?:,|$))");
  std::set<std::string> names;
  for (std::sregex_iterator at(code.begin(), code.end(), declaration), end; at != end; ++at) {
    const std::string declarators = (*at)[1];
    for (std::sregex_iterator name(declarators.begin(), declarators.end(), declarator); name != end; ++name)
      names.insert((*name)[1]);
  }
  return names;
}

// Names that are called without an object, and the object that such a call changes: a local lambda itself, and for all
// that draws random numbers one engine, which stands for all.
using ChangingNames = std::map<std::string, std::string>;

// "object.function(" and "object->function(", or "function(" alone.
std::vector<Call> changing_calls(const std::string& code, const std::set<std::string>& members,
                                 const ChangingNames& names) {
  std::vector<Call> calls;
  for (std::size_t open = code.find('('); open != std::string::npos; open = code.find('(', open + 1)) {
    std::size_t start = name_before(code, open);
    const std::string function = code.substr(start, open - start);
    const auto name = names.find(function);
    if (name == names.end() && members.count(function) == 0) continue;
    std::string object = name != names.end() ? name->second : "this";
    const auto follows = [&](const std::string& text) {
      return start >= text.size() && code.compare(start - text.size(), text.size(), text) == 0;
    };
    if (follows("::")) continue;
    if (follows(".") || follows("->")) {
      const std::size_t end = start - (follows(".") ? 1 : 2);
      start = name_before(code, end);
      if (start == end) continue;  // of what an expression gives
      object = code.substr(start, end - start);
    }
    calls.push_back({object, function, start, past_closing(code, open, '(', ')')});
  }
  return calls;
}

// Whether something between two calls of a statement says which is first.
bool is_ordered(const std::string& between) {
  static const std::regex ordering(R"(&&|\|\||\?|[^:]:[^:]|<<|>>|[^=!<>]=[^=])");
  if (std::regex_search(between, ordering)) return true;
  return between.find_first_of("{};") != std::string::npos;
}

// How many parentheses are open at `at` since the last of ; { }.
int depth_at(const std::string& code, std::size_t at) {
  int depth = 0;
  while (at-- > 0) {
    const char c = code[at];
    if (c == ';' || c == '{' || c == '}') break;
    if (c == '(') ++depth;
    if (c == ')') --depth;
  }
  return depth;
}

// A comma outside all parentheses separates declarators, or stands in braces.
bool has_outer_comma(const std::string& code, std::size_t from, std::size_t to) {
  int depth = depth_at(code, from);
  for (std::size_t at = from; at < to; ++at) {
    if (code[at] == '(') ++depth;
    if (code[at] == ')') --depth;
    if (code[at] == ',' && depth <= 0) return true;
  }
  return false;
}

ChangingNames changing_names(const std::string& code, const std::set<std::string>& members) {
  static const std::regex lambda(R"(auto\s+(\w+)\s*=\s*\[&)");
  ChangingNames names;
  for (const std::string& name : drawing_names(code)) names[name] = random_engine;
  for (std::sregex_iterator at(code.begin(), code.end(), lambda), end; at != end; ++at) {
    const std::size_t open = code.find('{', static_cast<std::size_t>(at->position(0)));
    if (open == std::string::npos) continue;
    const std::string body = code.substr(open, past_closing(code, open, '{', '}') - open);
    for (const Call& call : changing_calls(body, members, names))
      if (call.object != "this") names[(*at)[1]] = call.object == random_engine ? call.object : (*at)[1].str();
  }
  return names;
}

// The declarations of each class: what stands between its braces, without what stands in braces there.
std::vector<std::string> class_bodies(const std::string& code) {
  std::vector<std::string> bodies;
  for (const std::string word : {"class ", "struct "})
    for (std::size_t at = code.find(word); at != std::string::npos; at = code.find(word, at + 1)) {
      if (at > 0 && in_name(code[at - 1])) continue;
      const std::size_t open = code.find_first_of(";(){}", at);
      if (open == std::string::npos || code[open] != '{') continue;
      std::string body = "\n";
      for (std::size_t i = open + 1, past = past_closing(code, open, '{', '}'); i + 1 < past; ++i) {
        body += code[i];
        if (code[i] == '{') {
          i = past_closing(code, i, '{', '}') - 1;
          body += '}';
        }
      }
      bodies.push_back(body);
    }
  return bodies;
}

std::vector<fs::path> sources_below(const fs::path& root, const std::vector<std::string>& places) {
  std::vector<fs::path> files;
  const auto add = [&files](const fs::path& path) {
    if (path.extension() == ".cpp" || path.extension() == ".hpp") files.push_back(path);
  };
  for (const std::string& place : places) {
    if (fs::is_directory(root / place))
      for (const auto& entry : fs::recursive_directory_iterator(root / place)) add(entry.path());
    else
      add(root / place);
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::set<std::string> changing_members(const std::vector<std::string>& texts) {
  // A type that is not void, a name, arguments, and what follows them.
  static const std::regex member(
      R"((?:^|[;{}:]\s)\s*(?!return|else|throw|void|using|explicit|static|friend))"
      R"((?:\[\[nodiscard\]\] )?(?:virtual |constexpr |inline )*[A-Za-z_][\w:<>, ]*[&*]? [&*]?)"
      R"(([A-Za-z_]\w*)\([^()]*\)\s*(const|noexcept|override|;|\{|=))");
  std::set<std::string> changing, constant;
  for (const std::string& text : texts)
    for (const std::string& body : class_bodies(code_of(text)))
      for (std::sregex_iterator at(body.begin(), body.end(), member), end; at != end; ++at)
        ((*at)[2] == "const" ? constant : changing).insert((*at)[1]);
  std::set<std::string> result;
  std::set_difference(changing.begin(), changing.end(), constant.begin(), constant.end(),
                      std::inserter(result, result.end()));
  return result;
}

std::vector<std::string> unordered_calls(const std::string& name, const std::string& text,
                                         std::set<std::string> members) {
  const std::string code = code_of(text);
  members.merge(changing_members({text}));  // elsewhere another class may have a constant one of the same name
  const std::vector<Call> calls = changing_calls(code, members, changing_names(code, members));
  std::vector<std::string> found;
  for (std::size_t i = 0; i < calls.size(); ++i)
    for (std::size_t j = i + 1; j < calls.size() && code.find(';', calls[i].end) > calls[j].start; ++j) {
      const Call &a = calls[i], &b = calls[j];
      if (a.object != b.object || b.start < a.end) continue;
      if (is_ordered(code.substr(a.end, b.start - a.end)) || has_outer_comma(code, a.end, b.start)) continue;
      const auto line = std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(b.start), '\n') + 1;
      const std::string of = a.object == a.function || a.object == random_engine ? "" : a.object + ".";
      found.push_back(name + ":" + std::to_string(line) + ": " + of + a.function + " and " + of + b.function);
    }
  return found;
}

std::vector<std::string> unordered_calls_below(const fs::path& root, const std::vector<std::string>& folders,
                                               const std::vector<std::string>& classes) {
  std::vector<std::string> texts;
  for (const fs::path& file : sources_below(root, classes)) texts.push_back(test_support::text_of(file));
  const std::set<std::string> members = changing_members(texts);
  std::vector<std::string> found;
  for (const fs::path& file : sources_below(root, folders))
    for (std::string& line : unordered_calls(fs::relative(file, root).string(), test_support::text_of(file), members))
      found.push_back(std::move(line));
  return found;
}

}  // namespace morphcl::architecture
