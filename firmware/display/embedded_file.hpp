// The page's files inside the program: what is deployed is one file (.cmake/EmbedFiles.cmake).
#pragma once

#include <span>
#include <string_view>

namespace quickstrip {

struct EmbeddedFile {
  std::string_view name;  // below firmware/display/page
  std::string_view bytes;
};

std::span<const EmbeddedFile> page_files();

/// "text/html; charset=utf-8" and the like, by the ending of the name.
constexpr std::string_view content_type(std::string_view name) {
  if (name.ends_with(".html")) {
    return "text/html; charset=utf-8";
  }
  if (name.ends_with(".css")) {
    return "text/css; charset=utf-8";
  }
  if (name.ends_with(".js")) {
    return "text/javascript; charset=utf-8";
  }
  return name.ends_with(".svg") ? "image/svg+xml" : "application/octet-stream";
}

}  // namespace quickstrip
