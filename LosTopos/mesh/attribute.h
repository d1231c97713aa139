#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "LosTopos/error.h"
#include "LosTopos/mesh/attribute_registry.h"
#include "LosTopos/mesh/carry_policy.h"
#include "LosTopos/mesh/handles.h"

namespace lostopos {

/// A column of values. `Base`: AttributeColumn or NamedAttributeColumn.
template <class T, class Base>
class ValueColumn : public Base {
 public:
  explicit ValueColumn(T value) : initial(std::move(value)) {}
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

/// One with a name.
template <class H, Storable T>
class NamedColumn final : public ValueColumn<T, NamedAttributeColumn> {
 public:
  using Codec = AttributeCodec<T>;

  NamedColumn(std::string name, std::unique_ptr<CarryPolicy<H, T>> policy, T initial)
      : ValueColumn<T, NamedAttributeColumn>(std::move(initial)), name_(std::move(name)), policy_(std::move(policy)) {
    policy_->bind(this->values);
  }
  const std::string& name() const override { return name_; }
  OperationObserver& policy() override { return *policy_; }
  void save(std::unique_ptr<StoredValues>& stored) const override {
    auto* fitting = dynamic_cast<StoredVector<T>*>(stored.get());
    if (fitting == nullptr) {
      auto made = std::make_unique<StoredVector<T>>();
      fitting = made.get();
      stored = std::move(made);
    }
    fitting->values = this->values;
  }
  void load(const StoredValues& stored) override {
    if (stored.size() != this->values.size())
      throw MeshError("attribute '" + name_ + "': " + std::to_string(stored.size()) + " stored values for " +
                      std::to_string(this->values.size()) + " slots");
    if (const auto* same = dynamic_cast<const StoredVector<T>*>(&stored)) {
      this->values = same->values;
      return;
    }
    const auto* encoded = dynamic_cast<const EncodedValues*>(&stored);
    auto decoded = encoded != nullptr && encoded->type() == Codec::type() ? Codec::decode(encoded->bytes())
                                                                          : std::optional<std::vector<T>>();
    if (!decoded || decoded->size() != this->values.size())
      throw MeshError("attribute '" + name_ + "' has values of type " + Codec::type() +
                      "; those stored under its name are of type " + stored.type() + " or damaged");
    this->values = std::move(*decoded);
  }
  void reset_all() override { std::ranges::fill(this->values, this->initial); }
  int components() const override { return Codec::components; }
  double number(std::size_t slot, int component) const override {
    if constexpr (Codec::components > 0)
      return Codec::number(this->values[slot], component);
    else
      return 0;
  }

 private:
  std::string name_;
  std::unique_ptr<CarryPolicy<H, T>> policy_;
};

/// One value of type T for every element of kind H of a mesh. It registers with the mesh, which grows, resets and
/// compacts it together with the elements. With a name it is also carried through the operations by its policy, is part
/// of the mesh's state and of what is written; without, it is working memory, and says nothing of elements that an
/// operation has made.
template <class H, class T>
class Attribute {
 public:
  /// `registry`: the mesh's, see SurfaceMesh::add_vertex_attribute; `initial`: the value of new elements.
  explicit Attribute(std::shared_ptr<AttributeRegistry> registry, T initial = T()) : registry_(std::move(registry)) {
    adopt(std::make_unique<ValueColumn<T, AttributeColumn>>(std::move(initial)));
    registry_->add(column_.get());
  }
  Attribute(std::shared_ptr<AttributeRegistry> registry, std::string name, std::unique_ptr<CarryPolicy<H, T>> policy,
            T initial)
      : registry_(std::move(registry)) {
    auto column = std::make_unique<NamedColumn<H, T>>(std::move(name), std::move(policy), std::move(initial));
    named_ = column.get();
    adopt(std::move(column));
    registry_->add_named(named_);
  }
  Attribute(Attribute&& other) noexcept = default;
  Attribute& operator=(Attribute&& other) noexcept {
    detach();
    registry_ = std::move(other.registry_);
    column_ = std::move(other.column_);
    values_ = other.values_;
    named_ = other.named_;
    return *this;
  }
  Attribute(const Attribute&) = delete;
  Attribute& operator=(const Attribute&) = delete;
  ~Attribute() { detach(); }

  T& operator[](H h) { return (*values_)[h.index()]; }
  const T& operator[](H h) const { return (*values_)[h.index()]; }
  /// All slots, dead ones included, indexed by handle index.
  std::span<T> slots() { return *values_; }
  std::span<const T> slots() const { return *values_; }

  /// Ends this attribute, but lets its values wait in the mesh for the next one of its name, as long as no element is
  /// added or compacted. Only for one with a name.
  void leave() && {
    if (named_ == nullptr) throw MeshError("an attribute without a name has nothing to wait under");
    registry_->leave(named_);
    column_.reset();
  }

 private:
  template <class Column>
  void adopt(std::unique_ptr<Column> column) {
    column->resize(registry_->slots());
    values_ = &column->values;
    column_ = std::move(column);
  }
  void detach() {
    if (registry_ && column_) registry_->remove(column_.get());
  }

  std::shared_ptr<AttributeRegistry> registry_;
  std::unique_ptr<AttributeColumn> column_;
  std::vector<T>* values_ = nullptr;
  NamedAttributeColumn* named_ = nullptr;  // the column, where it has a name
};

template <class T>
using VertexAttribute = Attribute<Vertex, T>;
template <class T>
using EdgeAttribute = Attribute<Edge, T>;
template <class T>
using TriangleAttribute = Attribute<Triangle, T>;

}  // namespace lostopos
