#include "LosTopos/mesh/attribute.h"

namespace lostopos {

void AttributeRegistry::resize(std::size_t slots) {
  slots_ = slots;
  for (AttributeColumn* column : columns_) column->resize(slots);
}

void AttributeRegistry::reset(std::size_t slot) {
  for (AttributeColumn* column : columns_) column->reset(slot);
}

void AttributeRegistry::gather(std::span<const std::uint32_t> old_slot_of_new) {
  slots_ = old_slot_of_new.size();
  for (AttributeColumn* column : columns_) column->gather(old_slot_of_new);
}

std::size_t AttributeRegistry::memory_bytes() const {
  std::size_t bytes = columns_.capacity() * sizeof(AttributeColumn*);
  for (const AttributeColumn* column : columns_) bytes += column->memory_bytes();
  return bytes;
}

}  // namespace lostopos
