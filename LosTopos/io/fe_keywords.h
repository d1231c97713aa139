#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "LosTopos/io/fe_text.h"

namespace lostopos {

/// The parts of a datafile, in their order.
enum class FeSection { head, vertices, edges, facets, bodies };

/// The part that the keyword (in small letters) begins.
std::optional<FeSection> fe_section(std::string_view keyword);
/// One of its elements, in words.
std::string_view fe_element(FeSection section);

/// Whether the keyword (in small letters) begins a declaration in the head, one that is passed over or refused.
bool is_fe_declaration(std::string_view keyword);
/// Passes over the declaration of that keyword, up to the end of its line. Throws InputError for one that makes a
/// surface of another kind than those here, and one that is not known.
void pass_fe_declaration(FeText& text, std::string_view keyword);

/// What of an element's attributes says something of a surface here.
enum class FeAttribute { none, fixed, tension, front_body, back_body, original };

/// Which of these the keyword (in small letters) is for that section's elements. One that says nothing is passed over
/// with its value: none. Throws InputError for what no element here can have, and for what is not known.
FeAttribute take_fe_attribute(FeText& text, FeSection section, std::string_view keyword);

}  // namespace lostopos
