#include "FoamSim/web/server/request_check.h"

namespace foamsim::web {
namespace {

// Takes as long wherever the first difference is.
bool same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned char difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference =
        static_cast<unsigned char>(difference | (static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i])));
  return difference == 0;
}

}  // namespace

bool RequestCheck::is_own(std::string_view authority) const {
  const std::string port = ":" + std::to_string(port_);
  return authority == "127.0.0.1" + port || authority == "localhost" + port;
}

WebAnswer RequestCheck::judge(const WebRequest& request) const {
  if (request.method != "GET") return {405, "text/plain; charset=utf-8", "only GET is answered\n"};
  if (!is_own(request.host)) return {403, "text/plain; charset=utf-8", "this server answers to 127.0.0.1 only\n"};
  constexpr std::string_view scheme = "http://";
  const bool own_origin = request.origin.empty() || (request.origin.starts_with(scheme) &&
                                                     is_own(std::string_view(request.origin).substr(scheme.size())));
  const bool own_site =
      request.fetch_site.empty() || request.fetch_site == "same-origin" || request.fetch_site == "none";
  if (!own_origin || !own_site) return {403, "text/plain; charset=utf-8", "other sites are not answered\n"};
  const std::string_view target = request.target;
  const std::size_t length = token_.size();
  if (target.size() < length + 2 || target[0] != '/' || target[length + 1] != '/' ||
      !same_secret(target.substr(1, length), token_))
    return {404, "text/plain; charset=utf-8", "not found; open the address that foamsim view has printed\n"};
  return {};
}

std::string RequestCheck::path(const WebRequest& request) const {
  const std::string behind = request.target.substr(token_.size() + 2);
  return behind.substr(0, behind.find('?'));
}

}  // namespace foamsim::web
