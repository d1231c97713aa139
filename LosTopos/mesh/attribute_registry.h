#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "LosTopos/mesh/attribute_state.h"
#include "LosTopos/mesh/operation_events.h"

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

/// A column with a name: it is carried through operations, saved and written.
class NamedAttributeColumn : public AttributeColumn {
 public:
  virtual const std::string& name() const = 0;
  /// What carries the values.
  virtual OperationObserver& policy() = 0;
  /// Copies the values into `stored`, reusing what is there where it fits.
  virtual void save(std::unique_ptr<StoredValues>& stored) const = 0;
  /// Throws MeshError when they are not of this column's type and number.
  virtual void load(const StoredValues& stored) = 0;
  /// Gives all slots the default value.
  virtual void reset_all() = 0;
  /// Numbers a value has, see AttributeCodec; 0: it is none.
  virtual int components() const = 0;
  virtual double number(std::size_t slot, int component) const = 0;
};

/// The columns that follow one kind of element. The mesh owns it and shares it with the attributes, so that either may
/// be destroyed first.
class AttributeRegistry {
 public:
  std::size_t slots() const { return slots_; }
  void add(AttributeColumn* column) { columns_.push_back(column); }
  /// A named column takes the values that wait under its name. Throws MeshError when there is one of this name, and
  /// what NamedAttributeColumn::load throws.
  void add_named(NamedAttributeColumn* column);
  void remove(AttributeColumn* column);
  /// Removes the column and lets its values wait.
  void leave(NamedAttributeColumn* column);
  void resize(std::size_t slots);
  void reset(std::size_t slot);
  void gather(std::span<const std::uint32_t> old_slot_of_new);
  std::size_t memory_bytes() const;
  /// In the order in which they were added.
  std::span<NamedAttributeColumn* const> named() const { return named_; }

  /// The values of all named columns, and those that wait.
  void save(std::vector<StoredAttribute>& stored) const;
  /// Puts them back for elements in `slots` slots. Named columns of which nothing was saved get their default values;
  /// values without a column wait.
  void restore(const std::vector<StoredAttribute>& stored, std::size_t slots);

  template <class Event>
  void carry(void (OperationObserver::*hook)(const SurfaceMesh&, const Event&), const SurfaceMesh& mesh,
             const Event& event) const {
    for (NamedAttributeColumn* column : named_) (column->policy().*hook)(mesh, event);
  }

 private:
  std::vector<AttributeColumn*> columns_;     // all
  std::vector<NamedAttributeColumn*> named_;  // those of them that have a name
  std::vector<StoredAttribute> waiting_;      // of the elements as they are: no edit of the mesh carries them
  std::size_t slots_ = 0;
};

}  // namespace lostopos
