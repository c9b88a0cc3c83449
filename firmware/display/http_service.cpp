#include "firmware/display/http_service.hpp"

#include <chrono>
#include <utility>

#include "firmware/display/embedded_file.hpp"

namespace quickstrip {
namespace {

constexpr std::chrono::milliseconds kLook{250};  // how long an event stream may take to end
constexpr std::string_view kTokenPlace = "{{token}}";

std::int64_t utime_now() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

httplib::Headers security_headers() {
  return {{"Content-Security-Policy",
           "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' "
           "data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
          {"X-Content-Type-Options", "nosniff"},
          {"Referrer-Policy", "no-referrer"},
          {"Cross-Origin-Opener-Policy", "same-origin"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Cache-Control", "no-store"}};
}

RequestFacts facts_of(const httplib::Request& request) {
  RequestFacts facts;
  facts.method = request.method;
  facts.path = request.path;
  facts.host = request.get_header_value("Host");
  facts.num_hosts = request.get_header_value_count("Host");
  facts.origin = request.get_header_value("Origin");
  facts.content_type = request.get_header_value("Content-Type");
  facts.token = request.get_header_value("X-Quickstrip-Token");
  facts.fetch_site = request.get_header_value("Sec-Fetch-Site");
  return facts;
}

const EmbeddedFile* file_of(std::string_view name) {
  for (const EmbeddedFile& file : page_files()) {
    if (file.name == name) {
      return &file;
    }
  }
  return nullptr;
}

void set_json(const Answer& answer, httplib::Response& response) {
  response.status = answer.status;
  response.set_content(answer.body, "application/json");
}

}  // namespace

HttpService::HttpService(Display& display, GuardOptions guard) : display_(display), guard_(std::move(guard)) {
  server_.set_default_headers(security_headers());
  server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
    return HttpService::guard(request, response) ? httplib::Server::HandlerResponse::Unhandled
                                                 : httplib::Server::HandlerResponse::Handled;
  });
  server_.set_exception_handler([](const httplib::Request&, httplib::Response& response,
                                   const std::exception_ptr&) {  // memory: nothing of ours throws
    response.status = 500;
  });
  add_routes();
}

HttpService::~HttpService() {
  stop();
}

bool HttpService::guard(const httplib::Request& request, httplib::Response& response) const {
  if (const auto refused = refusal_of(facts_of(request), guard_)) {
    response.status = refused->status;
    response.set_content(refused->why + "\n", "text/plain; charset=utf-8");
    return false;
  }
  const std::string origin = request.get_header_value("Origin");
  if (!origin.empty() && is_foreign_but_allowed(origin, guard_)) {
    response.set_header("Access-Control-Allow-Origin", origin);
    response.set_header("Access-Control-Allow-Headers", "Content-Type, X-Quickstrip-Token");
    response.set_header("Vary", "Origin");
  }
  if (request.method == "OPTIONS") {
    response.status = 204;
    return false;
  }
  return true;
}

void HttpService::add_routes() {
  server_.Get("/", [this](const httplib::Request&, httplib::Response& response) { serve_page(response); });
  server_.Get(
      R"(/page/([a-z0-9_.-]{1,64}))", [](const httplib::Request& request, httplib::Response& response) {
        const EmbeddedFile* const file = file_of(request.matches[1].str());
        if (file == nullptr || file->name == "index.html") {
          response.status = 404;
          return;
        }
        response.set_content(file->bytes.data(), file->bytes.size(), std::string(content_type(file->name)));
      });
  server_.Get("/events",
              [this](const httplib::Request&, httplib::Response& response) { serve_events(response); });
  server_.Get(R"(/api/(beat|state|grid|trends))",
              [this](const httplib::Request& request, httplib::Response& response) {
                const std::string name = request.matches[1].str();
                for (std::size_t t = 0; t < kNumTopics; ++t) {
                  const EventHub::Frame frame = display_.hub().newest(static_cast<Topic>(t));
                  if (kTopicNames[t] == name) {
                    response.set_content(frame ? *frame : std::string("null"), "application/json");
                  }
                }
              });
  server_.Post(R"(/api/([a-z]{1,16}))", [this](const httplib::Request& request, httplib::Response& response) {
    set_json(display_.post(request.matches[1].str(), request.body, utime_now()), response);
  });
}

void HttpService::serve_page(httplib::Response& response) const {
  const EmbeddedFile* const file = file_of("index.html");
  std::string page(file == nullptr ? std::string_view() : file->bytes);
  if (const std::size_t at = page.find(kTokenPlace); at != std::string::npos) {
    page.replace(at, kTokenPlace.size(), guard_.token);
  }
  response.set_content(page, "text/html; charset=utf-8");
}

void HttpService::serve_events(httplib::Response& response) {
  if (++num_streams_ > kMaxEventStreams) {
    --num_streams_;
    response.status = 503;
    return;
  }
  auto seen = std::make_shared<EventHub::Seen>();
  response.set_chunked_content_provider(
      "text/event-stream",
      [this, seen](std::size_t, httplib::DataSink& sink) {
        const std::string text = display_.hub().next(*seen, kLook);
        if (display_.hub().is_closed() || !sink.is_writable()) {
          return false;
        }
        return text.empty() || sink.write(text.data(), text.size());
      },
      [this](bool) { --num_streams_; });
}

bool HttpService::start(const std::string& address, int port) {
  if (port == 0) {
    guard_.port = server_.bind_to_any_port(address);
    if (guard_.port <= 0) {
      return false;
    }
  } else {
    guard_.port = port;
    if (!server_.bind_to_port(address, port)) {
      return false;
    }
  }
  server_.deepen_backlog();
  thread_ = std::thread([this] { server_.listen_after_bind(); });
  while (!server_.is_running()) {
    std::this_thread::yield();
  }
  return true;
}

void HttpService::stop() {
  display_.hub().close();
  if (thread_.joinable()) {
    server_.stop();
    thread_.join();
  }
}

}  // namespace quickstrip
