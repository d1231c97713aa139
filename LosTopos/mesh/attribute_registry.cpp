#include "LosTopos/mesh/attribute_registry.h"

#include <algorithm>

#include "LosTopos/error.h"

namespace lostopos {

void AttributeRegistry::add_named(NamedAttributeColumn* column) {
  const auto has_its_name = [column](const NamedAttributeColumn* other) { return other->name() == column->name(); };
  if (std::ranges::any_of(named_, has_its_name))
    throw MeshError("the mesh has an attribute '" + column->name() + "' already; choose another name");
  const auto found = std::ranges::find(waiting_, column->name(), &StoredAttribute::name);
  if (found != waiting_.end()) {
    column->load(*found->values);
    waiting_.erase(found);
  }
  columns_.push_back(column);
  named_.push_back(column);
}

void AttributeRegistry::remove(AttributeColumn* column) {
  std::erase(columns_, column);
  std::erase_if(named_, [column](const NamedAttributeColumn* other) { return other == column; });
}

void AttributeRegistry::leave(NamedAttributeColumn* column) {
  remove(column);
  std::unique_ptr<StoredValues> values;
  column->save(values);
  waiting_.emplace_back(column->name(), std::move(values));
}

void AttributeRegistry::resize(std::size_t slots) {
  slots_ = slots;
  waiting_.clear();
  for (AttributeColumn* column : columns_) column->resize(slots);
}

void AttributeRegistry::reset(std::size_t slot) {
  waiting_.clear();
  for (AttributeColumn* column : columns_) column->reset(slot);
}

void AttributeRegistry::gather(std::span<const std::uint32_t> old_slot_of_new) {
  slots_ = old_slot_of_new.size();
  waiting_.clear();
  for (AttributeColumn* column : columns_) column->gather(old_slot_of_new);
}

std::size_t AttributeRegistry::memory_bytes() const {
  std::size_t bytes = (columns_.capacity() + named_.capacity()) * sizeof(void*);
  for (const AttributeColumn* column : columns_) bytes += column->memory_bytes();
  for (const StoredAttribute& attribute : waiting_) bytes += attribute.values->memory_bytes();
  return bytes;
}

void AttributeRegistry::save(std::vector<StoredAttribute>& stored) const {
  stored.resize(named_.size());
  for (std::size_t i = 0; i < named_.size(); ++i) {
    stored[i].name = named_[i]->name();
    named_[i]->save(stored[i].values);
  }
  stored.insert(stored.end(), waiting_.begin(), waiting_.end());
}

void AttributeRegistry::restore(const std::vector<StoredAttribute>& stored, std::size_t slots) {
  resize(slots);
  for (NamedAttributeColumn* column : named_) {
    const auto found = std::ranges::find(stored, column->name(), &StoredAttribute::name);
    if (found != stored.end())
      column->load(*found->values);
    else
      column->reset_all();
  }
  for (const StoredAttribute& attribute : stored)
    if (std::ranges::find(named_, attribute.name, &NamedAttributeColumn::name) == named_.end())
      waiting_.push_back(attribute);
}

}  // namespace lostopos
