// An HTTP server (cpp-httplib) that nobody can hold up: a bounded number of connections, each with a thread
// of its own and a deadline for every request and every answer.
//
// What cpp-httplib's own leaves open: its timeouts begin anew with each byte (a request that drips in at a
// byte every four seconds holds a thread for hours), and its queue of accepted connections has no end.
// Limits: kMaxConnections at once, more are closed unheard; a request must be in within kRequestDeadline; an
// answer may stand still for kAnswerPatience, then the connection is closed; so may not a reader who takes a
// few bytes now and then, for what counts is when the answer's writing last kept up.
#pragma once

#include <httplib.h>

#include <chrono>
#include <cstddef>

namespace quickstrip {

inline constexpr std::size_t kMaxConnections = 160;
inline constexpr std::chrono::milliseconds kRequestDeadline{4000};
inline constexpr std::chrono::milliseconds kAnswerPatience{4000};
inline constexpr std::chrono::milliseconds kKeepAlive{5000};
inline constexpr int kRequestsPerConnection = 100;
inline constexpr int kSendBufferBytes = 65'536;  // in the kernel, for a reader who does not read
inline constexpr std::size_t kMaxBodyBytes = 8'192;

class BoundedServer : public httplib::Server {
 public:
  BoundedServer();

  /// After binding: cpp-httplib's five waiting connections are fewer than one page's files.
  void deepen_backlog();

 private:
  bool process_and_close_socket(socket_t sock) override;
};

}  // namespace quickstrip
