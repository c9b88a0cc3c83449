#include "firmware/display/bounded_server.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

namespace quickstrip {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kLook{200};  // how long a stop may take

bool wait_for(socket_t sock, short events, Clock::time_point until) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
  pollfd waited{sock, events, 0};
  const int ready = poll(&waited, 1, static_cast<int>(std::max<decltype(left)>(0, left)));
  return ready > 0 && (waited.revents & (events | POLLHUP)) != 0;
}

void address_of(const sockaddr_storage& storage, socklen_t length, std::string& ip, int& port) {
  char host[NI_MAXHOST] = {};
  char service[NI_MAXSERV] = {};
  const auto* const address = reinterpret_cast<const sockaddr*>(&storage);
  if (getnameinfo(address, length, host, sizeof(host), service, sizeof(service),
                  NI_NUMERICHOST | NI_NUMERICSERV) == 0) {
    ip = host;
    port = std::atoi(service);  // NOLINT(cert-err34-c): getnameinfo wrote digits
  }
}

/// A connection with deadlines: of the request from its first byte, of the answer while it stands still.
class DeadlineStream : public httplib::Stream {
 public:
  explicit DeadlineStream(socket_t sock) : sock_(sock) {}

  /// False when none comes within kKeepAlive, or `goes_on` has become false.
  template <typename GoesOn>
  [[nodiscard]] bool wait_for_request(const GoesOn& goes_on) {
    const Clock::time_point until = Clock::now() + kKeepAlive;
    bool has_come = next_ < filled_;  // of a request that came with the one before
    while (!has_come && goes_on() && Clock::now() < until) {
      has_come = wait_for(sock_, POLLIN, Clock::now() + kLook);
    }
    request_until_ = Clock::now() + kRequestDeadline;
    is_behind_ = false;
    return has_come;
  }

  [[nodiscard]] bool is_readable() const override { return wait_for(sock_, POLLIN, request_until_); }
  [[nodiscard]] bool is_writable() const override {
    char byte = 0;  // a reader who has gone is found here, not by the next write
    const ssize_t peeked = recv(sock_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    return peeked > 0 || (peeked < 0 && (errno == EAGAIN || errno == EWOULDBLOCK));
  }
  ssize_t read(char* bytes, size_t size) override {
    if (next_ == filled_) {
      if (!wait_for(sock_, POLLIN, request_until_)) {
        return -1;
      }
      const ssize_t got = recv(sock_, buffer_, sizeof(buffer_), 0);
      if (got <= 0) {
        return got;
      }
      next_ = 0;
      filled_ = static_cast<std::size_t>(got);
    }
    const std::size_t taken = std::min(size, filled_ - next_);
    std::copy_n(buffer_ + next_, taken, bytes);
    next_ += taken;
    return static_cast<ssize_t>(taken);
  }
  ssize_t write(const char* bytes, size_t size) override {
    ssize_t sent = send(sock_, bytes, size, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent == static_cast<ssize_t>(size)) {
      is_behind_ = false;
      return sent;
    }
    if (sent >= 0) {
      begin_patience();
      return sent;
    }
    if (errno != EAGAIN && errno != EWOULDBLOCK) {
      return -1;
    }
    begin_patience();
    if (!wait_for(sock_, POLLOUT, answer_until_)) {
      return -1;
    }
    sent = send(sock_, bytes, size, MSG_DONTWAIT | MSG_NOSIGNAL);
    return sent > 0 ? sent : -1;
  }
  void get_remote_ip_and_port(std::string& ip, int& port) const override {
    sockaddr_storage storage{};
    socklen_t length = sizeof(storage);
    if (getpeername(sock_, reinterpret_cast<sockaddr*>(&storage), &length) == 0) {
      address_of(storage, length, ip, port);
    }
  }
  void get_local_ip_and_port(std::string& ip, int& port) const override {
    sockaddr_storage storage{};
    socklen_t length = sizeof(storage);
    if (getsockname(sock_, reinterpret_cast<sockaddr*>(&storage), &length) == 0) {
      address_of(storage, length, ip, port);
    }
  }
  [[nodiscard]] socket_t socket() const override { return sock_; }

 private:
  void begin_patience() {
    if (!is_behind_) {
      is_behind_ = true;
      answer_until_ = Clock::now() + kAnswerPatience;
    }
  }

  socket_t sock_;
  Clock::time_point request_until_;
  Clock::time_point answer_until_;
  bool is_behind_ = false;
  char buffer_[4096] = {};
  std::size_t next_ = 0;
  std::size_t filled_ = 0;
};

thread_local bool is_refused = false;  // of the connection that this thread has been given

/// A thread a connection, up to kMaxConnections; further ones are closed by the accepting thread.
class ConnectionThreads : public httplib::TaskQueue {
  using Enqueued = decltype(std::declval<httplib::TaskQueue&>().enqueue({}));  // void, or bool in newer ones

 public:
  Enqueued enqueue(std::function<void()> serve) override {
    if (num_running_->load() >= kMaxConnections) {
      is_refused = true;
      serve();
      is_refused = false;
      return static_cast<Enqueued>(true);
    }
    ++*num_running_;
    std::thread([serve = std::move(serve), running = num_running_] {
      serve();
      --*running;
      running->notify_all();
    }).detach();
    return static_cast<Enqueued>(true);
  }
  void shutdown() override {
    for (std::size_t left = num_running_->load(); left > 0; left = num_running_->load()) {
      num_running_->wait(left);  // every connection has its deadlines
    }
  }

 private:
  std::shared_ptr<std::atomic<std::size_t>> num_running_ = std::make_shared<std::atomic<std::size_t>>(0);
};

}  // namespace

BoundedServer::BoundedServer() {
  new_task_queue = [] { return new ConnectionThreads; };  // cpp-httplib deletes it
  set_payload_max_length(kMaxBodyBytes);
  set_tcp_nodelay(true);
  set_socket_options([](socket_t sock) {  // of the listening socket; the connections inherit them
    const int yes = 1;
    setsockopt(sock, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
    setsockopt(sock, SOL_SOCKET, SO_SNDBUF, &kSendBufferBytes, sizeof(kSendBufferBytes));
    fcntl(sock, F_SETFD, FD_CLOEXEC);
  });
}

void BoundedServer::deepen_backlog() {
  ::listen(svr_sock_, static_cast<int>(kMaxConnections));
}

bool BoundedServer::process_and_close_socket(socket_t sock) {
  bool is_well = !is_refused;
  const auto stream = std::make_unique<DeadlineStream>(sock);
  for (int left = kRequestsPerConnection; is_well && left > 0 && svr_sock_ != INVALID_SOCKET; --left) {
    if (!stream->wait_for_request([this] { return svr_sock_ != INVALID_SOCKET; })) {
      break;
    }
    bool is_closed = false;
    is_well = process_request(*stream, left == 1, is_closed, nullptr) && !is_closed;
  }
  shutdown(sock, SHUT_RDWR);
  close(sock);
  return is_well;
}

}  // namespace quickstrip
