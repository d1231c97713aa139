#include "FoamSim/web/viewer_page.h"

#include "Base/error.h"

namespace foamsim::web {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string_view require_viewer_page() {
  if (viewer_page().empty())
    throw base::InputError(
        "this program was built without the viewer; it is made where nodejs and npm are installed and 'npm ci' has "
        "been run in web/ (install-deps.sh does both), and the program is built again");
  return viewer_page();
}

PageParts split_page(std::string_view page, const std::string& title) {
  constexpr std::string_view mark = "<!-- run -->", title_mark = "<!-- title -->";
  const std::size_t at = page.find(mark);
  if (at == std::string_view::npos) throw base::InputError("the viewer's page has no place for a run");
  PageParts parts{std::string(page.substr(0, at)), std::string(page.substr(at + mark.size()))};
  if (const std::size_t head = parts.before.find(title_mark); head != std::string::npos)
    parts.before.replace(head, title_mark.size(), escaped(title));
  return parts;
}

}  // namespace foamsim::web
