// Who may ask what, without sockets.
#include "firmware/display/request_guard.hpp"

#include <gtest/gtest.h>

namespace quickstrip {
namespace {

GuardOptions options() {
  return {8042, {}, {}, "secret"};
}

RequestFacts entry() {
  return {.method = "POST",
          .path = "/api/sea",
          .host = "127.0.0.1:8042",
          .num_hosts = 1,
          .origin = "http://127.0.0.1:8042",
          .content_type = "application/json",
          .token = "secret",
          .fetch_site = "same-origin"};
}

RequestFacts page() {
  RequestFacts facts;
  facts.method = "GET";
  facts.path = std::string(1, '/');
  facts.host = "localhost:8042";
  return facts;
}

int status(const RequestFacts& request, const GuardOptions& with = options()) {
  const auto refused = refusal_of(request, with);
  return refused ? refused->status : 200;
}

TEST(RequestGuard, LetsThePageAndAnEntryOfItsOwnThrough) {
  EXPECT_EQ(status(page()), 200);
  EXPECT_EQ(status(entry()), 200);
  RequestFacts with_charset = entry();
  with_charset.content_type = "application/json; charset=utf-8";
  EXPECT_EQ(status(with_charset), 200);
}

TEST(RequestGuard, RefusesAnotherHostNameWhichIsDnsRebinding) {
  for (const char* const host : {"evil.example:8042", "evil.example", "127.0.0.1:9999", "127.0.0.1", "",
                                 "127.0.0.1:8042.evil.example", "localhost.evil.example:8042"}) {
    RequestFacts request = page();
    request.host = host;
    EXPECT_EQ(status(request), 403) << host;
  }
  RequestFacts twice = page();
  twice.num_hosts = 2;
  EXPECT_EQ(status(twice), 403);
}

TEST(RequestGuard, TakesAHostThatAnOptionNames) {
  GuardOptions with = options();
  with.hosts = {"bridge2"};
  RequestFacts request = page();
  request.host = "bridge2:8042";
  EXPECT_EQ(status(request, with), 200);
  request.host = "bridge3:8042";
  EXPECT_EQ(status(request, with), 403);
}

TEST(RequestGuard, RefusesAnotherOriginEvenForReading) {
  RequestFacts request = page();
  request.path = "/events";
  request.origin = "http://evil.example";
  EXPECT_EQ(status(request), 403);
  request.origin = "null";  // a sandboxed frame, a file
  EXPECT_EQ(status(request), 403);
  request.origin = "http://localhost:8042";
  EXPECT_EQ(status(request), 200);
  request.origin = "https://localhost:8042";
  EXPECT_EQ(status(request), 403);
}

TEST(RequestGuard, TakesAnOriginThatAnOptionNames) {
  GuardOptions with = options();
  with.origins = {"http://bridge2:9000"};
  RequestFacts request = entry();
  request.origin = "http://bridge2:9000";
  request.fetch_site = "cross-site";
  EXPECT_EQ(status(request, with), 200);
  EXPECT_EQ(status(request), 403);
}

TEST(RequestGuard, RefusesWhatAPageOfAnotherSiteAsksForWithoutAnOrigin) {
  RequestFacts image = page();
  image.path = "/api/state";
  image.fetch_site = "cross-site";
  EXPECT_EQ(status(image), 403);
  RequestFacts link = page();
  link.fetch_site = "cross-site";  // a link to the page itself shows nothing to the other site
  EXPECT_EQ(status(link), 200);
}

TEST(RequestGuard, AnEntryNeedsOriginJsonAndToken) {
  RequestFacts no_origin = entry();
  no_origin.origin = "";
  EXPECT_EQ(status(no_origin), 403);
  RequestFacts form = entry();
  form.content_type = "text/plain";  // what a foreign page may send without asking
  EXPECT_EQ(status(form), 415);
  RequestFacts no_token = entry();
  no_token.token = "";
  EXPECT_EQ(status(no_token), 403);
  RequestFacts longer = entry();
  longer.token = "secretsecret";
  EXPECT_EQ(status(longer), 403);
  RequestFacts put = entry();
  put.method = "PUT";
  EXPECT_EQ(status(put), 405);
}

TEST(RequestGuard, TokensDiffer) {
  EXPECT_EQ(random_token().size(), 32U);
  EXPECT_NE(random_token(), random_token());
}

}  // namespace
}  // namespace quickstrip
