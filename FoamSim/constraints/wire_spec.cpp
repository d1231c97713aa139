#include "FoamSim/constraints/wire_spec.h"

#include <algorithm>
#include <cmath>

#include "Base/error.h"
#include "Base/io/number_text.h"
#include "Base/names/words.h"

namespace foamsim {

using lostopos::Vec3;

namespace {

std::string_view selection_part(std::string_view text) {
  const auto colon = text.find(':');
  if (colon == std::string_view::npos)
    throw base::InputError("the wire '" + std::string(text) +
                           "' has no motion; a wire is 'SELECTION: MOTION', as in 'held and x < 0: move -0.08 0 0'");
  return text.substr(0, colon);
}

// Takes a motion apart from left to right.
class MotionReader {
 public:
  explicit MotionReader(std::string_view wire) : wire_(wire), words_(base::words_of(wire.substr(wire.find(':') + 1))) {}

  WireMotion read() {
    WireMotion motion;
    const std::string kind = at_end() ? "" : next();
    if (kind == "move") {
      motion.kind = WireMotion::Kind::move;
      motion.velocity = vector();
    } else if (kind == "pull") {
      motion.kind = WireMotion::Kind::pull;
      motion.speed = number();
      if (take("along")) motion.axis = axis();
    } else if (kind != "still") {
      fail("no motion is called '" + kind + "'");
    }
    while (!at_end()) read_time(motion);
    if (!(motion.until > motion.from)) fail("it ends before it begins");
    return motion;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw base::InputError("the motion of the wire '" + std::string(wire_) + "' cannot be read: " + why +
                           "; it is 'still', 'move VX VY VZ' or 'pull SPEED [along AX AY AZ]', then where wanted "
                           "'from T' and 'until T'");
  }
  void read_time(WireMotion& motion) {
    const std::string word = next();
    if (word != "from" && word != "until") fail("'" + word + "' is not expected there");
    (word == "from" ? motion.from : motion.until) = number();
  }
  bool at_end() const { return place_ == words_.size(); }
  const std::string& next() {
    if (at_end()) fail("something is missing at its end");
    return words_[place_++];
  }
  bool take(std::string_view word) {
    if (at_end() || words_[place_] != word) return false;
    ++place_;
    return true;
  }
  double number() {
    const std::string& word = next();
    const auto value = base::parse_double(word);
    if (!value || !std::isfinite(*value)) fail("'" + word + "' is not a number");
    return *value;
  }
  Vec3 vector() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  Vec3 axis() {
    for (int i = 0; i < 3; ++i)
      if (take(std::string(1, "xyz"[i]))) return Vec3::Unit(i);
    const Vec3 given = vector();
    if (!(given.norm() > 0)) fail("an axis needs a length");
    return given.normalized();
  }

  std::string_view wire_;
  std::vector<std::string> words_;
  std::size_t place_ = 0;
};

void append_vector(std::string& text, const Vec3& v) {
  for (int i = 0; i < 3; ++i) {
    text += ' ';
    base::append_number(text, v[i]);
  }
}

}  // namespace

Vec3 WireMotion::displacement(const Vec3& its_velocity, double start, double end) const {
  const double acting = std::min(end, until) - std::max(start, from);
  return acting > 0 ? Vec3(acting * its_velocity) : Vec3(Vec3::Zero());
}

WireSpec::WireSpec(std::string_view text) : selection(selection_part(text)), motion(MotionReader(text).read()) {}

std::string WireSpec::text() const {
  std::string text = selection.text() + ": ";
  if (motion.kind == WireMotion::Kind::still) text += "still";
  if (motion.kind == WireMotion::Kind::move) {
    text += "move";
    append_vector(text, motion.velocity);
  }
  if (motion.kind == WireMotion::Kind::pull) {
    text += "pull ";
    base::append_number(text, motion.speed);
    if (motion.axis) {
      text += " along";
      append_vector(text, *motion.axis);
    }
  }
  if (motion.from > 0) {
    text += " from ";
    base::append_number(text, motion.from);
  }
  if (std::isfinite(motion.until)) {
    text += " until ";
    base::append_number(text, motion.until);
  }
  return text;
}

}  // namespace foamsim
