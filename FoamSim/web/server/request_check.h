#pragma once

#include <string>
#include <string_view>

namespace foamsim::web {

/// What a server of a run is asked, as far as it looks at it.
struct WebRequest {
  std::string method, target;  ///< GET, /TOKEN/run.json
  std::string host, origin;    ///< headers; empty where they are not given
  std::string fetch_site;      ///< Sec-Fetch-Site
};

/// What it answers.
struct WebAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
};

/// Whether a request may be answered at all: it comes from this machine's own browser, for this server's own page.
class RequestCheck {
 public:
  /// `token`: the secret first part of all paths.
  RequestCheck(unsigned short port, std::string token) : port_(port), token_(std::move(token)) {}

  /// 405 for another method than GET, 403 for another host, an origin or a site that is not the server's own, 404 for a
  /// path without the token; 200 otherwise. A host name that only leads here (DNS rebinding) is another host.
  WebAnswer judge(const WebRequest& request) const;
  /// What stands behind "/TOKEN/" in the target of a request that passed, without its query.
  std::string path(const WebRequest& request) const;

 private:
  bool is_own(std::string_view authority) const;

  unsigned short port_;
  std::string token_;
};

}  // namespace foamsim::web
