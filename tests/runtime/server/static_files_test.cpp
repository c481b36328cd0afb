#include "server/static_files.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <gtest/gtest.h>

namespace mirada::server {
namespace fs = std::filesystem;
namespace {

class StaticFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    base_ = fs::temp_directory_path() / ("mirada-ui-" + std::to_string(::getpid()));
    fs::create_directories(base_ / "ui/assets");
    write("secret.txt", "secret");
    write("ui/index.html", "<p>editor</p>");
    write("ui/assets/index-AbC_12-x.js", "let a = 1;");
    write("ui/assets/index-AbC_12-x.js.gz", "packed");
    write("ui/.hidden", "hidden");
    fs::create_symlink(base_ / "secret.txt", base_ / "ui/link.txt");
    fs::create_directory_symlink(base_, base_ / "ui/out");
  }
  void TearDown() override { fs::remove_all(base_); }
  void write(const std::string& name, const std::string& text) { std::ofstream(base_ / name) << text; }

  fs::path base_;
};

TEST_F(StaticFilesTest, gives_files_with_type_and_etag) {
  const StaticFiles files(base_ / "ui");
  const auto index = files.find("/", true);
  ASSERT_TRUE(index);
  EXPECT_EQ(index->bytes, "<p>editor</p>");
  EXPECT_EQ(index->type, "text/html; charset=utf-8");
  EXPECT_FALSE(index->gzip || index->immutable);
  EXPECT_EQ(index->etag.front(), '"');
  EXPECT_EQ(files.find("/index.html?x=/../secret.txt", false)->bytes, "<p>editor</p>");
}

TEST_F(StaticFilesTest, gives_the_packed_form_to_those_who_take_it) {
  const StaticFiles files(base_ / "ui");
  const auto packed = files.find("/assets/index-AbC_12-x.js", true);
  const auto plain = files.find("/assets/index-AbC_12-x.js", false);
  ASSERT_TRUE(packed && plain);
  EXPECT_EQ(packed->bytes, "packed");
  EXPECT_TRUE(packed->gzip && packed->immutable);
  EXPECT_EQ(plain->bytes, "let a = 1;");
  EXPECT_EQ(packed->type, "text/javascript; charset=utf-8");
  EXPECT_NE(packed->etag, plain->etag);
}

TEST_F(StaticFilesTest, no_path_leaves_the_folder) {
  const StaticFiles files(base_ / "ui");
  for (const char* target :
       {"/../secret.txt", "/..", "/assets/../../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt",
        "/link.txt", "/out/secret.txt", "/.hidden", "//secret.txt", "/assets", "/assets/", "secret.txt", "",
        "*", "/a\\b", "/./index.html", "http://x/secret.txt", "/no.js"}) {
    EXPECT_FALSE(files.find(target, true)) << target;
  }
  EXPECT_FALSE(files.find(std::string("/index.html\0.js", 15), true));
}

TEST_F(StaticFilesTest, knows_whether_the_editor_is_there) {
  EXPECT_TRUE(StaticFiles(base_ / "ui").built());
  EXPECT_FALSE(StaticFiles(base_ / "nowhere").built());
  EXPECT_FALSE(StaticFiles(base_ / "nowhere").find("/", true));
}

TEST(AcceptsGzip, reads_the_line) {
  for (const char* line : {"gzip", "deflate, gzip", "gzip, deflate, br", "gzip;q=1.0", "gzip;q=0.5, br"}) {
    EXPECT_TRUE(accepts_gzip(line)) << line;
  }
  for (const char* line : {"", "br", "gzip;q=0", "gzip; q=0.0, br", "identity"}) {
    EXPECT_FALSE(accepts_gzip(line)) << line;
  }
}

}  // namespace
}  // namespace mirada::server
