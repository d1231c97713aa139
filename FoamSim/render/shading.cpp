#include "FoamSim/render/shading.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace foamsim::render {
namespace {

using Eigen::Vector3f;

constexpr float kFar = std::numeric_limits<float>::infinity();
// Light through so many films that less than this is left is not followed further.
constexpr float kNegligible = 0.003f;
// Bounds that keep the cost of a ray through a foam of thousands of bubbles in proportion to what can be seen: films on
// an eye ray, films on it that mirror other films (the rest mirror the studio only), films on a mirrored ray.
constexpr std::size_t kMostFilms = 96;
constexpr int kMostMirrors = 3;
constexpr std::size_t kMostMirrored = 4;
// Films that mirror less than this part of the light mirror the studio only.
constexpr float kLeastMirrored = 0.01f;
// Shading never looks along a film more flatly than this: interpolated normals can even turn away from the viewer.
constexpr float kSmallestCosine = 0.02f;

float tube_radius(const FilmMesh& mesh, const RenderOptions& options) {
  return std::min(static_cast<float>(options.tube_radius), 0.3f * mesh.mean_edge);
}

float thinnest_line_of(const FilmMesh& mesh, const RenderOptions& options) {
  if (options.wireframe) return 0;
  const float tube = 2 * tube_radius(mesh, options);
  return tube > 0 ? tube : kFar;
}

}  // namespace

Shader::Shader(const FilmMesh& mesh, const CameraAxes& axes, const RenderOptions& options, float pixel_angle)
    : mesh_(mesh),
      options_(options),
      pixel_angle_(pixel_angle),
      thinnest_line_(thinnest_line_of(mesh, options)),
      scene_(mesh, tube_radius(mesh, options), options.boundary_tubes ? tube_radius(mesh, options) : 0),
      environment_(axes, options.background == Background::white ? 0.6f : 1.0f),
      thickness_(options.film_thickness, options.thickness_variation, axes.up.cast<float>()),
      colors_(thickness_.max()),
      color_density_(static_cast<float>(-std::log1p(-options.color_opacity))),
      tube_color_(options.background == Background::dark ? Vector3f(0.55f, 0.72f, 0.90f)
                                                         : Vector3f(0.30f, 0.40f, 0.52f)) {}

Light Shader::eye_light(const Ray& ray, Scratch& scratch) const {
  Light light;
  const std::optional<TubeHit> tube = scene_.first_tube(ray);
  scene_.films(ray, 0, tube ? tube->distance : kFar, kMostFilms, scratch[0]);
  int mirrors = options_.interreflection ? kMostMirrors : 0;
  float line_opacity = 0.6f;
  for (const FilmHit& hit : scratch[0]) {
    if (light.transmitted.maxCoeff() < kNegligible) return light;
    if (options_.wireframe && on_line(hit)) {
      const bool dark = options_.background == Background::white;
      light.added += line_opacity * light.transmitted * (dark ? 0.05f : 0.75f);
      light.transmitted *= 1 - line_opacity;
    }
    line_opacity *= 0.3f;  // layers further back are drawn more faintly, or their lines would be a thicket
    cross_film(ray, hit, Seen::directly, light, mirrors-- > 0 ? &scratch[1] : nullptr);
  }
  if (tube) {
    light.added += light.transmitted.cwiseProduct(tube_light(ray, *tube));
    light.transmitted.setZero();
  }
  return light;
}

Shader::FilmPoint Shader::film_point(const Ray& ray, const FilmHit& hit) const {
  const auto& corners = mesh_.corner_normals[hit.triangle];
  const Vector3f& face = mesh_.face_normals[hit.triangle];
  const float side = ray.direction.dot(face) > 0 ? -1.0f : 1.0f;
  const Vector3f viewer = -ray.direction;
  FilmPoint p;
  p.position = ray.origin + hit.distance * ray.direction;
  p.normal = side * ((1 - hit.u - hit.v) * corners[0] + hit.u * corners[1] + hit.v * corners[2]);
  const float length = p.normal.norm();
  p.normal = length > 0 ? Vector3f(p.normal / length) : Vector3f(side * face);
  p.cosine = p.normal.dot(viewer);
  if (p.cosine < kSmallestCosine) {
    p.normal = (p.normal + (kSmallestCosine - p.cosine) * viewer).normalized();
    p.cosine = std::max(p.normal.dot(viewer), kSmallestCosine);
  }
  p.reflected = (2 * p.normal.dot(viewer) * p.normal - viewer).normalized();
  p.above = side * p.reflected.dot(face) > 0;
  return p;
}

Vector3f Shader::film_reflectance_at(const FilmPoint& p, std::uint32_t triangle, Seen seen) const {
  const float thickness = seen == Seen::directly ? thickness_(p.position, mesh_.films[triangle])
                                                 : static_cast<float>(options_.film_thickness);
  const Vector3f physical = colors_.reflectance(p.cosine, thickness);
  const Vector3f grey = Vector3f::Constant(physical.mean());
  return grey + static_cast<float>(options_.iridescence) * (physical - grey);
}

// Adds one film to the light: it reflects R, its haze scatters a little, the rest goes through.
void Shader::cross_film(const Ray& ray, const FilmHit& hit, Seen seen, Light& light,
                        std::vector<FilmHit>* bounce) const {
  const FilmPoint p = film_point(ray, hit);
  const Vector3f reflectance = film_reflectance_at(p, hit.triangle, seen);
  const Vector3f weight = light.transmitted.cwiseProduct(reflectance);
  const bool follow = bounce != nullptr && p.above && weight.maxCoeff() > kLeastMirrored;
  const Vector3f mirrored = follow ? reflected_light(p, *bounce) : environment_.radiance(p.reflected);
  light.added += weight.cwiseProduct(mirrored);
  light.transmitted -= weight;
  add_haze(p, hit, light);
}

void Shader::add_haze(const FilmPoint& p, const FilmHit& hit, Light& light) const {
  Vector3f tint(0.72f, 0.86f, 1.0f);
  float density = static_cast<float>(options_.film_density);
  if (!mesh_.corner_colors.empty()) {
    const auto& corners = mesh_.corner_colors[hit.triangle];
    constexpr float bright = 1.6f;  // the studio lights a matt surface with about 1 over this
    tint = bright * ((1 - hit.u - hit.v) * corners[0] + hit.u * corners[1] + hit.v * corners[2]);
    density = color_density_;
  }
  const float haze = 1 - std::exp(-density / std::max(p.cosine, 0.08f));
  // Thin haze is lit from both sides.
  const Vector3f lit = 0.5f * (environment_.ambient(p.normal) + environment_.ambient(-p.normal));
  light.added += haze * light.transmitted.cwiseProduct(tint).cwiseProduct(lit);
  light.transmitted *= 1 - haze;
}

// Tubes are left out: their dark images in the films could be taken for borders that are not there.
Vector3f Shader::reflected_light(const FilmPoint& p, std::vector<FilmHit>& hits) const {
  constexpr float kOffset = 2e-5f;  // scene units: keeps the ray from meeting its own film's neighbouring triangles
  const Ray ray{p.position, p.reflected};
  scene_.films(ray, kOffset, kFar, kMostMirrored, hits);
  Light light;
  for (const FilmHit& hit : hits) cross_film(ray, hit, Seen::mirrored, light, nullptr);
  return light.added + light.transmitted.cwiseProduct(environment_.radiance(p.reflected));
}

// A Plateau border is liquid, a rim is wire: both glossy and dark enough to be seen as a line.
Vector3f Shader::tube_light(const Ray& ray, const TubeHit& hit) const {
  const float cosine = std::clamp(-hit.normal.dot(ray.direction), 0.0f, 1.0f);
  const Vector3f reflected = ray.direction + 2 * cosine * hit.normal;
  const bool border = hit.kind == TubeKind::border;
  const float facing = border ? 0.05f : 0.25f;
  const float fresnel = facing + (1 - facing) * std::pow(1 - cosine, 5.0f);  // Schlick
  const Vector3f color = border ? tube_color_ : Vector3f(0.16f, 0.15f, 0.14f);
  return (1 - fresnel) * color.cwiseProduct(environment_.ambient(hit.normal)) +
         fresnel * environment_.radiance(reflected.normalized());
}

bool Shader::on_line(const FilmHit& hit) const {
  const auto& c = mesh_.triangles[hit.triangle];
  const float half_width = 0.5f * static_cast<float>(options_.wireframe_width) * pixel_angle_ * hit.distance;
  const std::array<float, 3> weight{1 - hit.u - hit.v, hit.u, hit.v};
  for (int i = 0; i < 3; ++i) {
    // Distance to the side opposite corner i: its weight times the height over that side.
    const Vector3f& tip = mesh_.positions[c[i]];
    const Vector3f& a = mesh_.positions[c[(i + 1) % 3]];
    const Vector3f side = mesh_.positions[c[(i + 2) % 3]] - a;
    if (weight[i] * (tip - a).cross(side).norm() < half_width * side.norm()) return true;
  }
  return false;
}

}  // namespace foamsim::render
