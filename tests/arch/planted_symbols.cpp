// Not part of anything: an archive with the faults that core_symbols.sh must find.
#include <stdexcept>
#include <string>

int g_planted_state = 0;

std::string* planted(int n) {
  static int calls = n;  // a guarded function static
  ++calls;
  if (++g_planted_state > n) {
    throw std::runtime_error("planted");
  }
  return new std::string(static_cast<std::size_t>(n), 'x');
}
