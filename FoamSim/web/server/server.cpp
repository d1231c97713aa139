#include "FoamSim/web/server/server.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <random>

#include "Base/error.h"

namespace foamsim::web {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::size_t most_connections = 64, longest_head = 8192;
constexpr std::chrono::seconds patience{30};
constexpr std::chrono::milliseconds between_questions{100};

std::string random_token() {
  constexpr std::string_view digits = "0123456789abcdef";
  std::random_device source;
  std::string token;
  while (token.size() < 32) {
    const unsigned bits = source();
    for (unsigned shift = 0; shift < 32; shift += 4) token += digits[(bits >> shift) & 15U];
  }
  return token;
}

// What all connections of a server share.
struct Service {
  Service(RequestCheck requests, Server::Answer answers) : check(std::move(requests)), answer(std::move(answers)) {}
  RequestCheck check;
  Server::Answer answer;
  std::size_t connections = 0;
};

WebRequest read_request(const http::request<http::empty_body>& from) {
  const auto text = [](boost::string_view view) { return std::string(view.data(), view.size()); };
  // Two hosts or origins: neither is believed.
  const auto header = [&](boost::string_view name) {
    return from.count(name) > 1 ? std::string("several") : text(from[name]);
  };
  return {text(from.method_string()), text(from.target()), header("Host"), header("Origin"), header("Sec-Fetch-Site")};
}

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(tcp::socket socket, Service& service) : stream_(std::move(socket)), service_(service) {
    ++service_.connections;
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() { --service_.connections; }

  void read() {
    parser_.emplace();
    parser_->header_limit(longest_head);
    parser_->body_limit(0);
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](error_code error, std::size_t) {
      if (!error) self->respond();
    });
  }

 private:
  void respond() {
    const http::request<http::empty_body>& asked = parser_->get();
    const WebRequest request = read_request(asked);
    WebAnswer answer = service_.check.judge(request);
    if (answer.status == 200) answer = service_.answer(service_.check.path(request));
    response_ = {};
    response_.version(11);
    response_.result(static_cast<unsigned>(answer.status));
    response_.set(http::field::content_type, answer.type);
    response_.set(http::field::cache_control, "no-store");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("X-Frame-Options", "DENY");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set("Cross-Origin-Resource-Policy", "same-origin");
    response_.set("Content-Security-Policy", "frame-ancestors 'none'");
    if (answer.status == 405) response_.set(http::field::allow, "GET");
    response_.keep_alive(answer.status == 200 && asked.keep_alive());
    response_.body() = std::move(answer.body);
    response_.prepare_payload();
    stream_.expires_after(patience);
    http::async_write(stream_, response_, [self = shared_from_this()](error_code error, std::size_t) {
      if (!error && self->response_.keep_alive()) {
        self->read();
        return;
      }
      error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  beast::tcp_stream stream_;
  Service& service_;
  beast::flat_buffer buffer_{longest_head + 1024};
  std::optional<http::request_parser<http::empty_body>> parser_;
  http::response<http::string_body> response_;
};

}  // namespace

struct Server::Parts {
  explicit Parts(unsigned short wanted) : acceptor(context), timer(context) {
    const tcp::endpoint here(asio::ip::address_v4::loopback(), wanted);
    error_code error;
    acceptor.open(here.protocol(), error);
    if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor.bind(here, error);
    if (!error) acceptor.listen(16, error);
    if (error == asio::error::address_in_use)
      throw base::InputError("port " + std::to_string(wanted) +
                             " of 127.0.0.1 is in use; take another, or 0 for a free one");
    if (error)
      throw base::InputError("cannot open port " + std::to_string(wanted) + " of 127.0.0.1: " + error.message());
    token = random_token();
  }

  void accept() {
    accepting = true;
    acceptor.async_accept([this](error_code error, tcp::socket socket) {
      accepting = false;
      if (!error && service->connections < most_connections)
        std::make_shared<Connection>(std::move(socket), *service)->read();
      // Where the system has no sockets left, `ask` takes it up again.
      if (!error) accept();
    });
  }

  void ask(const std::function<bool()>& stop) {
    if (stop()) {
      context.stop();
      return;
    }
    if (!accepting) accept();
    timer.expires_after(between_questions);
    timer.async_wait([this, &stop](error_code error) {
      if (!error) ask(stop);
    });
  }

  std::unique_ptr<Service> service;  // outlives the connections, which the context holds
  asio::io_context context{1};
  tcp::acceptor acceptor;
  asio::steady_timer timer;
  std::string token;
  bool accepting = false;
};

Server::Server(const ServerOptions& options, Answer answer) : parts_(std::make_unique<Parts>(options.port)) {
  parts_->service = std::make_unique<Service>(RequestCheck(port(), parts_->token), std::move(answer));
}

Server::~Server() = default;

unsigned short Server::port() const {
  return parts_->acceptor.local_endpoint().port();
}

std::string Server::address() const {
  return "http://127.0.0.1:" + std::to_string(port()) + "/" + parts_->token + "/";
}

void Server::run(const std::function<bool()>& stop) {
  parts_->ask(stop);
  parts_->context.run();
}

}  // namespace foamsim::web
