// Who may ask what. A page of another origin, or a name that points at this machine (DNS rebinding), gets
// nothing; an entry needs this page's own origin, JSON, and the token that only a page of this start knows.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace quickstrip {

struct GuardOptions {
  int port = 0;
  std::vector<std::string> hosts;    // allowed beside the loopback's names; with or without a port
  std::vector<std::string> origins;  // allowed beside http://HOST of those; "http://bridge2:8042"
  std::string token;                 // of this start
};

/// What the guard looks at; a header that is absent is empty.
struct RequestFacts {
  std::string method;
  std::string path;
  std::string host;
  std::size_t num_hosts = 1;  // Host headers: more than one is refused
  std::string origin;
  std::string content_type;
  std::string token;
  std::string fetch_site;  // Sec-Fetch-Site
};

struct Refused {
  int status = 403;
  std::string why;
};

/// Nothing when the request may pass.
std::optional<Refused> refusal_of(const RequestFacts& request, const GuardOptions& options);

/// True for another origin that an option allows: it needs the headers of CORS.
bool is_foreign_but_allowed(const std::string& origin, const GuardOptions& options);

/// 128 bits of the system's randomness in hexadecimal.
std::string random_token();

/// Equal, in a time that does not tell where they differ.
bool is_same_secret(const std::string& a, const std::string& b);

}  // namespace quickstrip
