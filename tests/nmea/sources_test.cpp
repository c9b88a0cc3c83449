// Real sockets and a real (pseudo) terminal.
#include "firmware/nmea/source.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <pty.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include "firmware/nmea/run.hpp"
#include "tests/nmea/support.hpp"
#include "tests/support/heap_guard.hpp"

namespace quickstrip::nmea {
namespace {

using test::kNow;
using test::sealed;

SourceSpec udp(const std::string& where) {
  return {SourceKind::kUdp, where, "", 4800};
}

/// A port that is free now.
int free_port() {
  const int fd = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in own{};
  own.sin_family = AF_INET;
  own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(own);
  EXPECT_EQ(bind(fd, reinterpret_cast<const sockaddr*>(&own), size), 0);
  EXPECT_EQ(getsockname(fd, reinterpret_cast<sockaddr*>(&own), &size), 0);
  close(fd);
  return ntohs(own.sin_port);
}

class Sender {
 public:
  explicit Sender(int port) : fd_(socket(AF_INET, SOCK_DGRAM, 0)) {
    to_.sin_family = AF_INET;
    to_.sin_port = htons(static_cast<std::uint16_t>(port));
    to_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  }
  Sender(const Sender&) = delete;
  Sender& operator=(const Sender&) = delete;
  ~Sender() { close(fd_); }
  void send(std::string_view bytes) const {
    EXPECT_EQ(
        sendto(fd_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to_), sizeof(to_)),
        static_cast<ssize_t>(bytes.size()));
  }

 private:
  int fd_;
  sockaddr_in to_{};
};

TEST(NmeaSources, AFloodOfDatagramsStopsNoGoodOneAndTakesNoMemory) {
  const int port = free_port();
  Source source(udp(std::to_string(port) + "@127.0.0.1"));
  ASSERT_TRUE(source.open());
  test::KeepingSink sink;
  Gateway gateway(test::gateway_options(), 1, sink);
  const Sender sender(port);
  const std::string bad = "$INVTG,215.11,T,239.79,M,9.1,N,16.9,K,A*06\r\n";
  const std::string empty;
  const std::string binary("\0\xFF\x80$$$***\\\\\n\n\r", 13);
  const std::string good = sealed("HEHDT,100.0,T") + "\r\n" + sealed("VWVHW,,,,,8.0,N,,") + "\r\n";
  const quickstrip::test::HeapGuard guard;
  for (int turn = 0; turn < 300; ++turn) {  // 30,000 bad ones, 100 between two looks
    for (int i = 0; i < 99; ++i) {
      sender.send(i % 10 == 0 ? binary : bad);
    }
    sender.send(empty);
    sender.send(good);
    source.read(0, kNow + turn, gateway);
    gateway.turn(kNow + turn);
  }
  EXPECT_EQ(guard.allocations(), 0U);
  EXPECT_EQ(gateway.counts().lines.of(Fate::kTaken), 600);
  EXPECT_EQ(gateway.counts().lines.of(Fate::kBadChecksum), 300 * 89);
  EXPECT_EQ(sink.count(Channel::kOwnShip), 1);  // once a second, and no second has gone by
}

TEST(NmeaSources, ASerialLineIsReadRawAndItsLossIsSurvived) {
  int master = -1;
  int slave = -1;
  char name[128] = {};
  if (openpty(&master, &slave, name, nullptr, nullptr) != 0) {
    GTEST_SKIP() << "no pseudo terminal here";
  }
  Source source({SourceKind::kSerial, std::string(name) + "@38400", "", 4800});
  ASSERT_TRUE(source.open());
  termios line{};
  ASSERT_EQ(tcgetattr(slave, &line), 0);
  EXPECT_EQ(cfgetispeed(&line), static_cast<speed_t>(B38400));
  EXPECT_EQ(line.c_lflag & static_cast<tcflag_t>(ICANON | ECHO), 0U);
  test::KeepingSink sink;
  Gateway gateway(test::gateway_options(), 1, sink);
  source.read(0, kNow, gateway);  // nothing there: does not wait, does not end
  const std::string bytes = sealed("HEHDT,100.0,T") + "\r\n$HEHD";
  ASSERT_EQ(write(master, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  source.read(0, kNow, gateway);
  EXPECT_EQ(gateway.counts().lines.of(Fate::kTaken), 1);
  close(slave);
  close(master);  // the adapter is pulled out
  source.read(0, kNow, gateway);
  EXPECT_LT(source.fd(), 0);
  EXPECT_FALSE(source.has_ended());
  source.mend(kNow + 3'000'000);  // still away: said once, tried again
  EXPECT_LT(source.fd(), 0);
  source.read(0, kNow, gateway);
}

TEST(NmeaSources, WhatCannotBeOpenedSaysWhatWouldBeRight) {
  for (const char* where : {"", "0", "65536", "x", "5000@", "5000@host", "-1", "60001@300.1.1.1"}) {
    const FileStatus status = Source(udp(where)).open();
    EXPECT_EQ(bool(status), std::string(where) == "5000@") << where;  // no address: any
  }
  EXPECT_FALSE(Source({SourceKind::kSerial, "/dev/null", "", 4800}).open());  // no terminal
  EXPECT_FALSE(Source({SourceKind::kSerial, "/dev/null@1234", "", 4800}).open());
  EXPECT_FALSE(Source({SourceKind::kFile, "/nowhere/at/all", "", 4800}).open());
}

}  // namespace
}  // namespace quickstrip::nmea
