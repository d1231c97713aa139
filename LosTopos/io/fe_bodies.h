#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "LosTopos/io/fe_numbers.h"
#include "LosTopos/mesh/handles.h"

namespace lostopos {

/// The bodies of a datafile of Surface Evolver, from which facets get their labels. Memory grows with bodies and
/// facets, not with numbers.
class FeBodies {
 public:
  enum class Side : std::uint8_t { back, front };  ///< behind the facet's right-hand normal, or before it

  void add_facet() { sides_.push_back({none, none}); }
  /// The body of that number, 0 for none, is on that side of the facet. What is wrong with that; empty when nothing is.
  std::string add(std::uint32_t facet, Side side, std::int64_t body);
  /// There is a body of that number, which is that region; `line` is where, for messages.
  void declare(std::uint32_t number, std::uint32_t region, std::size_t line) {
    bodies_.push_back({number, region, line});
  }

  /// One pair a facet; `default_labels` where no facet has a body. Throws InputError, with the line in the file of that
  /// name, where bodies are the same or a facet's are none.
  std::vector<Labels> labels(const std::string& file, const FeNumbers& facets);

 private:
  static constexpr std::uint32_t none = 0;

  struct Body {
    std::uint32_t number, region;
    std::size_t line;
  };

  void require_different(const std::string& file, std::uint32_t Body::*what) const;
  Region region_of(std::uint32_t body, const std::string& file, std::size_t line) const;

  std::vector<std::array<std::uint32_t, 2>> sides_;  // by facet and Side: the body's number
  std::vector<Body> bodies_;
};

}  // namespace lostopos
