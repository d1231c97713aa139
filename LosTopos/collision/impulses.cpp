#include "LosTopos/collision/impulses.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lostopos {

double relative_displacement(const Motion& motion, const Contact& contact) {
  double r = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    r += contact.weights[i] * contact.normal.dot(motion.displacement(contact.pair.vertices[i]));
  }
  return r;
}

namespace {

// An impulse moves no vertex farther than this many times what lacks. It matters only when held vertices carry nearly
// all the weight of a contact, and the leverage on the free ones would be without bound.
constexpr double largest_push = 4;

bool apply_impulse(Motion& motion, const Contact& contact) {
  const double lacking = contact.target - relative_displacement(motion, contact);
  if (!(lacking > 0)) return false;
  double mobility = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    mobility += contact.weights[i] * contact.weights[i] * motion.mobility(contact.pair.vertices[i], contact.normal);
  }
  if (mobility == 0) return false;
  double largest_weight = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!motion.held(contact.pair.vertices[i])) {
      largest_weight = std::max(largest_weight, std::abs(contact.weights[i]));
    }
  }
  const double impulse = std::min(lacking / mobility, largest_push * lacking / largest_weight);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vertex v = contact.pair.vertices[i];
    const double share = contact.weights[i] * motion.inverse_mass(v) * impulse;
    if (share != 0) motion.set_end(v, motion.ends()[v.index()] + share * contact.normal);
  }
  return true;
}

}  // namespace

std::size_t apply_impulses(Motion& motion, std::span<const Contact> contacts) {
  std::vector<Contact> by_time(contacts.begin(), contacts.end());
  std::ranges::stable_sort(by_time, {}, &Contact::time);
  std::size_t applied = 0;
  for (const Contact& contact : by_time) applied += apply_impulse(motion, contact) ? 1 : 0;
  return applied;
}

}  // namespace lostopos
