#include "image/file_bytes.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "base/error.hpp"
#include "pictures.hpp"

using namespace velum;
namespace fs = std::filesystem;

namespace {

/// An empty folder of the test's own, removed with all it holds.
struct Folder {
  fs::path path;
  Folder() {
    std::string name = (fs::temp_directory_path() / "velum-test-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path = name;
  }
  ~Folder() { fs::remove_all(path); }
  long entries() const { return std::distance(fs::directory_iterator(path), fs::directory_iterator()); }
};

std::string content(const fs::path& path) {
  return pictures::text(read_file(path));
}

std::string write_error(const fs::path& path) {
  try {
    write_file(path, pictures::bytes("new"));
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::write);
    return error.what();
  }
  return "no error";
}

/// One of the standard streams leads elsewhere for a while.
class Redirected {
 public:
  Redirected(int stream, const fs::path& path, int flags) : stream_(stream), saved_(::dup(stream)) {
    const int file = ::open(path.c_str(), flags, 0600);
    ::dup2(file, stream_);
    ::close(file);
  }
  ~Redirected() {
    ::dup2(saved_, stream_);
    ::close(saved_);
  }

 private:
  int stream_;
  int saved_;
};

}  // namespace

TEST_CASE("a file is written whole, replaces an older one, and leaves nothing beside it") {
  const Folder folder;
  const fs::path path = folder.path / "a b.bin";
  write_file(path, pictures::bytes("first, longer"));
  CHECK(content(path) == "first, longer");
  write_file(path, pictures::bytes("second"));
  CHECK(content(path) == "second");
  write_file(path, {});
  CHECK(content(path).empty());
  CHECK(folder.entries() == 1);
}

TEST_CASE("an existing file keeps its permissions, and a link stays a link") {
  const Folder folder;
  const fs::path path = folder.path / "file";
  write_file(path, pictures::bytes("old"));
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("file", folder.path / "link");
  write_file(folder.path / "link", pictures::bytes("new"));
  CHECK(fs::is_symlink(folder.path / "link"));
  CHECK(content(path) == "new");
  CHECK(fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(folder.entries() == 2);
}

TEST_CASE("what cannot be written says path and reason, and leaves no partial file") {
  const Folder folder;
  write_file(folder.path / "file", pictures::bytes("old"));
  const fs::path below_a_file = folder.path / "file" / "x.png";
  CHECK(write_error(below_a_file).find(below_a_file.string() + ": cannot be written: Not a directory") == 0);
  const fs::path no_folder = folder.path / "nothere" / "x.png";
  CHECK(write_error(no_folder).find(no_folder.string() + ": cannot be written: No such file or directory") ==
        0);
  CHECK(write_error(folder.path).find(folder.path.string() + ": cannot be written: Is a directory") == 0);
  CHECK(write_error("").find("cannot be written") != std::string::npos);
  const std::string long_name = std::string(300, 'x');  // the temporary file is made, the rename fails
  CHECK(write_error(folder.path / long_name).find("File name too long") != std::string::npos);
  CHECK(content(folder.path / "file") == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("a device is written to, never replaced") {
  CHECK(write_error("/dev/null") == "no error");
  CHECK(fs::is_character_file("/dev/null"));
  if (fs::exists("/dev/full")) {
    CHECK(write_error("/dev/full").find("/dev/full: cannot be written: No space left on device") == 0);
  }
}

TEST_CASE("what cannot be read says path and reason") {
  const Folder folder;
  const fs::path missing = folder.path / "nothere";
  CHECK_THROWS_WITH_AS(
      read_file(missing),
      doctest::Contains((missing.string() + ": cannot be read: No such file or directory").c_str()), Error);
  CHECK_THROWS_WITH_AS(read_file(folder.path), doctest::Contains("Is a directory"), Error);
  CHECK_THROWS_WITH_AS(read_png(missing), doctest::Contains("nothere"), Error);
}

TEST_CASE("more bytes than may be read are an error, also of a pipe that never ends") {
  const Folder folder;
  write_file(folder.path / "ten", std::vector<std::byte>(10));
  CHECK(read_file(folder.path / "ten", 10).size() == 10);
  const auto kind_of_error = [](const fs::path& path, std::uint64_t most) {
    try {
      read_file(path, most);
    } catch (const Error& error) {
      CHECK(std::string(error.what()).find(path.string()) == 0);
      return error.kind();
    }
    return ErrorKind::cancelled;
  };
  CHECK(kind_of_error(folder.path / "ten", 9) == ErrorKind::limit);
  CHECK(kind_of_error("/dev/zero", 100000) == ErrorKind::limit);
}

TEST_CASE("- is standard output and standard input") {
  const Folder folder;
  const fs::path path = folder.path / "stream";
  const Image<Rgba8> image = pictures::noise(3, 2, true);
  {
    const Redirected output(STDOUT_FILENO, path, O_WRONLY | O_CREAT);
    write_ppm("-", image);
  }
  CHECK(read_file(path) == encode_ppm(image));
  CHECK_FALSE(fs::exists("-"));
  std::vector<std::byte> got;
  {
    const Redirected input(STDIN_FILENO, path, O_RDONLY);
    got = read_file("-");
  }
  CHECK(got == encode_ppm(image));
  CHECK(input_name("-") == "standard input");
}

TEST_CASE("every writer and reader goes through files") {
  const Folder folder;
  const Image<Rgba8> image = pictures::noise(9, 4, false);
  write_png(folder.path / "a.png", image);
  CHECK(read_png(folder.path / "a.png").at(8, 3) == image.at(8, 3));
  write_ppm(folder.path / "a.ppm", image);
  CHECK(read_ppm(folder.path / "a.ppm").at(8, 3).g == image.at(8, 3).g);
  write_pfm(folder.path / "a.pfm", Image<float>(2, 2, 3.5f));
  CHECK(read_pfm(folder.path / "a.pfm").at(1, 1) == 3.5f);
  write_pfm(folder.path / "b.pfm", Image<glm::vec3>(2, 2, glm::vec3(1, 2, 3)));
  CHECK(read_pfm_rgb(folder.path / "b.pfm").at(1, 1) == glm::vec3(1, 2, 3));
  write_npy(folder.path / "a.npy", image);
  write_npy(folder.path / "b.npy", Image<float>(2, 2));
  write_npy(folder.path / "c.npy", Image<glm::vec3>(2, 2));
  write_npy(folder.path / "d.npy", Image<std::uint32_t>(2, 2));
  CHECK(read_file(folder.path / "a.npy") == encode_npy(image));
  CHECK(folder.entries() == 8);
}
