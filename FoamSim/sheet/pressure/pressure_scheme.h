#pragma once

#include <vector>

#include "Base/options/option_set.h"
#include "Base/registry/registry.h"
#include "FoamSim/sheet/circulation.h"
#include "FoamSim/sheet/surface_geometry.h"

namespace foamsim {

/// What the pressures of a step are made from: the surface as it is, its circulation, and the films' tension.
struct PressureInput {
  const lostopos::SurfaceMesh& mesh;
  const SurfaceGeometry& geometry;  ///< of the mesh's present positions
  const CirculationField& circulation;
  double sigma;  ///< tension of one film side over density, L³/T²
};

/// One value P_v^r per (vertex, region), in the order of SurfaceGeometry's entries. Circulation grows by their jumps:
/// dΓ_v^{pq}/dt = coefficient (P_v^p − P_v^q).
struct Pressures {
  std::vector<double> values;
  double coefficient = 1;  ///< so that coefficient × value is L²/T²

  /// P_v^r; 0 where r is not at v.
  double at(const SurfaceGeometry& geometry, lostopos::Vertex v, lostopos::Region r) const;
};

/// What drives circulation: maps the surface to a pressure per (vertex, region). `edge_angle` is the one of Da et al.
/// 2015 with the area strategies of Fei et al. 2019.
class PressureScheme {
 public:
  PressureScheme() = default;
  PressureScheme(const PressureScheme&) = delete;
  PressureScheme& operator=(const PressureScheme&) = delete;
  virtual ~PressureScheme() = default;
  /// Overwrites `pressures`, whose memory is used again from step to step. Same bits for any number of threads.
  virtual void evaluate(const PressureInput& input, Pressures& pressures) = 0;
};

}  // namespace foamsim
