#include "LosTopos/remeshing/refusal.h"

namespace lostopos {

const char* name(Refusal refusal) {
  switch (refusal) {
    case Refusal::held:
      return "held";
    case Refusal::junction_topology:
      return "junction topology";
    case Refusal::link_condition:
      return "link condition";
    case Refusal::labels:
      return "labels";
    case Refusal::small_angle:
      return "small angle";
    case Refusal::large_angle:
      return "large angle";
    case Refusal::small_area:
      return "small area";
    case Refusal::long_edge:
      return "long edge";
    case Refusal::inverted_normal:
      return "inverted normal";
    case Refusal::volume_change:
      return "volume change";
    case Refusal::intersection:
      return "intersection";
    case Refusal::not_better:
      return "not better";
    case Refusal::ambiguous:
      return "ambiguous";
  }
  return "unknown refusal";
}

}  // namespace lostopos
