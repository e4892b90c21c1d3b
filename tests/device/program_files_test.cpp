#include "host/device/program_files.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<unsigned char>;
using test_support::TemporaryFolder;
using test_support::text_of;

// As PoCL leaves it: two levels of names, then files, and a folder a kernel.
class ProgramFiles : public ::testing::Test {
 protected:
  ProgramFiles() {
    write("AB/CDEF/program.bc", std::string("bit\0code", 8));
    write("AB/CDEF/draw/1-1-1/draw.so", "machine code");
    write("AB/CDEF/draw/empty", "");
    write("AB/CDEF/bin/4-1-1/bin.so", std::string(100'000, 'x'));
    write("GH/IJ/program.bc", "another program's");
    write("tempfile", "");
  }

  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((pocl_.path() / file).parent_path());
    std::ofstream(pocl_.path() / file, std::ios::binary) << text;
  }

  Bytes packed(const std::set<std::string>& kernels = {"draw", "bin"}) const {
    const auto bytes = pack_program_files(pocl_.path(), "AB/CDEF", kernels);
    EXPECT_TRUE(bytes.has_value());
    return bytes.value_or(Bytes());
  }

  static std::map<std::string, std::string> files_below(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = text_of(entry.path());
    return files;
  }

  const TemporaryFolder pocl_, other_;
};

TEST_F(ProgramFiles, AreFoundTwoLevelsDown) {
  EXPECT_EQ(program_folders(pocl_.path()), (std::set<fs::path>{"AB/CDEF", "GH/IJ"}));
  EXPECT_TRUE(program_folders(pocl_.path() / "none").empty());
}

TEST_F(ProgramFiles, ComeBackAsTheyWere) {
  ASSERT_EQ(unpack_program_files(other_.path(), packed()), "AB/CDEF");
  EXPECT_EQ(files_below(other_.path() / "AB" / "CDEF"), files_below(pocl_.path() / "AB" / "CDEF"));
  EXPECT_EQ(files_below(other_.path()).size(), 4u);
}

TEST_F(ProgramFiles, ThatStandThereStay) {
  const Bytes bytes = packed();
  write("AB/CDEF/draw/1-1-1/draw.so", "compiled since");
  EXPECT_TRUE(unpack_program_files(pocl_.path(), bytes));
  EXPECT_EQ(text_of(pocl_.path() / "AB/CDEF/draw/1-1-1/draw.so"), "compiled since");
}

TEST_F(ProgramFiles, OfKernelsThatHaveNotRunAreNotTaken) {
  EXPECT_FALSE(pack_program_files(pocl_.path(), "AB/CDEF", {"draw", "clip"}));
  EXPECT_FALSE(pack_program_files(pocl_.path(), "AB/CDEF", {}));
  EXPECT_FALSE(pack_program_files(pocl_.path(), "GH/IJ", {"draw"}));
  EXPECT_FALSE(pack_program_files(pocl_.path(), "AB/none", {"draw"}));
}

TEST_F(ProgramFiles, CutAnywhereAreNotPutBack) {
  write("AB/CDEF/bin/4-1-1/bin.so", "short");
  const Bytes bytes = packed();
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(unpack_program_files(other_.path(), std::span(bytes).first(length))) << length;
    ASSERT_TRUE(fs::is_empty(other_.path())) << length;
  }
  Bytes longer = bytes;
  longer.push_back(0);
  EXPECT_FALSE(unpack_program_files(other_.path(), longer));
}

TEST_F(ProgramFiles, DamagedAnywhereStayBelowTheFolder) {
  write("AB/CDEF/bin/4-1-1/bin.so", "short");
  const Bytes bytes = packed();
  const std::string values("\0./\xff", 4);
  const fs::path inner = other_.path() / "inner";
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    fs::create_directory(inner);
    Bytes damaged = bytes;
    damaged[i] = static_cast<unsigned char>(values[i % values.size()]);
    unpack_program_files(inner, damaged);
    EXPECT_EQ(std::distance(fs::directory_iterator(other_.path()), fs::directory_iterator()), 1) << i;
    fs::remove_all(inner);
  }
}

TEST_F(ProgramFiles, WithPathsThatLeadElsewhereAreRefused) {
  const std::string inside = "AB/CDEF", name = "program.bc";
  const Bytes bytes = packed();
  const auto with = [&bytes](const std::string& from, const std::string& to) {
    std::string text(bytes.begin(), bytes.end());
    text.replace(text.find(from), from.size(), to);
    return Bytes(text.begin(), text.end());
  };
  EXPECT_FALSE(unpack_program_files(other_.path(), with(inside, "../CDEF")));
  EXPECT_FALSE(unpack_program_files(other_.path(), with(inside, "/B/CDEF")));
  EXPECT_FALSE(unpack_program_files(other_.path(), with(name, "../../a.bc")));
  EXPECT_FALSE(unpack_program_files(other_.path(), with(name, "/rogram.bc")));
  EXPECT_TRUE(fs::is_empty(other_.path()));
}

TEST_F(ProgramFiles, HaveNoEffectWhereNothingCanBeWritten) {
  EXPECT_FALSE(unpack_program_files("/proc/nope", packed()));
  EXPECT_FALSE(unpack_program_files(other_.path() / "none", packed()));
}

}  // namespace
}  // namespace morphcl
