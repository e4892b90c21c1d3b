// A cache file that is not exactly what was stored must be as good as missing.
#include "host/device/disk_cache.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "host/temporary_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl {
namespace {

namespace fs = std::filesystem;
using test_support::TemporaryFolder;
using Bytes = std::vector<unsigned char>;

const CacheKey key{0x0123456789abcdef, 0xfedcba9876543210};
const Bytes content = {'k', 'e', 'r', 'n', 'e', 'l', 0, 255};
constexpr std::size_t header_bytes = 40;

class DiskCacheFile : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(cache.store(key, content)); }

  fs::path file() const { return folder / (key.hex() + ".bin"); }

  Bytes read() const {
    const std::vector<char> bytes = test_support::bytes_of(file());
    return Bytes(bytes.begin(), bytes.end());
  }
  void write(const Bytes& bytes) const { test_support::write_bytes(file(), {bytes.begin(), bytes.end()}); }

  TemporaryFolder folder;
  DiskCache cache{folder.path(), "bin"};
};

TEST_F(DiskCacheFile, IsFoundAgain) {
  EXPECT_EQ(cache.load(key), content);
  EXPECT_EQ(read().size(), header_bytes + content.size());
}

// It holds native code: what others can write is not run.
TEST_F(DiskCacheFile, OfAnotherUserOrWritableByOthersIsMissing) {
  for (const mode_t mode : {0620, 0602, 0666}) {
    ASSERT_EQ(chmod(file().c_str(), mode), 0);
    EXPECT_EQ(cache.load(key), std::nullopt) << std::oct << mode;
  }
  ASSERT_EQ(chmod(file().c_str(), 0644), 0);
  EXPECT_EQ(cache.load(key), content);
  if (geteuid() != 0) return;  // only root can give files away
  ASSERT_EQ(chown(file().c_str(), 12345, 12345), 0);
  EXPECT_EQ(cache.load(key), std::nullopt);
}

TEST(DiskCacheFolder, ThatDoesNotTakeAFileSaysWhy) {
  std::string trouble;
  EXPECT_FALSE(DiskCache("/proc/none", "bin").store(key, content, &trouble));
  EXPECT_NE(trouble, "");
}

TEST_F(DiskCacheFile, CutAnywhereIsMissing) {
  const Bytes whole = read();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)));
    EXPECT_EQ(cache.load(key), std::nullopt) << "cut to " << length << " bytes";
  }
}

TEST_F(DiskCacheFile, OneFlippedBitAnywhereIsMissing) {
  const Bytes whole = read();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    Bytes damaged = whole;
    damaged[at] ^= static_cast<unsigned char>(1u << (at % 8));
    write(damaged);
    EXPECT_EQ(cache.load(key), std::nullopt) << "bit " << at % 8 << " of byte " << at;
  }
}

TEST_F(DiskCacheFile, WithMoreBehindItIsMissing) {
  Bytes longer = read();
  longer.push_back(0);
  write(longer);
  EXPECT_EQ(cache.load(key), std::nullopt);
}

TEST_F(DiskCacheFile, UnderAnotherKeysNameIsMissing) {
  const CacheKey other{key.high, key.low + 1};
  fs::rename(file(), folder / (other.hex() + ".bin"));
  EXPECT_EQ(cache.load(other), std::nullopt);
}

// As in a container that is started again: the names that this process is about to use are there, those that held no
// host as well.
TEST_F(DiskCacheFile, WhatAnEarlierProcessOfOurNumberLeftIsNotInTheWay) {
  for (unsigned number = 0; number < 100; ++number) {
    test_support::write_bytes(fmt::format("{}.{}.{}.tmp", file().string(), getpid(), number), {'x'});
    test_support::write_bytes(temporary_name(file().string(), getpid(), number), {'x'});
  }
  fs::remove(file());
  EXPECT_TRUE(cache.store(key, content));
  EXPECT_EQ(cache.load(key), content);
  for (const std::string& found : folder.names()) EXPECT_FALSE(found.ends_with(".morphcl-tmp")) << found;
}

TEST_F(DiskCacheFile, ReplacedByAFolderOrAPipeIsMissing) {
  fs::remove(file());
  fs::create_directory(file());
  EXPECT_EQ(cache.load(key), std::nullopt);
  fs::remove(file());
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  EXPECT_EQ(cache.load(key), std::nullopt);  // and does not wait for a writer
}

TEST_F(DiskCacheFile, OfAbsurdSizeIsMissingAndNotRead) {
  fs::resize_file(file(), std::uintmax_t{1} << 40);  // sparse
  EXPECT_EQ(cache.load(key), std::nullopt);
}

TEST_F(DiskCacheFile, IsReplacedByAStoreAndLeavesNothingBeside) {
  write({1, 2, 3});
  const Bytes other = {9, 8, 7};
  EXPECT_TRUE(cache.store(key, other));
  EXPECT_EQ(cache.load(key), other);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(DiskCache, EmptyContentIsContent) {
  const TemporaryFolder folder;
  const DiskCache cache(folder.path(), "bin");
  EXPECT_TRUE(cache.store(key, {}));
  EXPECT_EQ(cache.load(key), Bytes());
}

TEST(DiskCache, WithoutAFolderNothingIsKept) {
  const DiskCache cache(std::nullopt, "bin");
  EXPECT_FALSE(cache.store(key, content));
  EXPECT_EQ(cache.load(key), std::nullopt);
}

TEST(DiskCache, CreatesItsFolder) {
  const TemporaryFolder folder;
  const DiskCache cache(folder / "a" / "b", "bin");
  EXPECT_EQ(cache.load(key), std::nullopt);
  EXPECT_TRUE(cache.store(key, content));
  EXPECT_EQ(cache.load(key), content);
}

TEST(DiskCache, AFolderThatCannotBeIsNoError) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "in the way";
  const DiskCache cache(folder / "file" / "cache", "bin");
  EXPECT_FALSE(cache.store(key, content));
  EXPECT_EQ(cache.load(key), std::nullopt);
}

TEST(DiskCache, KeysTellPartsApart) {
  const auto hex = [](std::vector<std::string> parts) { return cache_key(parts).hex(); };
  EXPECT_EQ(hex({"ab", "c"}), hex({"ab", "c"}));
  EXPECT_NE(hex({"ab", "c"}), hex({"a", "bc"}));
  EXPECT_NE(hex({"ab", "c"}), hex({"abc"}));
  EXPECT_NE(hex({"ab", "c"}), hex({"ab", "c", ""}));
  EXPECT_EQ(hex({"x"}).size(), 32u);
}

}  // namespace
}  // namespace morphcl
