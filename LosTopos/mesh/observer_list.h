#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "LosTopos/mesh/operation_events.h"

namespace lostopos {

/// Removes an observer where it ends; may outlive the list. Made by ObserverList::add.
class ObserverToken {
 public:
  using List = std::vector<OperationObserver*>;

  ObserverToken() = default;
  ObserverToken(const std::shared_ptr<List>& list, OperationObserver* observer) : list_(list), observer_(observer) {}
  ObserverToken(ObserverToken&& other) noexcept
      : list_(std::move(other.list_)), observer_(std::exchange(other.observer_, nullptr)) {}
  ObserverToken& operator=(ObserverToken&& other) noexcept {
    remove();
    list_ = std::move(other.list_);
    observer_ = std::exchange(other.observer_, nullptr);
    return *this;
  }
  ObserverToken(const ObserverToken&) = delete;
  ObserverToken& operator=(const ObserverToken&) = delete;
  ~ObserverToken() { remove(); }

  /// Before its time.
  void remove() {
    const auto list = list_.lock();
    if (list && observer_ != nullptr)
      if (const auto found = std::ranges::find(*list, observer_); found != list->end()) list->erase(found);
    observer_ = nullptr;
  }

 private:
  std::weak_ptr<List> list_;
  OperationObserver* observer_ = nullptr;
};

/// The observers of a surface, in the order in which they came.
class ObserverList {
 public:
  /// `observer` is told until the token ends.
  [[nodiscard]] ObserverToken add(OperationObserver& observer) {
    list_->push_back(&observer);
    return {list_, &observer};
  }
  const std::vector<OperationObserver*>& observers() const { return *list_; }

 private:
  std::shared_ptr<std::vector<OperationObserver*>> list_ = std::make_shared<std::vector<OperationObserver*>>();
};

}  // namespace lostopos
