#pragma once

#include <string>
#include <string_view>

namespace foamsim::web {

/// The viewer (web/, bundled into one page) of this build; empty where it was built without.
std::string_view viewer_page();

/// The same. Throws base::InputError that says what is missing where it was built without.
std::string_view require_viewer_page();

/// A page cut where its data belongs: what stands before and behind the mark `<!-- run -->`, with the title in place.
/// Throws base::InputError for a page without the mark.
struct PageParts {
  std::string before, behind;
};
PageParts split_page(std::string_view page, const std::string& title);

}  // namespace foamsim::web
