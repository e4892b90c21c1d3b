// Confined reading of files, and the hash of what was read.
#include <gtest/gtest.h>

#include <filesystem>

#include "host/scene/model/content_hash.hpp"
#include "host/scene/model/input_file.hpp"
#include "tests/scene/import_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {
namespace {

namespace fs = std::filesystem;

TEST(InputFile, ReadsAllBytesUpToTheLimit) {
  const test_support::TemporaryFolder folder;
  const std::string bytes("a\0b\n", 4), path = folder.write("file", bytes);
  EXPECT_EQ(read_input_file(path, 4), bytes);
  expect_refusal([&] { read_input_file(path, 3); }, ErrorKind::bad_input, path, "holds 4 bytes; at most 3 are read");
  EXPECT_EQ(read_input_file(folder.write("empty", ""), 0), "");
}

TEST(InputFile, TextInOtherEncodingsIsNamed) {
  using namespace std::string_literals;
  for (const std::string& text : {"\xff\xfe#\0 \0"s, "\xfe\xff\0#\0 "s, "#\0 \0\n\0"s, "\0#\0 "s, "\xff\xfe"s})
    expect_refusal([&] { require_utf8(text, "a.obj"); }, ErrorKind::bad_input, "a.obj", "is text in UTF-16");
  for (const std::string& text : {"\xff\xfe\0\0#\0\0\0"s, "\0\0\xfe\xff\0\0\0#"s})
    expect_refusal([&] { require_utf8(text, "a.obj"); }, ErrorKind::bad_input, "a.obj", "is text in UTF-32");
  for (const std::string& text : {""s, "v"s, "\xef\xbb\xbfv 0 0 0"s, "v 0 0 0\n"s, "\xc3\xa4"s, "a\0"s, "abc\0"s})
    EXPECT_NO_THROW(require_utf8(text, "a.obj"));
}

TEST(InputFile, DevicesAndFoldersAreRefused) {
  for (const std::string path : {"/dev/zero", "/", "/dev/null"})
    expect_refusal([&] { read_input_file(path, 100); }, ErrorKind::cannot_read, path, "not a regular file");
}

TEST(ConfinedPath, StaysInTheFolderOfTheOwner) {
  const test_support::TemporaryFolder folder;
  const std::string owner = folder.write("models/a.gltf", "");
  const fs::path root = fs::canonical(folder.path()) / "models";
  EXPECT_EQ(confined_path(owner, "b.bin", false, "here"), (root / "b.bin").string());
  EXPECT_EQ(confined_path(owner, "x/../b.bin", false, "here"), (root / "b.bin").string());
  EXPECT_EQ(confined_path(owner, "./x/y.bin", false, "here"), (root / "x/y.bin").string());
  for (const std::string reference :
       {"../b.bin", "x/../../b.bin", "/b.bin", "C:b.bin", "file:b.bin", "..", "../models2/b"})
    expect_refusal([&] { confined_path(owner, reference, false, "here"); }, ErrorKind::bad_input, "here",
                   "--allow-outside");
  for (const std::string& reference : {std::string(), std::string("a\0b", 3)})
    expect_refusal([&] { confined_path(owner, reference, true, "here"); }, ErrorKind::bad_input, "here", "zero byte");
  EXPECT_EQ(confined_path(owner, "/b.bin", true, "here"), "/b.bin");
}

TEST(ConfinedPath, AnOwnerWithoutAFolderLiesInTheWorkingOne) {
  const fs::path here = fs::canonical(fs::current_path());
  for (const std::string owner : {"chair.obj", "./chair.obj"}) {
    EXPECT_EQ(confined_path(owner, "none.mtl", false, "here"), (here / "none.mtl").string()) << owner;
    EXPECT_EQ(confined_path(owner, "no/such/../none.mtl", false, "here"), (here / "no/none.mtl").string()) << owner;
    expect_refusal([&] { confined_path(owner, "../none.mtl", false, "here"); }, ErrorKind::bad_input, "here", "leaves");
  }
}

TEST(ConfinedPath, SymbolicLinksOfFoldersAreFollowed) {
  const test_support::TemporaryFolder folder;
  const std::string owner = folder.write("models/a.gltf", "");
  folder.write("other/b.bin", "");
  fs::create_directory_symlink("../other", folder.path() / "models/link");
  fs::create_directory_symlink("models", folder.path() / "alias");
  expect_refusal([&] { confined_path(owner, "link/b.bin", false, "here"); }, ErrorKind::bad_input, "here", "leaves");
  const std::string through = (folder.path() / "alias/a.gltf").string();
  EXPECT_EQ(confined_path(through, "b.bin", false, "here"), (fs::canonical(folder.path()) / "models/b.bin").string());
}

TEST(ContentHash, DependsOnEveryByteAndOnThePieces) {
  const auto hash = [](const std::vector<std::string>& pieces) {
    ContentHash all;
    for (const std::string& piece : pieces) all.add(piece);
    return all.hex();
  };
  EXPECT_EQ(hash({"ab", "c"}), hash({"ab", "c"}));
  EXPECT_NE(hash({"ab", "c"}), hash({"a", "bc"}));
  EXPECT_NE(hash({"ab"}), hash({"ab", ""}));
  EXPECT_NE(hash({"ab"}), hash({"aB"}));
  EXPECT_EQ(hash({}).find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(hash({}).size(), 32u);
  // By the one-shot function over the lengths and the bytes. Kept images are recognised by it, so it must not change.
  EXPECT_EQ(hash({"morphcl", "scene"}), "016d79828bfbcdb4837d7c13fb51c7c4");
}

}  // namespace
}  // namespace morphcl::test
