#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

/// Every test process has a separate folder for temporary files (TMPDIR), removed at its end: the
/// same test may run twice at a time, in two checkouts or by two users.
namespace {

class OwnTemporaryFolder {
 public:
  OwnTemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "adore-test-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw std::runtime_error("no temporary folder can be made: " + pattern);
    path_ = pattern;
    ::setenv("TMPDIR", path_.c_str(), 1);
  }
  ~OwnTemporaryFolder() {
    std::error_code ignored;
    if (::getpid() == owner_) std::filesystem::remove_all(path_, ignored);  // not of a fork
  }

 private:
  std::filesystem::path path_;
  pid_t owner_ = ::getpid();
};
const OwnTemporaryFolder folder;

}  // namespace
