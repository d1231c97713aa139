#include "FoamSim/render/ray_scene.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>

#include "Base/error.h"
#include "FoamSim/render/smooth_lines.h"

namespace foamsim::render {
namespace {

using Eigen::Vector3f;

bool nearer(const FilmHit& a, const FilmHit& b) {
  return std::tie(a.distance, a.triangle) < std::tie(b.distance, b.triangle);
}

// What Embree hands to the filter; its context comes first so that a pointer to one is a pointer to the other.
struct CollectContext {
  RTCIntersectContext base;
  std::size_t most;
  std::vector<FilmHit>* hits;  // sorted
};

// Keeps the nearest hits. A refused hit lets the traversal go on unchanged; a hit that need not be kept is accepted,
// which tells Embree that nothing beyond it is wanted.
void collect(const RTCFilterFunctionNArguments* args) {
  auto* context = reinterpret_cast<CollectContext*>(args->context);
  std::vector<FilmHit>& hits = *context->hits;
  const FilmHit hit{RTCRayN_tfar(args->ray, args->N, 0), RTCHitN_primID(args->hit, args->N, 0),
                    RTCHitN_u(args->hit, args->N, 0), RTCHitN_v(args->hit, args->N, 0)};
  const bool full = hits.size() == context->most;
  if (full && !nearer(hit, hits.back())) return;
  if (full) hits.pop_back();
  hits.insert(std::upper_bound(hits.begin(), hits.end(), hit, nearer), hit);
  args->valid[0] = 0;
}

RTCRay embree_ray(const Ray& ray, float begin, float end) {
  RTCRay r{};
  r.org_x = ray.origin.x();
  r.org_y = ray.origin.y();
  r.org_z = ray.origin.z();
  r.dir_x = ray.direction.x();
  r.dir_y = ray.direction.y();
  r.dir_z = ray.direction.z();
  r.tnear = begin;
  r.tfar = end;
  r.mask = ~0u;
  return r;
}

void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE)
    throw base::Error("render: Embree failed with error " + std::to_string(static_cast<int>(error)) +
                      (error == RTC_ERROR_OUT_OF_MEMORY ? " (out of memory)" : ""));
}

bool share_vertex(const std::array<std::uint32_t, 3>& s, const std::array<std::uint32_t, 3>& t) {
  return std::any_of(s.begin(), s.end(), [&](std::uint32_t v) { return std::find(t.begin(), t.end(), v) != t.end(); });
}

}  // namespace

RayScene::RayScene(const FilmMesh& mesh, float border_radius, float rim_radius)
    : mesh_(mesh), device_(rtcNewDevice(nullptr)) {
  if (!device_) throw base::Error("render: Embree does not start on this machine");
  films_.reset(rtcNewScene(device_.get()));
  tubes_.reset(rtcNewScene(device_.get()));
  check(device_.get());
  rtcSetSceneFlags(films_.get(), RTC_SCENE_FLAG_ROBUST);
  if (!mesh.triangles.empty()) add_films();
  constexpr int parts = 4;  // of an edge: its pieces then bend by a few degrees
  add_tubes(smooth_lines(mesh.borders, parts), border_radius, TubeKind::border);
  add_tubes(smooth_lines(mesh.rims, parts), rim_radius, TubeKind::rim);
  // Built by one thread, always in the same order: so two tubes hit at exactly one distance are told apart the same way
  // every time. (Asking the device for one thread would instead limit the whole process while the device lives.)
  tbb::task_arena(1).execute([this] {
    rtcJoinCommitScene(films_.get());
    rtcJoinCommitScene(tubes_.get());
  });
  check(device_.get());
}

void RayScene::add_films() {
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                             3 * sizeof(float), mesh_.positions.size()));
  auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh_.triangles.size()));
  if (points != nullptr && corners != nullptr) {
    for (const Vector3f& x : mesh_.positions) points = std::copy_n(x.data(), 3, points);
    for (const auto& t : mesh_.triangles) corners = std::copy_n(t.data(), 3, corners);
    rtcSetGeometryIntersectFilterFunction(geometry, collect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(films_.get(), geometry);
  }
  rtcReleaseGeometry(geometry);
  check(device_.get());
}

void RayScene::add_tubes(const std::vector<Segment>& segments, float radius, TubeKind kind) {
  if (segments.empty() || !(radius > 0)) return;
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                                             4 * sizeof(float), 2 * segments.size()));
  auto* starts = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, sizeof(std::uint32_t), segments.size()));
  if (points != nullptr && starts != nullptr) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
      starts[i] = static_cast<std::uint32_t>(2 * i);
      for (const Vector3f& x : segments[i]) {
        points = std::copy_n(x.data(), 3, points);
        *points++ = radius;
      }
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(tubes_.get(), geometry, static_cast<unsigned>(kind));
    has_tubes_ = true;
  }
  rtcReleaseGeometry(geometry);
  check(device_.get());
}

void RayScene::films(const Ray& ray, float begin, float end, std::size_t most, std::vector<FilmHit>& hits) const {
  hits.clear();
  CollectContext context{};
  rtcInitIntersectContext(&context.base);
  context.most = most;
  context.hits = &hits;
  RTCRayHit query{};
  query.ray = embree_ray(ray, begin, end);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(films_.get(), &context.base, &query);
  remove_doubles(hits);
}

// A ray through an edge hits both its triangles at one place.
void RayScene::remove_doubles(std::vector<FilmHit>& hits) const {
  constexpr float kSamePlace = 4e-6f;  // scene units: some roundings of the distance, far below a pixel
  const auto doubled = [this](const FilmHit& a, const FilmHit& b) {
    return b.distance - a.distance <= kSamePlace * (1 + a.distance) &&
           share_vertex(mesh_.triangles[a.triangle], mesh_.triangles[b.triangle]);
  };
  hits.erase(std::unique(hits.begin(), hits.end(), doubled), hits.end());
}

std::optional<TubeHit> RayScene::first_tube(const Ray& ray) const {
  if (!has_tubes_) return std::nullopt;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray = embree_ray(ray, 0, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(tubes_.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Vector3f normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
  const float length = normal.norm();
  return TubeHit{query.ray.tfar, length > 0 ? Vector3f(normal / length) : Vector3f(-ray.direction),
                 static_cast<TubeKind>(query.hit.geomID)};
}

}  // namespace foamsim::render
