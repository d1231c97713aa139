#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

namespace lostopos {

/// Typed index of a mesh element. Handles of different kinds cannot be mixed; a default-made handle is invalid.
/// A handle stays good until its element is removed or the mesh is compacted.
template <class Tag>
class Handle {
 public:
  using Index = std::uint32_t;
  static constexpr Index invalid_index = std::numeric_limits<Index>::max();

  constexpr Handle() = default;
  constexpr explicit Handle(std::size_t index) : index_(static_cast<Index>(index)) {}

  constexpr Index index() const { return index_; }
  constexpr bool valid() const { return index_ != invalid_index; }
  constexpr auto operator<=>(const Handle&) const = default;

 private:
  Index index_ = invalid_index;
};

using Vertex = Handle<struct VertexTag>;
using Edge = Handle<struct EdgeTag>;
using Triangle = Handle<struct TriangleTag>;

/// A connected or unconnected part of space that the surface bounds; region 0 is the open air.
using Region = Handle<struct RegionTag>;
inline constexpr Region air{0};

/// The regions on a triangle's two sides: the right-hand normal of its vertices (a, b, c) points out of `p` into `q`.
struct Labels {
  Region p, q;
  constexpr bool has(Region r) const { return p == r || q == r; }
  constexpr Labels flipped() const { return {q, p}; }
  constexpr bool operator==(const Labels&) const = default;
};

}  // namespace lostopos

namespace std {

template <class Tag>
struct hash<lostopos::Handle<Tag>> {
  size_t operator()(lostopos::Handle<Tag> h) const noexcept { return h.index(); }
};

}  // namespace std
