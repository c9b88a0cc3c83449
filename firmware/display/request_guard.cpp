#include "firmware/display/request_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace quickstrip {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

bool is_allowed_host(const std::string& host, const GuardOptions& options) {
  const std::string asked = lower(host);
  const std::string port = fmt::format(":{}", options.port);
  for (const char* const name : {"127.0.0.1", "localhost", "[::1]"}) {
    if (asked == name + port || (options.port == 80 && asked == name)) {
      return true;
    }
  }
  return std::any_of(options.hosts.begin(), options.hosts.end(), [&](const std::string& allowed) {
    return asked == lower(allowed) || asked == lower(allowed) + port;
  });
}

bool is_own_origin(const std::string& origin, const std::string& host) {
  return lower(origin) == "http://" + lower(host);
}

bool is_allowed_origin(const std::string& origin, const std::string& host, const GuardOptions& options) {
  return is_own_origin(origin, host) || is_foreign_but_allowed(origin, options);
}

bool is_json(const std::string& content_type) {
  const std::string type = lower(content_type.substr(0, content_type.find(';')));
  return type.substr(0, type.find(' ')) == "application/json";
}

}  // namespace

bool is_foreign_but_allowed(const std::string& origin, const GuardOptions& options) {
  return std::any_of(options.origins.begin(), options.origins.end(),
                     [&](const std::string& allowed) { return lower(origin) == lower(allowed); });
}

bool is_same_secret(const std::string& a, const std::string& b) {
  unsigned int different = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    different |= static_cast<unsigned int>(a[i] ^ b[i]);
  }
  return different == 0U;
}

std::optional<Refused> refusal_of(const RequestFacts& request, const GuardOptions& options) {
  if (request.num_hosts != 1 || !is_allowed_host(request.host, options)) {
    return Refused{403, "this display does not answer to that host name (option --allow-host)"};
  }
  if (!request.origin.empty() && !is_allowed_origin(request.origin, request.host, options)) {
    return Refused{403, "another origin (option --allow-origin)"};
  }
  const bool is_page = request.path == "/";
  const bool is_cross = request.fetch_site == "cross-site" || request.fetch_site == "same-site";
  if (is_cross && !is_page && !is_foreign_but_allowed(request.origin, options)) {
    return Refused{403, "asked for by a page of another site"};
  }
  if (request.method == "GET" || request.method == "HEAD" || request.method == "OPTIONS") {
    return std::nullopt;
  }
  if (request.method != "POST") {
    return Refused{405, "only GET and POST"};
  }
  if (request.origin.empty()) {
    return Refused{403, "an entry comes from the display's own page: the header Origin is missing"};
  }
  if (!is_json(request.content_type)) {
    return Refused{415, "an entry is application/json"};
  }
  if (!is_same_secret(request.token, options.token)) {
    return Refused{403, "the page is of an earlier start of the display: load it again"};
  }
  return std::nullopt;
}

std::string random_token() {
  std::random_device device;
  std::string token;
  for (int i = 0; i < 4; ++i) {
    token += fmt::format("{:08x}", device());
  }
  return token;
}

}  // namespace quickstrip
