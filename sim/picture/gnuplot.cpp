#include "sim/picture/gnuplot.hpp"

#include <cstdio>
#include <filesystem>
#include <system_error>

namespace quickstrip {

FileStatus draw_with_gnuplot(const std::function<std::string(const std::string& png)>& script,
                             const std::string& png) {
  const std::string beside = png + ".part";
  std::FILE* const pipe = popen("gnuplot >/dev/null 2>&1", "w");
  if (pipe == nullptr) {
    return FileError{png + ": gnuplot cannot be started"};
  }
  const std::string text = script(beside);
  const bool was_written = std::fwrite(text.data(), 1, text.size(), pipe) == text.size();
  const bool has_ended_well = pclose(pipe) == 0;
  std::error_code error;
  if (!was_written || !has_ended_well || !std::filesystem::exists(beside, error)) {
    std::filesystem::remove(beside, error);
    return FileError{png + ": not drawn; is the folder there, and gnuplot (Debian package gnuplot-nox)?"};
  }
  std::filesystem::rename(beside, png, error);
  if (error) {
    return FileError{png + ": " + error.message()};
  }
  return {};
}

}  // namespace quickstrip
