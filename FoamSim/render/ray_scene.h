#pragma once

#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "FoamSim/render/film_mesh.h"

namespace foamsim::render {

struct Ray {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;  // unit
};

/// Where a ray crosses a film: distance, triangle of the `FilmMesh`, barycentric weights of its second and third
/// corner.
struct FilmHit {
  float distance;
  std::uint32_t triangle;
  float u, v;
};

enum class TubeKind { border, rim };

/// Where a ray first meets a tube.
struct TubeHit {
  float distance;
  Eigen::Vector3f normal;  // unit
  TubeKind kind;
};

/// Films and tubes in Embree scenes. All queries may run concurrently.
class RayScene {
 public:
  /// @param border_radius, rim_radius  scene units; 0: none. The mesh must outlive this.
  /// @throws base::Error  if Embree fails (out of memory).
  RayScene(const FilmMesh& mesh, float border_radius, float rim_radius);

  /// The films crossed between distances `begin` and `end`, nearest first, each crossing once even if it falls on an
  /// edge of the mesh. Replaces the contents of `hits` with at most `most` of them.
  void films(const Ray& ray, float begin, float end, std::size_t most, std::vector<FilmHit>& hits) const;

  std::optional<TubeHit> first_tube(const Ray& ray) const;

 private:
  struct Release {
    void operator()(RTCDevice d) const { rtcReleaseDevice(d); }
    void operator()(RTCScene s) const { rtcReleaseScene(s); }
  };
  template <class Handle>
  using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

  void add_films();
  void add_tubes(const std::vector<Segment>& segments, float radius, TubeKind kind);
  void remove_doubles(std::vector<FilmHit>& hits) const;

  const FilmMesh& mesh_;
  Owned<RTCDevice> device_;
  Owned<RTCScene> films_;
  Owned<RTCScene> tubes_;
  bool has_tubes_ = false;
};

}  // namespace foamsim::render
