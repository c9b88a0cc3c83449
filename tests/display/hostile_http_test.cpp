// Browsers that lie, crawl or never read; the good one's frames go on.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/display/bridge.hpp"

namespace quickstrip {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Clock = std::chrono::steady_clock;

/// A connection without manners.
class Raw {
 public:
  explicit Raw(int port) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int small = 4096;
    setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &small, sizeof(small));
    is_open_ = connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  }
  ~Raw() { close(socket_); }
  Raw(const Raw&) = delete;
  Raw& operator=(const Raw&) = delete;

  bool say(const std::string& text) {
    return is_open_ &&
           send(socket_, text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size());
  }
  /// Up to the end of the connection or the patience.
  std::string hear(milliseconds patience) {
    std::string heard;
    const auto until = Clock::now() + patience;
    while (Clock::now() < until) {
      pollfd waited{socket_, POLLIN, 0};
      char bytes[4096];
      if (poll(&waited, 1, 50) > 0) {
        const ssize_t got = recv(socket_, bytes, sizeof(bytes), 0);
        if (got <= 0) {
          has_ended_ = true;
          return heard;
        }
        heard.append(bytes, static_cast<std::size_t>(got));
      }
    }
    return heard;
  }
  [[nodiscard]] bool has_ended() const { return has_ended_; }

 private:
  int socket_;
  bool is_open_ = false;
  bool has_ended_ = false;
};

int status_of(const std::string& answer) {
  return answer.size() > 12 ? std::stoi(answer.substr(9, 3)) : 0;
}

std::string host_of(const test::Bridge& bridge) {
  return "Host: 127.0.0.1:" + std::to_string(bridge.port()) + "\r\n";
}

int ask(test::Bridge& bridge, const std::string& head, const std::string& body = "") {
  Raw raw(bridge.port());
  raw.say(head + "Connection: close\r\n\r\n" + body);
  return status_of(raw.hear(seconds(3)));
}

TEST(HostileHttp, PageIsServedWithItsPolicyAndNothingFromElsewhere) {
  test::Bridge bridge;
  Raw raw(bridge.port());
  raw.say("GET / HTTP/1.1\r\n" + host_of(bridge) + "Connection: close\r\n\r\n");
  const std::string page = raw.hear(seconds(3));
  EXPECT_EQ(status_of(page), 200);
  EXPECT_NE(page.find("Content-Security-Policy: default-src 'none'"), std::string::npos);
  EXPECT_NE(page.find(bridge.token()), std::string::npos);
  EXPECT_NE(page.find("not a substitute for good seamanship"), std::string::npos);
  EXPECT_EQ(page.find("https://"), std::string::npos);
}

TEST(HostileHttp, OtherHostsAndOriginsGetNothing) {
  test::Bridge bridge;
  const std::string host = host_of(bridge);
  EXPECT_EQ(ask(bridge, "GET / HTTP/1.1\r\nHost: evil.example\r\n"), 403);
  EXPECT_EQ(ask(bridge, "GET / HTTP/1.1\r\n"), 403);
  EXPECT_EQ(ask(bridge, "GET /events HTTP/1.1\r\n" + host + "Origin: http://evil.example\r\n"), 403);
  EXPECT_EQ(ask(bridge, "GET /api/state HTTP/1.1\r\n" + host + "Sec-Fetch-Site: cross-site\r\n"), 403);
  const std::string body = R"({"author":"x","text":"y"})";
  const std::string length = "Content-Length: " + std::to_string(body.size()) + "\r\n";
  const std::string mark = "POST /api/mark HTTP/1.1\r\n" + host + length;
  const std::string own = "Origin: http://127.0.0.1:" + std::to_string(bridge.port()) + "\r\n";
  const std::string json = "Content-Type: application/json\r\n";
  const std::string token = "X-Quickstrip-Token: " + bridge.token() + "\r\n";
  EXPECT_EQ(ask(bridge, mark + json + token, body), 403);
  EXPECT_EQ(ask(bridge, mark + own + json, body), 403);
  EXPECT_EQ(ask(bridge, mark + own + token + "Content-Type: text/plain\r\n", body), 415);
  EXPECT_EQ(ask(bridge, mark + "Origin: http://evil.example\r\n" + json + token, body), 403);
  EXPECT_EQ(bridge.num_sent("LOGBOOK"), 0U);
  EXPECT_EQ(ask(bridge, mark + own + json + token, body), 200);
  EXPECT_EQ(bridge.num_sent("LOGBOOK"), 1U);
}

TEST(HostileHttp, MalformedAndOversizedRequestsAreRefusedAndTheServerGoesOn) {
  test::Bridge bridge;
  const std::string host = host_of(bridge);
  const std::string own = "Origin: http://127.0.0.1:" + std::to_string(bridge.port()) +
                          "\r\nContent-Type: application/json\r\nX-Quickstrip-Token: " + bridge.token() +
                          "\r\n";
  EXPECT_EQ(ask(bridge, "POST /api/sea HTTP/1.1\r\n" + host + own + "Content-Length: 9000\r\n",
                std::string(9000, ' ')),
            413);
  EXPECT_EQ(ask(bridge, "POST /api/sea HTTP/1.1\r\n" + host + own + "Content-Length: 3\r\n", "{]}"), 422);
  EXPECT_EQ(ask(bridge, "GET /page/../main.cpp HTTP/1.1\r\n" + host), 404);
  EXPECT_EQ(ask(bridge, "GET /page/%2e%2e%2f%2e%2e%2fetc%2fpasswd HTTP/1.1\r\n" + host), 404);
  EXPECT_EQ(ask(bridge, "DELETE / HTTP/1.1\r\n" + host), 405);
  const std::string broken[] = {
      "\r\n\r\n",
      "GET\r\n\r\n",
      "GET / HTTP/9.9\r\n\r\n",
      std::string(100, '\0') + "\r\n\r\n",
      "GET /" + std::string(20'000, 'a') + " HTTP/1.1\r\n" + host + "\r\n",
      "GET / HTTP/1.1\r\nA" + std::string(20'000, 'b') + ": c\r\n\r\n",
      "GET / HTTP/1.1\r\n" + host + "Range: bytes=9-1,-,5-99999999999999999999\r\n\r\n",
      "POST /api/sea HTTP/1.1\r\n" + host + own + "Transfer-Encoding: chunked\r\n\r\nzz\r\n",
      "POST /api/sea HTTP/1.1\r\n" + host + own + "Content-Length: 99999999999999999999\r\n\r\nx"};
  for (const std::string& text : broken) {
    Raw raw(bridge.port());
    raw.say(text);
    const int status = status_of(raw.hear(milliseconds(600)));
    EXPECT_TRUE(status == 0 || status >= 400) << text.substr(0, 60) << " " << status;
  }
  EXPECT_EQ(ask(bridge, "GET / HTTP/1.1\r\n" + host), 200);
}

TEST(HostileHttp, ARequestThatDripsInIsCutOff) {
  test::Bridge bridge;
  Raw raw(bridge.port());
  const auto start = Clock::now();
  raw.say("GET / HT");
  while (!raw.has_ended() && Clock::now() - start < seconds(10)) {
    raw.say("T");
    raw.hear(milliseconds(500));
  }
  EXPECT_TRUE(raw.has_ended());
  EXPECT_LT(Clock::now() - start, kRequestDeadline + seconds(2));
}

// 64 that open the stream and never read; one that reads: its beats keep coming, the turn of the display
// (which takes the bus's messages) keeps its pace, and the 64 are thrown out.
TEST(HostileHttp, SixtyFourReadersWhoNeverReadHoldUpNobody) {
  test::Bridge bridge;
  const std::string events = "GET /events HTTP/1.1\r\n" + host_of(bridge) + "\r\n";
  std::vector<std::unique_ptr<Raw>> slow;
  for (int i = 0; i < 64; ++i) {
    slow.push_back(std::make_unique<Raw>(bridge.port()));
    ASSERT_TRUE(slow.back()->say(events));
  }
  const auto until = Clock::now() + seconds(5);
  while (bridge.service().num_event_streams() < 64 && Clock::now() < until) {
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_EQ(bridge.service().num_event_streams(), 64);
  Raw good(bridge.port());
  ASSERT_TRUE(good.say(events));
  const int turns_before = bridge.num_turns;
  std::size_t beats = 0;
  std::size_t longest_gap_ms = 0;
  auto last = Clock::now();
  for (const auto end = Clock::now() + seconds(6); Clock::now() < end;) {
    const std::string heard = good.hear(milliseconds(100));
    for (std::size_t at = heard.find("event: beat"); at != std::string::npos;
         at = heard.find("event: beat", at + 1)) {
      ++beats;
      const auto gap = std::chrono::duration_cast<milliseconds>(Clock::now() - last).count();
      longest_gap_ms = std::max(longest_gap_ms, static_cast<std::size_t>(gap));
      last = Clock::now();
    }
  }
  EXPECT_GE(beats, 10U);             // advice four times a second, each with a beat
  EXPECT_LT(longest_gap_ms, 1500U);  // of a machine that does much else beside
  EXPECT_GE(bridge.num_turns - turns_before, 20);
  EXPECT_EQ(bridge.service().num_event_streams(), 1);  // the slow ones are gone
}

}  // namespace
}  // namespace quickstrip
