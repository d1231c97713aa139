#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "LosTopos/mesh/handles.h"

namespace lostopos {

/// What the mesh asks of a column of data that has one value per element slot. Implemented by `Attribute`.
class AttributeColumn {
 public:
  AttributeColumn() = default;
  AttributeColumn(const AttributeColumn&) = delete;
  AttributeColumn& operator=(const AttributeColumn&) = delete;
  virtual ~AttributeColumn() = default;
  /// Makes room for `slots` elements in all; new ones get the default value.
  virtual void resize(std::size_t slots) = 0;
  /// Gives a slot that is taken into use again the default value.
  virtual void reset(std::size_t slot) = 0;
  /// Keeps slot `old_slot_of_new[i]` as slot i and drops the rest (compaction).
  virtual void gather(std::span<const std::uint32_t> old_slot_of_new) = 0;
  /// Bytes held on the heap.
  virtual std::size_t memory_bytes() const = 0;
};

/// The columns that follow one kind of element. The mesh owns it and shares it with the attributes, so that either may
/// be destroyed first.
class AttributeRegistry {
 public:
  std::size_t slots() const { return slots_; }
  void add(AttributeColumn* column) { columns_.push_back(column); }
  void remove(AttributeColumn* column) { std::erase(columns_, column); }
  void resize(std::size_t slots);
  void reset(std::size_t slot);
  void gather(std::span<const std::uint32_t> old_slot_of_new);
  std::size_t memory_bytes() const;

 private:
  std::vector<AttributeColumn*> columns_;
  std::size_t slots_ = 0;
};

/// One value of type T for every element of kind H of a mesh. It registers with the mesh, which grows, resets and
/// compacts it together with the elements; how a value is carried through a split, a collapse and so on is said once,
/// by an observer of the operations.
template <class H, class T>
class Attribute {
 public:
  /// `registry`: the mesh's, see SurfaceMesh::add_vertex_attribute; `initial`: the value of new elements.
  explicit Attribute(std::shared_ptr<AttributeRegistry> registry, T initial = T())
      : registry_(std::move(registry)), column_(std::make_unique<Column>(std::move(initial))) {
    column_->resize(registry_->slots());
    registry_->add(column_.get());
  }
  Attribute(Attribute&& other) noexcept = default;
  Attribute& operator=(Attribute&& other) noexcept {
    detach();
    registry_ = std::move(other.registry_);
    column_ = std::move(other.column_);
    return *this;
  }
  Attribute(const Attribute&) = delete;
  Attribute& operator=(const Attribute&) = delete;
  ~Attribute() { detach(); }

  T& operator[](H h) { return column_->values[h.index()]; }
  const T& operator[](H h) const { return column_->values[h.index()]; }
  /// All slots, dead ones included, indexed by handle index.
  std::span<T> slots() { return column_->values; }
  std::span<const T> slots() const { return column_->values; }

 private:
  struct Column final : AttributeColumn {
    explicit Column(T value) : initial(std::move(value)) {}
    void resize(std::size_t slots) override {
      if (slots > values.capacity()) values.reserve(std::max(slots, values.capacity() + values.capacity() / 2));
      values.resize(slots, initial);
    }
    void reset(std::size_t slot) override { values[slot] = initial; }
    void gather(std::span<const std::uint32_t> old_slot_of_new) override {
      std::vector<T> kept;
      kept.reserve(old_slot_of_new.size());
      for (std::uint32_t old : old_slot_of_new) kept.push_back(std::move(values[old]));
      values = std::move(kept);
    }
    std::size_t memory_bytes() const override { return values.capacity() * sizeof(T); }
    std::vector<T> values;
    T initial;
  };

  void detach() {
    if (registry_ && column_) registry_->remove(column_.get());
  }

  std::shared_ptr<AttributeRegistry> registry_;
  std::unique_ptr<Column> column_;
};

template <class T>
using VertexAttribute = Attribute<Vertex, T>;
template <class T>
using EdgeAttribute = Attribute<Edge, T>;
template <class T>
using TriangleAttribute = Attribute<Triangle, T>;

}  // namespace lostopos
