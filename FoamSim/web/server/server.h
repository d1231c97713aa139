#pragma once

#include <functional>
#include <memory>
#include <string>

#include "FoamSim/web/server/request_check.h"

namespace foamsim::web {

struct ServerOptions {
  unsigned short port = 0;  ///< 0: one that is free
};

/// Serves answers over HTTP/1.1 on 127.0.0.1, and on no other address, until it is told to stop. Requests are taken one
/// by one, GET only, with heads of at most 8 kB and no body; connections, at most 64, are closed when nothing comes for
/// 30 seconds.
class Server {
 public:
  /// Answers a path behind the token.
  using Answer = std::function<WebAnswer(const std::string& path)>;

  /// Opens the port. Throws base::InputError where it is in use or not permitted.
  Server(const ServerOptions& options, Answer answer);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  unsigned short port() const;
  /// "http://127.0.0.1:PORT/TOKEN/", with a token of 128 random bits.
  std::string address() const;

  /// Serves; `stop` is asked ten times a second.
  void run(const std::function<bool()>& stop);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace foamsim::web
