#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "FoamSim/render/environment.h"
#include "FoamSim/render/film_mesh.h"
#include "FoamSim/render/film_optics.h"
#include "FoamSim/render/ray_scene.h"
#include "FoamSim/render/render.h"
#include "FoamSim/render/thickness.h"

namespace foamsim::render {

/// Light that arrives along a ray: what films and tubes add, and the part of the background that they let through.
struct Light {
  Eigen::Vector3f added = Eigen::Vector3f::Zero();
  Eigen::Vector3f transmitted = Eigen::Vector3f::Ones();
};

/// Follows rays through the films.
class Shader {
 public:
  /// Buffers for one thread: one list of hits for the eye ray, one for the reflected ray.
  using Scratch = std::array<std::vector<FilmHit>, 2>;

  /// @param pixel_angle  size of a pixel at distance 1.
  Shader(const FilmMesh& mesh, const CameraAxes& axes, const RenderOptions& options, float pixel_angle);

  /// Light along a ray from the eye, without the background.
  Light eye_light(const Ray& ray, Scratch& scratch) const;

  /// Width of the thinnest lines that it draws, tubes or triangles' edges, scene units; infinite without lines.
  float thinnest_line() const { return thinnest_line_; }

 private:
  struct FilmPoint {
    Eigen::Vector3f position;
    Eigen::Vector3f normal;  // shading normal, towards the viewer
    float cosine;            // between normal and viewer
    Eigen::Vector3f reflected;
    bool above;  // the reflected ray stays on the viewer's side of the triangle
  };

  FilmPoint film_point(const Ray& ray, const FilmHit& hit) const;
  // Whether a film is seen by the eye, or in another film, where it has the mean thickness everywhere.
  enum class Seen { directly, mirrored };

  Eigen::Vector3f film_reflectance_at(const FilmPoint& p, std::uint32_t triangle, Seen seen) const;
  void cross_film(const Ray& ray, const FilmHit& hit, Seen seen, Light& light, std::vector<FilmHit>* bounce) const;
  void add_haze(const FilmPoint& p, const FilmHit& hit, Light& light) const;
  Eigen::Vector3f reflected_light(const FilmPoint& p, std::vector<FilmHit>& hits) const;
  Eigen::Vector3f tube_light(const Ray& ray, const TubeHit& hit) const;
  bool on_line(const FilmHit& hit) const;

  const FilmMesh& mesh_;
  const RenderOptions& options_;
  float pixel_angle_;
  float thinnest_line_;
  RayScene scene_;
  Environment environment_;
  ThicknessField thickness_;
  FilmColorTable colors_;
  float color_density_;         // optical depth of a coloured film
  Eigen::Vector3f tube_color_;  // stands out from the backdrop
};

}  // namespace foamsim::render
