#include "core/base/check.hpp"

namespace quickstrip {
namespace {
CheckHandler g_handler = nullptr;
}  // namespace

void set_check_handler(CheckHandler handler) {
  g_handler = handler;
}

void check_failed(const char* claim, const char* file, int line) {
  if (g_handler != nullptr) {
    g_handler(claim, file, line);
  }
  __builtin_trap();
}

}  // namespace quickstrip
