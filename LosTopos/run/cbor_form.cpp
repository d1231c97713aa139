#include "LosTopos/run/cbor_form.h"

#include <vector>

namespace lostopos::run {
namespace {

constexpr std::size_t deepest = 32;

enum Major : unsigned { whole, negative, binary, text, list, object, tag, simple };

class CborForm {
 public:
  explicit CborForm(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool is_plain() {
    std::vector<std::uint64_t> left{1};  // values that are to come, from the outermost list to the innermost
    while (!left.empty()) {
      if (left.back() == 0) {
        left.pop_back();
        continue;
      }
      --left.back();
      std::uint64_t within = 0;
      if (!take_value(within)) return false;
      if (within > 0) left.push_back(within);
      if (left.size() > deepest) return false;
    }
    return next_ == bytes_.size();
  }

 private:
  std::size_t rest() const { return bytes_.size() - next_; }

  // A value's head, and its bytes where it has some; `within`: the values that it is made of.
  bool take_value(std::uint64_t& within) {
    if (rest() == 0) return false;
    const unsigned head = bytes_[next_++], major = head >> 5U, info = head & 31U;
    std::uint64_t argument = 0;
    if (!take_argument(info, argument)) return false;
    switch (major) {
      case whole:
      case negative:
        return true;
      case binary:
      case text:
        if (argument > rest()) return false;
        next_ += argument;
        return true;
      case list:
        within = argument;
        return argument <= rest();
      case object:
        within = 2 * argument;
        return argument <= rest() / 2;
      case simple:  // false, true, null, and numbers of three lengths
        return info >= 20 && info <= 27 && info != 23 && info != 24;
      default:
        return false;
    }
  }

  bool take_argument(unsigned info, std::uint64_t& argument) {
    if (info < 24) {
      argument = info;
      return true;
    }
    if (info > 27) return false;
    const std::size_t length = std::size_t{1} << (info - 24);
    if (length > rest()) return false;
    for (std::size_t i = 0; i < length; ++i) argument = argument << 8U | bytes_[next_++];
    return true;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

}  // namespace

bool is_plain_cbor(std::span<const std::uint8_t> bytes) {
  return CborForm(bytes).is_plain();
}

}  // namespace lostopos::run
