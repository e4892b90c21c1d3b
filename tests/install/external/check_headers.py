"""What the installed headers bring along.

morphcl.hpp adds no macro to those of its own standard and GLM includes but MORPHCL_...; in the lines that come from its
headers stands nothing of OpenCL or of other libraries. Takes the include folder and the compilers.
"""

import pathlib
import re
import subprocess
import sys

FOREIGN = re.compile(r"\b(cl::|cl_[a-z]|CL_[A-Z]|__int128|Imf|Imath|fmt::|nlohmann|toml::|png_|xxh|XXH)")
MAX_HEADERS = 34


def preprocessed(compiler, include, *arguments, text=""):
    command = [compiler, "-std=c++20", f"-I{include}", "-x", "c++", "-E", *arguments]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout


def macros(compiler, include, text):
    return set(re.findall(r"^#define (\w+)", preprocessed(compiler, include, "-dM", "-", text=text), re.MULTILINE))


def own_lines(output, folder):
    """The lines of a preprocessed text that come from a file of `folder`."""
    inside = False
    for line in output.splitlines():
        marker = re.match(r'# \d+ "([^"]*)"', line)
        if marker:
            inside = marker.group(1).startswith(str(folder))
        elif inside and line.strip():
            yield line


def foreign_lines(compiler, include, header):
    folder = include / "morphcl"
    lines = list(own_lines(preprocessed(compiler, include, str(folder / header)), folder))
    return lines, [line for line in lines if FOREIGN.search(line)]


def faults(compiler, include):
    folder = include / "morphcl"
    headers = sorted(folder.glob("*.hpp"))
    if len(headers) > MAX_HEADERS:
        yield f"{len(headers)} public headers; at most {MAX_HEADERS} are meant"
    includes = set()
    for header in headers:
        if header.name != "opencl_interop.hpp":
            includes.update(re.findall(r"^#include <.*>", header.read_text(), re.MULTILINE))
    for line in sorted(includes):
        if not re.fullmatch(r"#include <(\w+|glm/[\w/.]+)>", line):
            yield f"{line} in a public header; only the standard library and GLM are meant"
    added = macros(compiler, include, "#include <morphcl/morphcl.hpp>") - macros(compiler, include, "\n".join(includes))
    if "MORPHCL_VERSION_MAJOR" not in added:
        yield "MORPHCL_VERSION_MAJOR is not among the macros: are they looked at as they should be?"
    for name in sorted(added):
        if not name.startswith("MORPHCL_"):
            yield f"morphcl.hpp adds the macro {name}"
    lines, foreign = foreign_lines(compiler, include, "morphcl.hpp")
    if len(lines) < 500:
        yield f"morphcl.hpp has {len(lines)} lines of its own: are they looked at as they should be?"
    for line in foreign:
        yield f"morphcl.hpp shows {line.strip()}"
    if not foreign_lines(compiler, include, "opencl_interop.hpp")[1]:
        yield "opencl_interop.hpp shows no OpenCL: is it looked at as it should be?"


def main():
    include = pathlib.Path(sys.argv[1])
    found = [f"{compiler}: {fault}" for compiler in sys.argv[2:] for fault in faults(compiler, include)]
    print("\n".join(found))
    return 1 if found else 0


sys.exit(main())
